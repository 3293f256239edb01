#include "parser/stream/expressions/operand.h"

#include "parser/lexer/color_word.h"

namespace parser {
namespace {

/// sRGB decoding, then the working curve of assumed_gamma (spec 1, 4).
/// In single precision, as POV-Ray keeps colours.
double from_srgb(double written, const scene::GammaCurve& gamma)
{
    if (gamma.kind == scene::GammaCurve::Kind::Srgb) return written;
    return gamma.curve().encode(image::TransferCurve::srgb().decode(static_cast<float>(written)));
}

int component_item(Kind kind)
{
    switch (kind) {
    case Kind::Red: return 0;
    case Kind::Green: return 1;
    case Kind::Blue: return 2;
    case Kind::Filter:
    case Kind::Alpha: return 3;
    case Kind::Transmit: return 4;
    default: return -1;
    }
}

Tuple read_vector_item(TokenStream& stream, const ColorWord& item, const scene::SourceRef& at)
{
    Tuple value = requested_expr(stream, item.components, Level::Full);
    if (value.count > item.components) stream.warn(at, "this color has more components than its keyword takes");
    if (item.transmits) {
        value.at[4] = value.at[3];
        value.at[3] = 0;
    }
    if (item.encoded) {
        const scene::AssumedGamma& gamma = stream.language().assumed_gamma;
        if (!gamma) stream.fail(at, "sRGB colors need an assumed_gamma before them in global_settings");
        for (std::size_t i = 0; i < 3; ++i) value.at[i] = from_srgb(value.at[i], *gamma);
    }
    value.count = 5;
    return value;
}

}  // namespace

bool at_color(TokenStream& stream) { return at_expression(stream); }

scene::Color color_expr(TokenStream& stream)
{
    const auto guard = stream.nest();
    Tuple color = replicated(0.0, 5);
    bool any = false;
    if (stream.peek().kind == Kind::Color) stream.next();
    for (;; any = true) {
        const Token token = any ? stream.peek_operator() : stream.peek();
        if (const ColorWord item = color_word(token.kind); item.components > 0) {
            if (any) break;
            stream.next();
            color = read_vector_item(stream, item, stream.place(token));
        } else if (const int component = component_item(token.kind); component >= 0) {
            stream.next();
            color.at[static_cast<std::size_t>(component)] = float_expr(stream);
        } else if (!any && at_expression(stream)) {
            color = requested_expr(stream, 5, Level::Full);
        } else {
            break;
        }
    }
    if (!any) stream.fail_expected("a color, as in rgb <1, 0.5, 0>");
    return color.color();
}

scene::Color rgb_expr(TokenStream& stream)
{
    const Token& first = stream.peek();
    const scene::SourceRef at = stream.place(first);
    // A plain number or vector is requested with three components, so that it fills nothing else.
    const bool plain = first.kind != Kind::Color && lexical_class(first.kind) != LexicalClass::Color &&
                       at_expression(stream);
    scene::Color color = plain ? requested_expr(stream, 3, Level::Full).color() : color_expr(stream);
    if (color.filter != 0.0f || color.transmit != 0.0f)
        stream.warn(at, "filter and transmit have no effect on this color");
    color.filter = color.transmit = 0.0f;
    return color;
}

}  // namespace parser
