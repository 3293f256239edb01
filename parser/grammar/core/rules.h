#pragma once

#include "parser/grammar/core/forms.h"
#include "parser/grammar/core/productions.h"
#include "parser/grammar/core/scene_builder.h"
#include "parser/grammar/core/values.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// Forms shared by the grammar's families. A block is a table of items, found by their keyword; an item is one rule
/// that commits after its keyword and one function, `act`, that moves what was read into the block's state.
///
/// ```
/// struct phong : item<Kind::Phong, a_number> {
///     static void act(FinishState& s) { s.finish.phong = s.pop_single(); }
/// };
/// using FinishItems = table<FinishState, phong, member<Kind::PhongSize, &scene::Finish::phong_size>, ...>;
/// block<Kind::Finish, FinishItems>::read(build, state);
/// ```
namespace parser {

// The expression leaves, named apart from the functions that read the same things.
using a_color = rules::color_expr;
using a_number = rules::float_expr;
using a_text = rules::string_expr;
using a_pair = rules::vector2_expr;
using a_vector4 = rules::vector4_expr;
using a_vector = rules::vector_expr;
using pegtl::must;
using pegtl::opt;
using pegtl::seq;

/// What cannot fail, so that its message is never seen.
struct always {};
template <class... Rules>
inline constexpr const char* expected<pegtl::opt<Rules...>> = "";
template <class... Rules>
inline constexpr const char* expected<pegtl::star<Rules...>> = "";
template <class Rule>
    requires std::is_base_of_v<always, Rule>
inline constexpr const char* expected<Rule> = "";

/// A colour without filter and transmit.
struct a_rgb : operand_rule<a_rgb> {
    static bool at(TokenStream& s) { return at_color(s); }
    static scene::Color read(TokenStream& s) { return parser::rgb_expr(s); }
    static Form form() { return Form::named(color_form); }
};
template <>
inline constexpr auto expected<a_rgb> = "a color, as in rgb <1, 0.5, 0>";
/// Behind a word that may have a number: pop_flag().
struct a_flag : operand_rule<a_flag>, always {
    static bool at(TokenStream&) { return true; }
    static double read(TokenStream& s) { return optional_flag(s) ? 1.0 : 0.0; }
    static Form form() { return Form::optional(Form::named(number_form)); }
};
/// Whether a word stands here: pop_flag().
template <Kind kind>
struct given : operand_rule<given<kind>>, always {
    static bool at(TokenStream&) { return true; }
    static double read(TokenStream& s) { return s.accept(kind) ? 1.0 : 0.0; }
    static Form form() { return Form::optional(Form::token(kind)); }
};
/// A number that may be left out.
template <int otherwise>
struct number_or : operand_rule<number_or<otherwise>>, always {
    static bool at(TokenStream&) { return true; }
    static double read(TokenStream& s) { return at_expression(s) ? parser::float_expr(s) : otherwise; }
    static Form form() { return Form::optional(Form::named(number_form)); }
};
/// One more behind an optional comma.
template <int otherwise>
using next_number_or = seq<opt_comma, number_or<otherwise>>;
template <int otherwise>
inline constexpr const char* expected<next_number_or<otherwise>> = "";
/// One more that may be left out, but not behind a comma.
using another_number = opt<pegtl::sor<pegtl::if_must<comma, a_number>, a_number>>;
/// A number in a range, behind the keyword that a message names.
template <Kind keyword, class Limits>
struct ranged : operand_rule<ranged<keyword, Limits>>, always {
    static bool at(TokenStream&) { return true; }
    static double read(TokenStream& s) { return ranged_number<keyword, Limits>(s); }
    static Form form() { return Form::named(number_form); }
};
/// A curve of levels: BlockState::pop_curve() has it.
using gamma_curve = pegtl::sor<any_token<Kind::Srgb, Kind::Bt709, Kind::Bt2020>, a_number>;
template <>
inline constexpr auto expected<gamma_curve> = "a number";
/// What the action reads by itself: for the form alone.
template <class... Rules>
struct by_action : pegtl::success, always {
    static Form form() { return Form::sequence({form_of<Rules>()...}); }
};
template <Production (*production)()>
struct reads : pegtl::success, always {
    static Form form() { return Form::named(production); }
};

/// What the items of one block work on.
struct BlockState : OperandStack {
    explicit BlockState(SceneBuilder& builder) : OperandStack(builder.operand_memory), build(builder) {}
    SceneBuilder& build;
    TokenStream& stream() { return build.stream(); }
    [[noreturn]] void fail(std::string_view text) { stream().fail(stream().last(), text); }
    void warn(std::string_view text) { stream().warn(stream().last(), text); }
    float pop_single() { return static_cast<float>(pop_float()); }
    int pop_int() { return whole_number(pop_float()); }
    bool pop_flag() { return pop_float() != 0.0; }
    glm::vec3 pop_rgb() { return pop_color().rgb(); }
    scene::GammaCurve pop_curve()
    {
        using Curve = scene::GammaCurve::Kind;
        if (operands() > 0) return {Curve::Power, pop_float()};
        const Kind name = stream().taken_last().kind;
        return {name == Kind::Srgb ? Curve::Srgb : name == Kind::Bt709 ? Curve::Bt709 : Curve::Bt2020};
    }
};

/// The state of a block that fills one struct.
template <class Struct>
struct StructState : BlockState {
    using BlockState::BlockState;
    Struct& subject() { return made; }
    Struct made{};
};

/// What has a function `act`.
struct item_base {};
template <Kind K, class... Rest>
struct item : pegtl::if_must<token<K>, Rest...>, item_base {
    static constexpr Kind keyword = K;
};

template <class Rule>
struct action : pegtl::nothing<Rule> {};
template <class Rule>
    requires std::is_base_of_v<item_base, Rule>
struct action<Rule> {
    template <class State>
    static void apply0(State& state)
    {
        Rule::act(state);
    }
};

/// Items by keyword: one look-up instead of a chain of alternatives.
template <class State, class... Items>
struct table {
    using Reader = bool (*)(TokenInput&, State&);

    /// Whether the keyword of an item is next.
    static bool begins(SceneBuilder& build)
    {
        return kPlaces[static_cast<std::size_t>(build.stream().peek().kind)] != 0;
    }
    /// Reads one item if its keyword is next.
    static bool match(SceneBuilder& build, State& state)
    {
        static constexpr std::array<Reader, sizeof...(Items)> readers{&read<Items>...};
        const std::size_t place = kPlaces[static_cast<std::size_t>(build.stream().peek().kind)];
        if (place == 0) return false;
        TokenInput input(build.stream());
        return readers[place - 1](input, state);
    }
    /// The keywords of all items, for messages.
    static std::vector<Kind> words() { return {Items::keyword...}; }
    static Form form() { return Form::choice({form_of<Items>()...}); }

private:
    template <class Item>
    static bool read(TokenInput& input, State& state)
    {
        return pegtl::parse<Item, action, control>(input, state);
    }
    /// Of each keyword: one more than its item's place. Bytes, for the loader would write an address for each of all
    /// words.
    static constexpr std::array<std::uint8_t, kKindCount> kPlaces = [] {
        static_assert(sizeof...(Items) < 256);
        std::array<std::uint8_t, kKindCount> all{};
        std::uint8_t place = 0;
        ((all[static_cast<std::size_t>(Items::keyword)] = ++place), ...);
        return all;
    }();
};

/// A leaf that says by itself what it takes.
template <class Self>
struct taker : leaf<Self> {
    template <pegtl::apply_mode, pegtl::rewind_mode, template <class...> class, template <class...> class, class State>
    static bool match(TokenInput& in, State& state)
    {
        return Self::take(in.stream(), state);
    }
};
/// A keyword, then what Self::read() reads.
template <class Self, Kind K>
struct behind : taker<Self> {
    static constexpr Kind keyword = K;
    template <class State>
    static bool take(TokenStream& in, State& state)
    {
        if (!in.accept(K)) return false;
        Self::read(in, state);
        return true;
    }
    static Form form() { return Form::sequence({Form::token(K), Self::value()}); }
};
/// A keyword with a value that becomes a member of state.subject(); of a bool the number may be left out.
template <Kind K, auto Member, class Limits = any_number>
struct member : behind<member<K, Member, Limits>, K> {
    static void read(TokenStream& in, auto& state) { read_member<K, Limits>(in, member_of<Member>(state)); }
    static Form value() { return forms::of_value(kNowhere<Member>); }
};
/// With values of several members, commas between them optional. Behind the first `least` they may be left out.
template <Kind K, std::size_t least, auto... Members>
struct members : behind<members<K, least, Members...>, K> {
    static void read(TokenStream& in, auto& state)
    {
        std::size_t count = 0;
        const auto one = [&](auto& to) {
            if (count > 0 && count < least) in.accept_comma();
            if (count >= least && !more_numbers(in)) return false;
            ++count;
            read_value(in, to);
            return true;
        };
        (void)(one(member_of<Members>(state)) && ...);
    }
    static Form value()
    {
        std::vector<Form> all, values{forms::of_value(kNowhere<Members>)...};
        for (const Form& one : values) {
            Form next = all.empty() ? one : Form::sequence({form_of<opt_comma>(), one});
            all.push_back(all.size() < least ? std::move(next) : Form::optional(std::move(next)));
        }
        return Form::sequence(std::move(all));
    }
};
/// With a number that is not 0 once cut off, as POV-Ray reads some switches.
template <Kind K, auto Member>
struct number_switch : behind<number_switch<K, Member>, K> {
    static void read(TokenStream& in, auto& state) { member_of<Member>(state) = whole_number(number(in)) != 0; }
    static Form value() { return Form::named(number_form); }
};
/// A keyword that chooses a member's value.
template <Kind K, auto Member, auto choice>
struct chosen : behind<chosen<K, Member, choice>, K> {
    static void read(TokenStream&, auto& state) { member_of<Member>(state) = choice; }
    static Form value() { return {}; }
};
/// One that stands alone and means yes.
template <Kind K, auto Member>
using word = chosen<K, Member, true>;
/// With an optional number, of no use to us.
template <Kind K>
struct ignored : behind<ignored<K>, K> {
    static void read(TokenStream& in, auto&) { optional_flag(in); }
    static Form value() { return form_of<a_flag>(); }
};
/// Values of members, commas between them optional.
template <auto First, auto... Rest>
struct values : taker<values<First, Rest...>>, always {
    static bool take(TokenStream& in, auto& state)
    {
        read_values(in, member_of<First>(state), member_of<Rest>(state)...);
        return true;
    }
    static Form form()
    {
        return Form::sequence({forms::of_value(kNowhere<First>),
                               Form::sequence({form_of<opt_comma>(), forms::of_value(kNowhere<Rest>)})...});
    }
};

/// Whether one of the tables has the next item.
template <class... Tables>
struct either {
    template <class State>
    static bool match(SceneBuilder& build, State& state)
    {
        return (Tables::match(build, state) || ...);
    }
    static std::vector<Kind> words()
    {
        std::vector<Kind> all;
        for (const std::vector<Kind>& more : {Tables::words()...}) all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    static Form form() { return Form::choice({Tables::form()...}); }
};
/// Of a block that has a head alone.
struct no_items {
    template <class State>
    static bool match(SceneBuilder&, State&)
    {
        return false;
    }
    static std::vector<Kind> words() { return {}; }
    static Form form() { return {}; }
};
/// A transformation, for state.move().
struct moves {
    template <class State>
    static bool match(SceneBuilder& build, State& state)
    {
        const auto by = read_transformation(build);
        if (by) state.move(*by);
        return by.has_value();
    }
    static std::vector<Kind> words()
    {
        return {Kind::Translate, Kind::Rotate, Kind::Scale, Kind::Matrix, Kind::Transform};
    }
    static Form form() { return Form::named(transformation); }
};
/// The name of a declared T, for state.take().
template <class T>
struct declared : taker<declared<T>> {
    static bool take(TokenStream& in, auto& state)
    {
        const auto found = in.accept_identifier<T>();
        if (found) state.take(*found);
        return found.has_value();
    }
    static Form form() { return Form::operand("identifier"); }
};

/// Reads one rule that must match.
template <class Rule, class State>
void read_rule(SceneBuilder& build, State& state)
{
    TokenInput input(build.stream());
    pegtl::parse<must<Rule>, action, control>(input, state);
}

/// `{` head, items `}`; the keyword has been taken. state.check() may look at the whole.
template <Kind keyword, class Items, class... Head>
struct block : leaf<block<keyword, Items, Head...>> {
    /// `name`: in messages.
    template <class State>
    static void read(SceneBuilder& build, State& state, std::string_view name = spelling(keyword))
    {
        const auto guard = build.stream().nest();
        const scene::SourceRef opened = build.open_block(name);
        if constexpr (sizeof...(Head) > 0) {
            TokenInput input(build.stream());
            pegtl::parse<seq<must<Head>...>, action, control>(input, state);
        }
        while (Items::match(build, state)) {}
        if constexpr (requires { state.check(); }) state.check();
        build.close_block(name, opened, Items::words);
    }
    static Form form() { return Form::braces({form_of<Head>()..., Form::repeated(Items::form())}); }
};

}  // namespace parser
