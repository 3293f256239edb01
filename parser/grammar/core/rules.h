#pragma once

#include "parser/grammar/core/scene_builder.h"
#include "parser/stream/token_input.h"

#include <array>
#include <string>
#include <vector>

/// Forms shared by the grammar's families. A block is a table of items, found by their keyword; an item is one rule
/// that commits after its keyword and one function, `act`, that moves what was read into the block's state.
///
/// ```
/// struct phong : item<Kind::Phong, a_number> {
///     static void act(FinishState& s) { s.finish.phong = s.pop_single(); }
/// };
/// using FinishItems = table<FinishState, phong, phong_size, ...>;
/// read_block<FinishItems>(build, state, "finish");
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

/// An option cannot fail, so its message is never seen.
template <class... Rules>
inline constexpr const char* expected<pegtl::opt<Rules...>> = "";

/// What the items of one block work on.
struct BlockState : OperandStack {
    explicit BlockState(SceneBuilder& builder) : OperandStack(builder.operand_memory), build(builder) {}
    SceneBuilder& build;
    TokenStream& stream() { return build.stream(); }
    float pop_single() { return static_cast<float>(pop_float()); }
    int pop_int() { return static_cast<int>(pop_float()); }
};

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
        constexpr auto known = keywords();
        return known[static_cast<std::size_t>(build.stream().peek().kind)];
    }
    /// Reads one item if its keyword is next.
    static bool match(SceneBuilder& build, State& state)
    {
        static constexpr auto readers = make();
        const Reader reader = readers[static_cast<std::size_t>(build.stream().peek().kind)];
        if (!reader) return false;
        TokenInput input(build.stream());
        return reader(input, state);
    }
    /// The keywords of all items, for messages.
    static std::vector<Kind> words() { return {Items::keyword...}; }

private:
    static constexpr std::array<bool, kKindCount> keywords()
    {
        std::array<bool, kKindCount> all{};
        ((all[static_cast<std::size_t>(Items::keyword)] = true), ...);
        return all;
    }
    template <class Item>
    static bool read(TokenInput& input, State& state)
    {
        return pegtl::parse<Item, action, control>(input, state);
    }
    static constexpr std::array<Reader, kKindCount> make()
    {
        std::array<Reader, kKindCount> readers{};
        ((readers[static_cast<std::size_t>(Items::keyword)] = &read<Items>), ...);
        return readers;
    }
};

/// Two tables in one.
template <class First, class Second>
struct joined {
    template <class State>
    static bool match(SceneBuilder& build, State& state)
    {
        return First::match(build, state) || Second::match(build, state);
    }
    static std::vector<Kind> words()
    {
        std::vector<Kind> all = First::words();
        const std::vector<Kind> more = Second::words();
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
};

/// Reads one rule that must match.
template <class Rule, class State>
void read_rule(SceneBuilder& build, State& state)
{
    TokenInput input(build.stream());
    pegtl::parse<must<Rule>, action, control>(input, state);
}

/// The keywords of a block's items; none where a block reads them without a table.
template <class Items>
std::vector<Kind> words_of()
{
    if constexpr (requires { Items::words(); }) return Items::words();
    else return {};
}

/// `{` items `}` with `head` run after the brace; the keyword has been taken. `what` names the block in messages.
template <class Items, class State, class Head>
void read_block(SceneBuilder& build, State& state, const char* what, Head&& head)
{
    const auto guard = build.stream().nest();
    const scene::SourceRef opened = build.open_block(what);
    head();
    while (Items::match(build, state)) {}
    build.close_block(what, opened, words_of<Items>);
}
template <class Items, class State>
void read_block(SceneBuilder& build, State& state, const char* what)
{
    read_block<Items>(build, state, what, [] {});
}

}  // namespace parser
