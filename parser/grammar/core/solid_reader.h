#pragma once

#include "parser/grammar/core/rules.h"
#include "render/scene/solids.h"

/// Solids whose parameters are structs of their own (render/scene/solids.h).
namespace parser {

class SolidReader;

/// Declares, for one solid of the list, the functions that its grammar file defines: read_parameters() reads from
/// behind the brace to the first modifier and fills the parameters and reader.object().shape (false: such a one cannot
/// be drawn yet); parameters_form() says what it reads. A friend of a base class is found by its arguments wherever a
/// SolidReader is one of them, so the list of scene::AnySolid is the only one: a solid without them does not link, and
/// the linker names it.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wnon-template-friend"  // no template is meant
#endif
template <class Solid>
struct SolidGrammar {
    friend bool read_parameters(SolidReader& reader, Solid& solid);
    friend Form parameters_form(const SolidReader*, const Solid*, Kind);
};
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
template <class List>
struct SolidGrammars;
template <class... Solids>
struct SolidGrammars<std::variant<Solids...>> : SolidGrammar<Solids>... {};

class SolidReader : public BlockState, SolidGrammars<scene::AnySolid> {
public:
    SolidReader(SceneBuilder& builder, scene::Object& object)
        : BlockState(builder), keyword_(builder.stream().taken_last().kind), source_(stream().last()), object_(object)
    {}
    TokenStream& in() { return stream(); }
    Kind keyword() const { return keyword_; }
    /// Of the keyword.
    const scene::SourceRef& source() const { return source_; }
    scene::Object& object() { return object_; }
    /// The parameters being read, for a shape that is made of them later.
    std::shared_ptr<const scene::WrittenSolid> written;

private:
    Kind keyword_;
    scene::SourceRef source_;
    scene::Object& object_;
};

/// What the rules of a solid's parameters work on.
template <class Solid>
struct ParameterState : BlockState {
    ParameterState(SolidReader& r, Solid& s) : BlockState(r.build), reader(r), solid(s) {}
    Solid& subject() { return solid; }
    SolidReader& reader;
    Solid& solid;
};
template <class Rule, class State>
void read_solid(State& state)
{
    TokenInput input(state.stream());
    pegtl::parse<Rule, action, control>(input, state);
}
template <class Rule, class Solid>
void read_solid(SolidReader& reader, Solid& solid)
{
    ParameterState<Solid> state(reader, solid);
    read_solid<Rule>(state);
}

/// Reads the parameters of the solid that the keyword names, if it is one, into object.written.
using SolidHead = bool (*)(SolidReader&);
/// Null: the keyword names none of them.
SolidHead solid_head(Kind keyword);
/// All of them.
std::vector<Form> written_solids();
/// A solid's keyword and block.
Form solid_form(Kind keyword, Form head);

// Whether `sturm` and `hierarchy` may stand among the modifiers of the object's solid, and whether `inverse` is
// ignored.
bool takes_sturm(const scene::Object& object);
bool takes_hierarchy(const scene::Object& object);
bool kind_forgets_inverse(const scene::Object& object);

/// Points of an outline nearer than this are the same, as where it closes.
inline constexpr double kSamePoint = 1e-10;
/// How many points or spheres follow.
int read_count(TokenStream& in);
/// A number of points, then the points. `check` looks at the number.
template <auto Member, auto check>
struct counted : taker<counted<Member, check>>, always {
    static bool take(TokenStream& in, auto& state)
    {
        const int count = read_count(in);
        check(state, count);
        for (int i = 0; i < count; ++i) {
            in.accept_comma();
            read_value(in, member_of<Member>(state).emplace_back());
        }
        return true;
    }
    static Form form()
    {
        const typename MemberOf<Member>::type::value_type* const point = nullptr;
        return Form::sequence(
            {Form::named(number_form), Form::repeated(Form::sequence({form_of<opt_comma>(), forms::of_value(point)}))});
    }
};
/// Our root solvers have no use for the choice of one.
using sturms = pegtl::star<ignored<Kind::Sturm>>;
template <auto open>
using open_and_sturm = pegtl::star<pegtl::sor<word<Kind::Open, open>, ignored<Kind::Sturm>>>;

}  // namespace parser
