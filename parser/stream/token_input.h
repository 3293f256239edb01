#pragma once

#include "parser/stream/expression.h"
#include "parser/stream/token_stream.h"
#include "render/scene/base/sealed.h"

#include <tao/pegtl.hpp>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

/// PEGTL over tokens: an input, the rule token<Kind>, leaf rules for expressions, messages for what a rule expects.
/// Rules are LL(1): every construct commits after its first token (if_must), so nothing is ever read twice.
///
/// ```
/// struct sphere : if_must<token<Kind::Sphere>, open_brace, center, radius, close_brace> {};
/// template <> inline constexpr auto expected<radius> = "the sphere's radius (a number)";
/// template <> struct action<sphere> { static void apply0(SceneBuilder& build) { ... build.pop_float() ... } };
/// pegtl::parse<sphere, action, control>(input, build);   // build is, or derives from, an OperandStack
/// ```
/// Actions are apply0(state) only: what a rule read lies on the operand stack in reading order.
namespace parser {

namespace pegtl = tao::pegtl;

struct OperandKinds {
    using variant = std::variant<double, glm::dvec2, glm::dvec3, glm::dvec4, scene::Color, std::string>;
};
}  // namespace parser
extern template struct scene::Sealed<parser::OperandKinds>;
namespace parser {

/// Values read by leaf rules, waiting for the action of the construct around them.
class OperandStack {
public:
    using Operand = scene::Sealed<OperandKinds>;
    using Memory = std::vector<Operand>;

    /// Lies on top of what `memory` holds: blocks within blocks use one, so none of them has to ask for memory.
    explicit OperandStack(Memory& memory) : operands_(memory), below_(memory.size()) {}
    ~OperandStack() { operands_.erase(operands_.begin() + static_cast<std::ptrdiff_t>(below_), operands_.end()); }
    OperandStack(const OperandStack&) = delete;
    OperandStack& operator=(const OperandStack&) = delete;

    template <class T>
    void push(T value)
    {
        operands_.emplace_back(std::move(value));
    }
    template <class T>
    T pop()
    {
        T value = std::get<T>(std::move(operands_.back()));
        operands_.pop_back();
        return value;
    }
    double pop_float() { return pop<double>(); }
    glm::dvec2 pop_vector2() { return pop<glm::dvec2>(); }
    glm::dvec3 pop_vector() { return pop<glm::dvec3>(); }
    scene::Color pop_color() { return pop<scene::Color>(); }
    std::string pop_string() { return pop<std::string>(); }
    std::size_t operands() const { return operands_.size() - below_; }

private:
    Memory& operands_;
    std::size_t below_;
};

/// The PEGTL input. PEGTL's marks do nothing unless a rule tries to go back over a token it took: that is a mistake in
/// the grammar and throws std::logic_error, so that no text is ever read twice by accident.
class TokenInput {
public:
    using iterator_t = std::uint64_t;  // number of tokens taken

    explicit TokenInput(TokenStream& stream) : stream_(stream) {}
    TokenStream& stream() const { return stream_; }
    bool empty() const { return stream_.peek().kind == Kind::EndOfText; }
    scene::SourceRef position() const { return stream_.here(); }

    template <pegtl::rewind_mode M>
    class Mark {
    public:
        static constexpr pegtl::rewind_mode next_rewind_mode =
            M == pegtl::rewind_mode::dontcare ? M : pegtl::rewind_mode::active;
        explicit Mark(const TokenStream& stream) : stream_(stream), taken_(stream.taken()) {}
        bool operator()(bool success) const
        {
            if constexpr (M == pegtl::rewind_mode::required)
                if (!success && stream_.taken() != taken_)
                    throw std::logic_error("grammar: a rule failed after taking a token; it needs a commit point");
            return success;
        }
        iterator_t iterator() const { return taken_; }

    private:
        const TokenStream& stream_;
        std::uint64_t taken_;
    };
    /// What stands ahead is looked at first: where that is a macro's call, looking takes the call.
    template <pegtl::rewind_mode M>
    Mark<M> mark() const
    {
        if constexpr (M == pegtl::rewind_mode::required) stream_.peek();
        return Mark<M>(stream_);
    }

private:
    TokenStream& stream_;
};

/// What to say when a rule that must match does not: "expected <this>, found '...'". Every rule inside must<> or
/// if_must<> needs one, or the grammar does not compile.
template <class Rule>
inline constexpr const char* expected = nullptr;

template <class Rule>
struct control : pegtl::normal<Rule> {
    template <class... States>
    [[noreturn]] static void raise(const TokenInput& in, States&&...)
    {
        static_assert(expected<Rule> != nullptr, "a rule that must match needs a message: expected<Rule>");
        in.stream().fail_expected(expected<Rule>);
    }
};

/// Shared by the leaf rules: tells PEGTL that there is nothing inside.
template <class Self>
struct leaf {
    using rule_t = Self;
    using subs_t = pegtl::type_list<>;
};

/// Takes one token of that kind.
template <Kind kind>
struct token : leaf<token<kind>> {
    template <pegtl::apply_mode, pegtl::rewind_mode, template <class...> class, template <class...> class,
              class... States>
    static bool match(TokenInput& in, States&&...)
    {
        return in.stream().accept(kind);
    }
};
/// Takes one token of any of these kinds.
template <Kind... kinds>
struct any_token : leaf<any_token<kinds...>> {
    template <pegtl::apply_mode, pegtl::rewind_mode, template <class...> class, template <class...> class,
              class... States>
    static bool match(TokenInput& in, States&&...)
    {
        return (in.stream().accept(kinds) || ...);
    }
};
/// Looks, takes nothing.
template <Kind kind>
struct next_is : leaf<next_is<kind>> {
    template <pegtl::apply_mode, pegtl::rewind_mode, template <class...> class, template <class...> class,
              class... States>
    static bool match(TokenInput& in, States&&...)
    {
        return in.stream().peek().kind == kind;
    }
};

using comma = token<Kind::Comma>;
using opt_comma = pegtl::opt<comma>;
using open_brace = token<Kind::LeftBrace>;
using close_brace = token<Kind::RightBrace>;

template <>
inline constexpr auto expected<open_brace> = "'{'";
template <>
inline constexpr auto expected<close_brace> = "'}'";
template <>
inline constexpr auto expected<comma> = "','";

/// An expression leaf: fails without taking anything where Self::at says that none begins, else pushes Self::read.
template <class Self>
struct operand_rule : leaf<Self> {
    template <pegtl::apply_mode, pegtl::rewind_mode, template <class...> class, template <class...> class,
              class... States>
    static bool match(TokenInput& in, OperandStack& operands, States&&...)
    {
        if (!Self::at(in.stream())) return false;
        operands.push(Self::read(in.stream()));
        return true;
    }
};

/// Leaf rules named as the functions of expression.h. In a grammar's namespace: `using rules::float_expr;`.
namespace rules {

struct float_expr : operand_rule<float_expr> {
    static bool at(TokenStream& s) { return at_expression(s); }
    static double read(TokenStream& s) { return parser::float_expr(s); }
};
struct vector2_expr : operand_rule<vector2_expr> {
    static bool at(TokenStream& s) { return at_expression(s); }
    static glm::dvec2 read(TokenStream& s) { return parser::vector2_expr(s); }
};
struct vector_expr : operand_rule<vector_expr> {
    static bool at(TokenStream& s) { return at_expression(s); }
    static glm::dvec3 read(TokenStream& s) { return parser::vector_expr(s); }
};
struct vector4_expr : operand_rule<vector4_expr> {
    static bool at(TokenStream& s) { return at_expression(s); }
    static glm::dvec4 read(TokenStream& s) { return parser::vector4_expr(s); }
};
struct color_expr : operand_rule<color_expr> {
    static bool at(TokenStream& s) { return at_color(s); }
    static scene::Color read(TokenStream& s) { return parser::color_expr(s); }
};
struct string_expr : operand_rule<string_expr> {
    static bool at(TokenStream& s) { return at_string(s); }
    static std::string read(TokenStream& s) { return parser::string_expr(s); }
};

}  // namespace rules

template <>
inline constexpr auto expected<rules::float_expr> = "a number";
template <>
inline constexpr auto expected<rules::vector2_expr> = "two numbers, as in <0, 1>";
template <>
inline constexpr auto expected<rules::vector_expr> = "a vector, as in <0, 1, 0>";
template <>
inline constexpr auto expected<rules::vector4_expr> = "four numbers, as in <0, 1, 0, 1>";
template <>
inline constexpr auto expected<rules::color_expr> = "a colour, as in rgb <1, 0.5, 0>";
template <>
inline constexpr auto expected<rules::string_expr> = "a text, as in \"name\"";

}  // namespace parser
