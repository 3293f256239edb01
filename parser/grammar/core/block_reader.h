#pragma once

#include "parser/grammar/core/scene_builder.h"
#include "parser/stream/expression.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <tuple>
#include <type_traits>

/// Blocks whose items are members of one struct: a list of fields (keyword, member, what the value may be) reads them.
namespace parser {

class BlockReader {
public:
    /// The keyword has been taken: it names the block in messages.
    explicit BlockReader(SceneBuilder& build);

    TokenStream& in() { return build_.stream(); }
    SceneBuilder& build() { return build_; }
    std::string_view keyword() const { return keyword_; }
    /// Of the keyword.
    const scene::SourceRef& source() const { return source_; }
    bool accept(Kind kind) { return in().accept(kind); }
    Kind next_kind() { return in().peek().kind; }
    [[noreturn]] void fail(std::string_view text) { in().fail(in().last(), text); }
    /// `{`; close() at `}`.
    void open();
    void close(const std::vector<Kind>& items = {});

private:
    SceneBuilder& build_;
    std::string_view keyword_;
    scene::SourceRef source_, opened_;
};

/// Cut off, and kept where an int can be: 0 for what is no number.
inline int whole_number(double v)
{
    constexpr double kMost = std::numeric_limits<int>::max();
    return v != v ? 0 : static_cast<int>(std::clamp(v, -kMost, kMost));
}

// A value of the member's type, from where the text stands.
inline void read_value(TokenStream& in, double& to) { to = float_expr(in); }
inline void read_value(TokenStream& in, int& to) { to = whole_number(float_expr(in)); }
inline void read_value(TokenStream& in, bool& to) { to = optional_flag(in); }
inline void read_value(TokenStream& in, glm::dvec2& to) { to = vector2_expr(in); }
inline void read_value(TokenStream& in, glm::dvec3& to) { to = vector_expr(in); }
inline void read_value(TokenStream& in, glm::dvec4& to) { to = vector4_expr(in); }
inline void read_value(TokenStream& in, glm::vec3& to) { to = rgb_expr(in).rgb(); }
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

/// What a number may be. `above`: low itself is excluded.
struct Range {
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
    bool above = false;
    bool holds(double v) const { return !(above ? v <= low : v < low) && !(v > high); }
};
inline constexpr Range at_least(double low) { return {.low = low}; }
inline constexpr Range above(double low, double high = 1e300) { return {low, high, true}; }
inline constexpr Range within(double low, double high) { return {low, high}; }
/// "'count' must be above 0".
[[noreturn]] void fail_range(TokenStream& in, const scene::SourceRef& at, Kind keyword, const Range& range);

template <class Struct, class Value>
struct Field {
    Kind keyword;
    Value Struct::*member;
    Range range;
};
/// A keyword with a value; of a bool with an optional one, so that the keyword alone means yes.
template <class Struct, class Value>
constexpr Field<Struct, Value> field(Kind keyword, Value Struct::*member, Range range = {})
{
    return {keyword, member, range};
}
/// A keyword that stands alone and means yes.
template <class Struct>
struct Word {
    Kind keyword;
    bool Struct::*member;
};
template <class Struct>
constexpr Word<Struct> word(Kind keyword, bool Struct::*member)
{
    return {keyword, member};
}
/// A keyword with a number that is not 0 once cut off, as POV-Ray reads some switches.
template <class Struct, class Value>
struct Switch {
    Kind keyword;
    Value Struct::*member;
};
template <class Struct, class Value>
constexpr Switch<Struct, Value> number_switch(Kind keyword, Value Struct::*member)
{
    return {keyword, member};
}

/// A number that must lie in a range, named by its keyword in the message at `at`.
inline double ranged_number(TokenStream& in, Kind keyword, const Range& range, const scene::SourceRef& at)
{
    const double value = float_expr(in);
    if (!range.holds(value)) fail_range(in, at, keyword, range);
    return value;
}

template <class Struct, class Value>
bool read_field(TokenStream& in, Struct& to, const Field<Struct, Value>& field)
{
    if (!in.accept(field.keyword)) return false;
    if constexpr (std::is_same_v<Value, double>) {
        to.*field.member = ranged_number(in, field.keyword, field.range, in.last());
    } else if constexpr (std::is_same_v<Value, int>) {
        to.*field.member = whole_number(ranged_number(in, field.keyword, field.range, in.last()));
    } else {
        read_value(in, to.*field.member);
    }
    return true;
}
template <class Struct>
bool read_field(TokenStream& in, Struct& to, const Word<Struct>& word)
{
    if (!in.accept(word.keyword)) return false;
    return to.*word.member = true;
}
template <class Struct, class Value>
bool read_field(TokenStream& in, Struct& to, const Switch<Struct, Value>& one)
{
    if (!in.accept(one.keyword)) return false;
    to.*one.member = whole_number(float_expr(in)) != 0;
    return true;
}

/// One of the fields if its keyword is next.
template <class Struct, class... Fields>
bool read_one(BlockReader& s, Struct& to, const std::tuple<Fields...>& fields)
{
    return std::apply([&](const Fields&... one) { return (read_field(s.in(), to, one) || ...); }, fields);
}
/// `{` fields `}`.
template <class Struct, class Fields>
void read_fields(BlockReader& s, Struct& to, const Fields& fields)
{
    s.open();
    while (read_one(s, to, fields)) {}
    if (s.next_kind() == Kind::RightBrace) return s.close();
    s.close(std::apply([](const auto&... one) { return std::vector<Kind>{one.keyword...}; }, fields));
}

}  // namespace parser
