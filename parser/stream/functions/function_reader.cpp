#include "function/internal/internal.h"
#include "parser/stream/expression.h"
#include "parser/stream/functions/function.h"
#include "parser/stream/functions/function_body.h"

#include <fmt/format.h>

namespace parser {
namespace {

constexpr std::size_t kMostParameters = 56;

/// x and u are one variable, y and v another; of two parameters that name one the later counts.
void name_axes(std::map<std::string, BodyReader::Value>& names, const std::vector<std::string>& parameters)
{
    const std::pair<const char*, const char*> axes[] = {{"x", "u"}, {"y", "v"}};
    for (const auto& [first, second] : axes)
        for (std::uint32_t i = 0; i < parameters.size(); ++i)
            if (parameters[i] == first || parameters[i] == second) names[first] = names[second] = i;
}

std::vector<std::string> read_parameters(TokenStream& stream)
{
    std::vector<std::string> names;
    for (bool more = true; more; more = stream.accept_comma() || stream.peek().kind != Kind::RightParen) {
        const Token name = stream.next_name();
        const bool axis = name.kind == Kind::X || name.kind == Kind::Y || name.kind == Kind::Z ||
                          name.kind == Kind::U || name.kind == Kind::V;
        if (name.kind == Kind::Identifier && stream.value_of(name))
            stream.fail(stream.place(name),
                        fmt::format("a parameter cannot be called '{}': that is declared", stream.word(name)));
        if (!axis && name.kind != Kind::Identifier) stream.fail(stream.place(name), "expected a parameter's name");
        names.push_back(stream.word(name));
        if (names.size() > kMostParameters) stream.fail(stream.place(name), "a function has at most 56 parameters");
    }
    stream.next();
    return names;
}

function::FunctionPtr read_internal(TokenStream& stream)
{
    stream.next();
    stream.expect(Kind::LeftParen, "'(' and the number of an internal function");
    const Token number = stream.peek();
    stream.expect(Kind::Number, "the number of an internal function");
    if (!(number.number >= 0.0 && number.number < function::kNumbered))
        stream.fail(stream.place(number), fmt::format("there is no internal function {}", number.number));
    stream.expect(Kind::RightParen, "')'");
    const auto which = static_cast<std::uint32_t>(number.number);
    const bool whole = which == function::kEnneper && stream.povray() == scene::PovRay::V38;
    return function::make_internal(whole ? function::kWholeEnneper : which);
}

/// Bodies that are a thing of the scene. Null: an expression follows.
function::FunctionPtr read_special(TokenStream& stream, bool parameters_given)
{
    const Kind kind = stream.peek().kind;
    if (kind == Kind::Internal) return read_internal(stream);
    if (kind != Kind::Pigment && kind != Kind::Transform && kind != Kind::Spline && kind != Kind::Pattern)
        return nullptr;
    if (parameters_given)
        stream.fail(stream.here(), fmt::format("a function made of '{}' takes no list of parameters", spelling(kind)));
    if (kind == Kind::Spline) {
        SplinePtr spline = read_spline(stream);
        const std::uint32_t count = spline->components();
        return function::make_outer(std::move(spline), 1, count);
    }
    auto made = stream.hooks().parse_function_thing(stream);
    if (!made) stream.fail_expected("an expression");
    return function::make_outer(*made, 3, kind == Kind::Transform ? 3 : kind == Kind::Pigment ? 5 : 1);
}

}  // namespace

function::FunctionPtr read_function_body(TokenStream& stream, const std::vector<std::string>& given)
{
    const scene::SourceRef opened = stream.last();
    if (stream.peek().kind == Kind::String) stream.next();  // a comment of old files
    function::FunctionPtr made = read_special(stream, !given.empty());
    if (!made) {
        const std::vector<std::string> parameters = given.empty() ? std::vector<std::string>{"x", "y", "z"} : given;
        function::Builder build(static_cast<std::uint32_t>(parameters.size()));
        std::map<std::string, BodyReader::Value> names;
        for (std::uint32_t i = 0; i < parameters.size(); ++i) names.emplace(parameters[i], i);
        name_axes(names, parameters);
        const auto result = BodyReader(stream, build, names).read();
        made = build.finish(result);
    }
    stream.expect_closing("an operator or '}' at the end of the function", "the function", opened);
    return made;
}

function::FunctionPtr read_function_value(TokenStream& stream)
{
    stream.next();
    const bool raw = stream.raw_operators();
    stream.set_raw_operators(false);
    std::vector<std::string> parameters;
    if (stream.accept(Kind::LeftParen)) parameters = read_parameters(stream);
    stream.expect(Kind::LeftBrace, "'{' and the function's body");
    auto made = read_function_body(stream, parameters);
    stream.set_raw_operators(raw);
    return made;
}

}  // namespace parser
