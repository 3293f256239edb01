#include "parser/grammar/statement.h"

#include <fmt/format.h>

#include <cmath>

namespace parser {

StatementReader::StatementReader(SceneBuilder& build) : build_(build)
{
    const Token& keyword = build.stream().taken_last();
    statement_.keyword = spelling(keyword.kind);
    statement_.source = build.stream().last();
}

void StatementReader::add(std::string_view name, std::vector<Operand> operands)
{
    statement_.items.push_back({std::string(name), std::move(operands)});
}

std::vector<StatementReader::Operand> StatementReader::operands(const char* letters)
{
    std::vector<Operand> values;
    TokenStream& stream = in();
    for (const char* letter = letters; *letter != 0; ++letter) {
        if (*letter == ',') {
            if (!stream.accept_comma() && !at_expression(stream)) break;
            continue;
        }
        if (letter != letters) stream.accept_comma();
        switch (*letter) {
        case 'f': values.emplace_back(float_expr(stream)); break;
        case 'v': values.emplace_back(vector_expr(stream)); break;
        case 'p': values.emplace_back(vector2_expr(stream)); break;
        case 'q': values.emplace_back(vector4_expr(stream)); break;
        case 'c': values.emplace_back(rgb_expr(stream)); break;
        case 'C': values.emplace_back(color_expr(stream)); break;
        case 's': values.emplace_back(string_expr(stream)); break;
        case 't': values.emplace_back(path_expr(stream)); break;
        default: values.emplace_back(optional_flag(stream) ? 1.0 : 0.0); break;  // o
        }
    }
    return values;
}

bool StatementReader::read_form(const Form& form)
{
    if (!accept(form.keyword)) return false;
    const scene::SourceRef at = in().last();
    std::vector<Operand> values = operands(form.operands);
    const double first = values.empty() ? 0.0 : number_of(values[0]);
    const bool low = form.above ? first <= form.low : first < form.low;
    if (low || first > form.high) {
        const std::string range = std::isinf(form.high) ? fmt::format("{} {}", form.above ? "above" : "at least", form.low)
                                                        : fmt::format("{}{} to {}", form.above ? "above " : "from ", form.low, form.high);
        in().fail(at, fmt::format("'{}' must be {}", spelling(form.keyword), range));
    }
    add(spelling(form.keyword), std::move(values));
    return true;
}

bool StatementReader::read_transform()
{
    const auto transform = read_transformation(build_);
    if (transform) add("transform", {*transform});
    return transform.has_value();
}

void StatementReader::open()
{
    opened_ = build_.open_block(statement_.keyword.c_str());
}

void StatementReader::close()
{
    build_.close_block(statement_.keyword.c_str(), opened_);
}

scene::StatementPtr accept_declared(SceneBuilder& build, std::string_view keyword)
{
    TokenStream& stream = build.stream();
    const Token& name = stream.peek();
    const Value* value = name.kind == Kind::Identifier ? stream.value_of(name) : nullptr;
    const auto* declared = value ? value->get_if<scene::StatementPtr>() : nullptr;
    if (declared && (*declared)->keyword != keyword) return nullptr;
    auto taken = stream.accept_identifier<scene::StatementPtr>();
    return taken ? *taken : nullptr;
}

}  // namespace parser
