#pragma once

#include "parser/stream/expression.h"

#include <algorithm>
#include <limits>

/// Values as the members that they become.
namespace parser {

/// Cut off, and kept where an int can be: 0 for what is no number.
inline int whole_number(double v)
{
    constexpr double kMost = std::numeric_limits<int>::max();
    return v != v ? 0 : static_cast<int>(std::clamp(v, -kMost, kMost));
}

/// Of a name the expression tells better what is wrong with it.
inline double number(TokenStream& in)
{
    if (!at_expression(in) && in.peek().kind != Kind::Identifier) in.fail_expected("a number");
    return float_expr(in);
}

// A value of the member's type, from where the text stands.
inline void read_value(TokenStream& in, double& to) { to = number(in); }
inline void read_value(TokenStream& in, float& to) { to = static_cast<float>(number(in)); }
inline void read_value(TokenStream& in, int& to) { to = whole_number(number(in)); }
inline void read_value(TokenStream& in, bool& to) { to = optional_flag(in); }
inline void read_value(TokenStream& in, glm::dvec2& to) { to = vector2_expr(in); }
inline void read_value(TokenStream& in, glm::dvec3& to) { to = vector_expr(in); }
inline void read_value(TokenStream& in, glm::dvec4& to) { to = vector4_expr(in); }
inline void read_value(TokenStream& in, glm::vec3& to) { to = rgb_expr(in).rgb(); }
inline void read_value(TokenStream& in, scene::Color& to) { to = color_expr(in); }
inline void read_value(TokenStream& in, std::string& to) { to = string_expr(in); }
template <class T>
void read_value(TokenStream& in, std::optional<T>& to)
{
    T value{};
    read_value(in, value);
    to = value;
}

/// Values one after the other, commas between them optional.
template <class First, class... Rest>
void read_values(TokenStream& in, First& first, Rest&... rest)
{
    read_value(in, first);
    ((in.accept_comma(), read_value(in, rest)), ...);
}

/// Behind a comma, or where an expression can begin: one more number.
inline bool more_numbers(TokenStream& in) { return in.accept_comma() || at_expression(in); }

inline constexpr double kMost = 1e300;  ///< of a number without an upper limit: no infinity

/// What a number may be. `above`: low itself is excluded.
struct Range {
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
    bool above = false;
    bool holds(double v) const { return !(above ? v <= low : v < low) && !(v > high); }
};
struct any_number {
    static constexpr Range range{};
};
template <int low>
struct at_least {
    static constexpr Range range{.low = low};
};
template <int low, int high = 0>
struct above {
    static constexpr Range range{low, high == 0 ? kMost : high, true};
};
template <int low, int high>
struct within {
    static constexpr Range range{low, high};
};
/// "'count' must be above 0".
[[noreturn]] void fail_range(TokenStream& in, const scene::SourceRef& at, Kind keyword, const Range& range);

/// A number that must lie in a range, named by its keyword, which was taken last, in the message.
template <Kind keyword, class Limits>
double ranged_number(TokenStream& in)
{
    if constexpr (std::is_same_v<Limits, any_number>) return number(in);
    const scene::SourceRef at = in.last();
    const double value = number(in);
    if (!Limits::range.holds(value)) fail_range(in, at, keyword, Limits::range);
    return value;
}
template <Kind keyword, class Limits, class Value>
void read_member(TokenStream& in, Value& to)
{
    if constexpr (std::is_same_v<Value, double>) to = ranged_number<keyword, Limits>(in);
    else if constexpr (std::is_same_v<Value, int>) to = whole_number(ranged_number<keyword, Limits>(in));
    else read_value(in, to);
}

template <auto Member>
struct MemberOf;
template <class Struct, class Value, Value Struct::*Member>
struct MemberOf<Member> {
    using type = Value;
    using owner = Struct;
};
/// A member's type, for overloads.
template <auto Member>
inline constexpr const typename MemberOf<Member>::type* kNowhere = nullptr;
/// The member of what a state fills: of state.subject(), or of a part of it.
template <auto Member, class State>
auto& member_of(State& state)
{
    if constexpr (requires { state.subject().*Member; }) return state.subject().*Member;
    else return state.part(static_cast<typename MemberOf<Member>::owner*>(nullptr)).*Member;
}

}  // namespace parser
