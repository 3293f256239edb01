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

bool read_function(SolidReader& s, scene::JuliaFractal& julia)
{
    const Kind kind = s.next_kind();
    const auto* found = std::find_if(std::begin(kFunctions), std::end(kFunctions),
                                     [&](const auto& one) { return one.keyword == kind; });
    if (found == std::end(kFunctions)) return false;
    s.in().next();
    julia.function = found->function;
    if (kind != Kind::Pwr) return true;
    s.in().expect(Kind::LeftParen, "'(' after pwr");
    read_values(s.in(), julia.exponent.x, julia.exponent.y);
    s.in().expect(Kind::RightParen, "')' after pwr's two numbers");
    return true;
}

}  // namespace

bool read_parameters(SolidReader& s, scene::JuliaFractal& julia)
{
    read_value(s.in(), julia.constant);
    bool leaning = true;
    for (;;) {
        if (s.accept(Kind::Slice)) {
            read_values(s.in(), julia.slice.emplace(), julia.slice_distance);
            if (glm::length(*julia.slice) == 0.0) s.fail("the slice's normal is zero");
            leaning = leaning && !(std::abs(julia.slice->w) < kNoSlice);
        } else if (s.accept(Kind::MaxIteration)) {
            julia.max_iteration = static_cast<int>(std::clamp(float_expr(s.in()), 1.0, kMostIterations));
        } else if (s.accept(Kind::Precision)) {
            julia.precision = std::max(float_expr(s.in()), 1.0);
        } else if (s.accept(Kind::Quaternion)) {
            julia.hypercomplex = false;
        } else if (s.accept(Kind::Hypercomplex)) {
            julia.hypercomplex = true;
        } else if (!read_function(s, julia)) {
            break;
        }
    }
    if (!julia.hypercomplex && julia.function != Function::Sqr && julia.function != Function::Cube)
        s.fail("a quaternion julia_fractal knows sqr and cube alone; see hypercomplex");
    if (!leaning) s.in().fail(s.source(), "the slice's normal must have a fourth component that is not 0");

    csg::JuliaTerms terms;
    terms.constant = julia.constant;
    terms.function = drawn_of(julia);
    terms.exponent = julia.exponent;
    terms.iterations = julia.max_iteration;
    terms.precision = julia.precision;
    if (julia.slice) terms.slice = *julia.slice;
    terms.slice_distance = julia.slice_distance;
    s.object().shape = scene::Freeform{csg::make_freeform<csg::Julia>(terms)};
    return true;
}

}  // namespace parser
