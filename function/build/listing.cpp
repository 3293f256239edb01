#include "function/build/listing.h"

#include <fmt/format.h>

#include <array>

namespace function {
namespace {

constexpr std::array<const char*, 46> kNames = {
    "add",   "subtract",  "multiply", "divide",  "less",     "less_equal", "greater", "greater_equal",
    "equal", "not_equal", "and",      "or",      "min",      "max",        "atan2",   "div",
    "mod",   "pow",       "negate",   "abs",     "acos",     "acosh",      "asin",    "asinh",
    "atan",  "atanh",     "ceil",     "cos",     "cosh",     "degrees",    "exp",     "floor",
    "int",   "ln",        "log",      "radians", "sin",      "sinh",       "sqrt",    "tan",
    "tanh",  "select",    "loop",     "call",    "internal", "outer",
};
static_assert(static_cast<std::size_t>(Op::SceneReference) + 1 == kNames.size());

std::string register_name(const Function& f, std::uint32_t r)
{
    if (r < f.constants.size()) return fmt::format("{}", f.constants[r]);
    if (r < f.constants.size() + f.parameters) return fmt::format("p{}", r - f.constants.size());
    return fmt::format("r{}", r - f.constants.size() - f.parameters);
}

std::string callee(const SceneReference& what)
{
    if (const auto* n = std::get_if<std::uint32_t>(&what)) return fmt::format("{}", *n);
    if (const auto* f = std::get_if<FunctionPtr>(&what))
        return fmt::format("function of {} instructions", (*f)->code.size());
    if (std::holds_alternative<csg::Transform>(what)) return "transform";
    if (const auto* use = std::get_if<SceneUse>(&what))
        return use->kind == SceneUse::Kind::Pattern ? "pattern" : "pigment";
    return "spline";
}

std::string line(const Function& f, const Instruction& in)
{
    const auto name = [&](std::uint32_t r) { return register_name(f, r); };
    std::string text = fmt::format("{} = {}", name(in.dst), kNames[static_cast<std::size_t>(in.op)]);
    if (in.op == Op::Select) {
        const Branching& b = f.branchings[in.a];
        text += fmt::format(" {}", name(b.condition));
        for (std::uint32_t k = 0; k < b.count; ++k)
            text += fmt::format(" [{}, {}) {}", b.begin[k], b.end[k], name(b.result[k]));
    } else if (in.op == Op::Loop) {
        const Loop& l = f.loops[in.a];
        text += fmt::format(" {} {} from {} to {} [{}, {}) {}", l.product ? "product" : "sum", name(l.counter),
                            name(l.from), name(l.to), l.begin, l.end, name(l.result));
    } else if (in.op == Op::Call || in.op == Op::Internal || in.op == Op::SceneReference) {
        text += fmt::format(" {}", callee(f.outer[in.c]));
        for (std::uint32_t i = 0; i < in.b; ++i) text += fmt::format(" {}", name(f.arguments[in.a + i]));
    } else {
        text += fmt::format(" {}", name(in.a));
        if (is_binary(in.op)) text += fmt::format(" {}", name(in.b));
    }
    return text;
}

}  // namespace

std::vector<std::string> listing(const Function& function)
{
    std::vector<std::string> lines;
    for (const Instruction& in : function.code) lines.push_back(line(function, in));
    lines.push_back(fmt::format("result {}", register_name(function, function.result)));
    return lines;
}

}  // namespace function
