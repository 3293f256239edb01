#include "parser/stream/expression.h"
#include "parser/stream/functions/function.h"

#include <fmt/format.h>

namespace parser {
namespace {

using Kinds = function::Spline::Kind;

std::optional<Kinds> accept_kind(TokenStream& stream)
{
    if (stream.accept(Kind::LinearSpline)) return Kinds::Linear;
    if (stream.accept(Kind::QuadraticSpline)) return Kinds::Quadratic;
    if (stream.accept(Kind::CubicSpline)) return Kinds::Cubic;
    if (stream.accept(Kind::NaturalSpline)) return Kinds::Natural;
    return std::nullopt;
}

}  // namespace

SplinePtr read_spline(TokenStream& stream)
{
    stream.next();
    const bool raw = stream.raw_operators();
    stream.set_raw_operators(false);
    const scene::SourceRef opened = stream.here();
    stream.expect(Kind::LeftBrace, "'{' after spline");
    auto spline = std::make_shared<function::Spline>();
    const scene::SourceRef at = stream.here();
    if (const auto base = stream.accept_identifier<SplinePtr>()) *spline = **base;
    while (const auto kind = accept_kind(stream)) spline->kind = *kind;
    stream.accept_comma();
    while (stream.peek().kind != Kind::RightBrace) {
        const double t = float_expr(stream);
        stream.accept_comma();
        const Tuple value = requested_expr(stream, 2, Level::Full);
        spline->add(t, value.at, static_cast<std::uint32_t>(value.count));
        stream.accept_comma();
    }
    if (spline->size() == 0) stream.fail(at, "this spline has no points");
    spline->finish();
    stream.expect_closing("'}' at the end of the spline", "'spline'", opened);
    stream.set_raw_operators(raw);
    return spline;
}

Tuple call_spline(TokenStream& stream, const function::Spline& spline, const Token& name)
{
    const bool raw = stream.raw_operators();
    stream.set_raw_operators(false);
    if (!stream.accept(Kind::LeftParen))
        stream.fail_expected(fmt::format("'(' after the name of spline {}", stream.word(name)));
    const double t = float_expr(stream);
    Kinds kind = spline.kind;
    if (stream.accept_comma()) {
        const auto wanted = accept_kind(stream);
        if (!wanted) stream.fail_expected("a kind of spline, as in cubic_spline");
        kind = *wanted;
    }
    stream.expect(Kind::RightParen, "')' after the spline's parameter");
    stream.set_raw_operators(raw);
    return {spline.at(t, kind), static_cast<int>(spline.components())};
}

}  // namespace parser
