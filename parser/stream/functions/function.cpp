#include "parser/stream/functions/function.h"

#include "function/points/evaluate.h"
#include "parser/stream/expression.h"

#include <fmt/format.h>

#include <stdexcept>

namespace parser {
namespace {

function::Values ask_scene(TokenStream& stream, const function::FunctionPtr& called,
                           const std::vector<double>& arguments, const Token& name)
{
    std::optional<function::Values> answer;
    std::string refusal = "this function needs the scene's noise or textures, which cannot be asked here";
    try {
        answer = stream.hooks().evaluate(called, arguments.data());
    } catch (const std::runtime_error& error) {
        refusal = error.what();
    }
    if (!answer) stream.fail(stream.place(name), refusal);
    return *answer;
}

}  // namespace

Tuple call_function(TokenStream& stream, const function::FunctionPtr& called, const Token& name, int requested)
{
    const bool raw = stream.raw_operators();
    stream.set_raw_operators(false);
    if (!stream.accept(Kind::LeftParen))
        stream.fail_expected(fmt::format("'(' after the name of function {}", stream.word(name)));
    std::vector<double> arguments;
    for (std::uint32_t i = 0; i < called->parameters; ++i) {
        if (i > 0) stream.accept_comma();
        arguments.push_back(float_expr(stream));
    }
    if (!stream.accept(Kind::RightParen))
        stream.fail_expected(fmt::format("')' after {} arguments", called->parameters));
    stream.set_raw_operators(raw);
    function::Values value;
    if (called->asks_scene) {
        value = ask_scene(stream, called, arguments, name);
    } else {
        value = function::evaluate_all(*called, arguments.data(), function::no_host());
    }
    Tuple result;
    if (called->components == 1) {
        for (int i = 0; i < requested; ++i) result.at[static_cast<std::size_t>(i)] = value[0];
        result.count = requested;
        return result;
    }
    result.at = value;
    result.count = static_cast<int>(called->components);
    return result;
}

}  // namespace parser
