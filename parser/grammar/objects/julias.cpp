#include "csg/freeform/freeform.h"
#include "parser/grammar/core/solid_reader.h"

#include <algorithm>
#include <cmath>

/// julia_fractal (reference manual: Julia Fractal).
namespace parser {
namespace {

using Function = scene::JuliaFractal::Function;
using Drawn = csg::JuliaTerms::Function;

constexpr double kNoSlice = 1e-10;  // a normal is too short, or does not lean into the fourth dimension (spec 5b, 12.1)
constexpr double kMostIterations = 1e6;  // what does not end is of no use

/// Drawn: of hypercomplex numbers.
constexpr struct {
    Kind keyword;
    Function function;
    Drawn drawn;
} kFunctions[] = {{Kind::Sqr, Function::Sqr, Drawn::HyperSquare},
                  {Kind::Cube, Function::Cube, Drawn::HyperCube},
                  {Kind::Reciprocal, Function::Reciprocal, Drawn::Reciprocal},
                  {Kind::Exp, Function::Exp, Drawn::Exp},
                  {Kind::Ln, Function::Ln, Drawn::Ln},
                  {Kind::Sin, Function::Sin, Drawn::Sin},
                  {Kind::Asin, Function::Asin, Drawn::Asin},
                  {Kind::Cos, Function::Cos, Drawn::Cos},
                  {Kind::Acos, Function::Acos, Drawn::Acos},
                  {Kind::Tan, Function::Tan, Drawn::Tan},
                  {Kind::Atan, Function::Atan, Drawn::Atan},
                  {Kind::Sinh, Function::Sinh, Drawn::Sinh},
                  {Kind::Asinh, Function::Asinh, Drawn::Asinh},
                  {Kind::Cosh, Function::Cosh, Drawn::Cosh},
                  {Kind::Acosh, Function::Acosh, Drawn::Acosh},
                  {Kind::Tanh, Function::Tanh, Drawn::Tanh},
                  {Kind::Atanh, Function::Atanh, Drawn::Atanh},
                  {Kind::Pwr, Function::Pwr, Drawn::Power}};

Drawn drawn_of(const scene::JuliaFractal& julia)
{
    if (!julia.hypercomplex) return julia.function == Function::Cube ? Drawn::Cube : Drawn::Square;
    return std::find_if(std::begin(kFunctions), std::end(kFunctions),
                        [&](const auto& one) { return one.function == julia.function; })
        ->drawn;
}

struct JuliaState : ParameterState<scene::JuliaFractal> {
    using ParameterState::ParameterState;
    bool leaning = true;  ///< each slice into the fourth dimension
};
struct slice : item<Kind::Slice, a_vector4, opt_comma, a_number> {
    static void act(JuliaState& s)
    {
        s.solid.slice_distance = s.pop_float();
        s.solid.slice = s.pop<glm::dvec4>();
        if (glm::length(*s.solid.slice) == 0.0) s.fail("the slice's normal is zero");
        s.leaning = s.leaning && !(std::abs(s.solid.slice->w) < kNoSlice);
    }
};
struct max_iteration : item<Kind::MaxIteration, a_number> {
    static void act(JuliaState& s)
    {
        s.solid.max_iteration = static_cast<int>(std::clamp(s.pop_float(), 1.0, kMostIterations));
    }
};
struct precision : item<Kind::Precision, a_number> {
    static void act(JuliaState& s) { s.solid.precision = std::max(s.pop_float(), 1.0); }
};
struct julia_function : taker<julia_function> {
    static bool take(TokenStream& in, JuliaState& s)
    {
        const Kind kind = in.peek().kind;
        const auto* found = std::find_if(std::begin(kFunctions), std::end(kFunctions),
                                         [&](const auto& one) { return one.keyword == kind; });
        if (found == std::end(kFunctions)) return false;
        in.next();
        s.solid.function = found->function;
        if (kind != Kind::Pwr) return true;
        in.expect(Kind::LeftParen, "'(' after pwr");
        read_values(in, s.solid.exponent.x, s.solid.exponent.y);
        in.expect(Kind::RightParen, "')' after pwr's two numbers");
        return true;
    }
    static Form form()
    {
        std::vector<Form> all;
        for (const auto& one : kFunctions)
            if (one.keyword != Kind::Pwr) all.push_back(Form::token(one.keyword));
        all.push_back(form_of<seq<token<Kind::Pwr>, token<Kind::LeftParen>, a_number, opt_comma, a_number,
                                  token<Kind::RightParen>>>());
        return Form::choice(std::move(all));
    }
};
using scene::JuliaFractal;
using julia_rule =
    seq<values<&JuliaFractal::constant>,
        pegtl::star<
            pegtl::sor<slice, max_iteration, precision, chosen<Kind::Quaternion, &JuliaFractal::hypercomplex, false>,
                       chosen<Kind::Hypercomplex, &JuliaFractal::hypercomplex, true>, julia_function>>>;

}  // namespace

Form parameters_form(const SolidReader*, const JuliaFractal*, Kind) { return form_of<julia_rule>(); }

bool read_parameters(SolidReader& s, JuliaFractal& julia)
{
    JuliaState state(s, julia);
    read_solid<julia_rule>(state);
    if (!julia.hypercomplex && julia.function != Function::Sqr && julia.function != Function::Cube)
        s.fail("a quaternion julia_fractal knows sqr and cube alone; see hypercomplex");
    if (!state.leaning) s.in().fail(s.source(), "the slice's normal must have a fourth component that is not 0");

    csg::JuliaTerms terms;
    terms.constant = julia.constant;
    terms.function = drawn_of(julia);
    terms.exponent = julia.exponent;
    terms.iterations = julia.max_iteration;
    terms.precision = julia.precision;
    if (julia.slice) terms.slice = *julia.slice;
    terms.slice_distance = julia.slice_distance;
    terms.as_37 = s.in().povray() == scene::PovRay::V37;
    s.object().shape = scene::Freeform{csg::make_freeform<csg::Julia>(terms)};
    return true;
}

}  // namespace parser
