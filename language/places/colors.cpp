#include "language/places/colors.h"

#include "parser/lexer/color_word.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace language {

using parser::Kind;

namespace {

constexpr std::size_t kMostSwatches = 5000;

/// A number with its sign; moves behind it.
bool number_at(const Document& document, std::size_t& at, double& value)
{
    double sign = 1;
    std::size_t here = at;
    for (; document.kind(here) == Kind::Minus || document.kind(here) == Kind::Plus; ++here)
        if (document.kind(here) == Kind::Minus) sign = -sign;
    if (document.kind(here) != Kind::Number) return false;
    value = sign * document.tokens()[here].number;
    at = here + 1;
    return true;
}

/// `<a, b, c>` or one number for all; moves behind it.
bool numbers_at(const Document& document, std::size_t& at, std::size_t count, std::array<double, 5>& values)
{
    if (document.kind(at) != Kind::Less) {
        double value = 0;
        if (!number_at(document, at, value)) return false;
        std::fill_n(values.begin(), count, value);
        return true;
    }
    ++at;
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0 && document.kind(at) == Kind::Comma) ++at;
        if (!number_at(document, at, values[i])) return false;
    }
    return document.kind(at++) == Kind::Greater;
}

bool continues_expression(Kind kind)
{
    return kind == Kind::Star || kind == Kind::Slash || kind == Kind::Plus || kind == Kind::Minus ||
           kind == Kind::Period;
}

/// IEC 61966-2-1.
double encoded(double light)
{
    if (light >= 1) return 1;
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}
double decoded(double screen) { return screen <= 0.04045 ? screen / 12.92 : std::pow((screen + 0.055) / 1.055, 2.4); }

std::string short_number(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", value);
    std::string out = text;
    while (out.back() == '0') out.pop_back();
    if (out.back() == '.') out.pop_back();
    return out == "-0" ? "0" : out;
}

}  // namespace

bool linear_light(const Document& document)
{
    bool linear = false;
    for (std::size_t at = 0; at + 1 < document.tokens().size(); ++at) {
        if (document.kind(at + 1) != Kind::Number) continue;
        const double value = document.tokens()[at + 1].number;
        if (document.kind(at) == Kind::AssumedGamma) return value == 1;
        if (document.kind(at) == Kind::Version) linear = value >= 3.7;
    }
    return linear;
}

std::vector<Swatch> swatches_of(const Document& document, bool linear_light)
{
    std::vector<Swatch> found;
    for (std::size_t at = 0; at < document.tokens().size() && found.size() < kMostSwatches; ++at) {
        const parser::ColorWord keyword = parser::color_word(document.kind(at));
        const auto count = static_cast<std::size_t>(keyword.components);
        if (count == 0) continue;
        Swatch swatch;
        std::size_t end = at + 1;
        if (!numbers_at(document, end, count, swatch.value) || continues_expression(document.kind(end))) continue;
        swatch.word = document.word(at);
        swatch.linear = linear_light && !keyword.encoded;
        if (keyword.transmits) std::swap(swatch.value[3], swatch.value[4]);
        swatch.range = {document.range(at).begin, document.range(end - 1).end};
        found.push_back(std::move(swatch));
        at = end - 1;
    }
    return found;
}

std::array<double, 4> screen_color(const Swatch& swatch)
{
    std::array<double, 4> out{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double value = std::clamp(swatch.value[i], 0.0, 1.0);
        out[i] = swatch.linear ? encoded(value) : value;
    }
    out[3] = std::clamp(1 - swatch.value[3] - swatch.value[4], 0.0, 1.0);
    return out;
}

std::string color_text(const Swatch& swatch, const std::array<double, 4>& screen)
{
    std::string word = swatch.word, numbers;
    for (std::size_t i = 0; i < 3; ++i)
        numbers += (i > 0 ? ", " : "") + short_number(swatch.linear ? decoded(screen[i]) : screen[i]);
    // What is not opaque keeps its way of letting light through; an opaque word gets `t`, which changes no colour.
    const double through = 1 - screen[3];
    if (through > 0 && (word == "rgb" || word == "srgb")) word += 't';
    if (word.ends_with("ft")) {
        const double before = swatch.value[3] + swatch.value[4];
        const double filter = before > 0 ? through * swatch.value[3] / before : 0;
        numbers += ", " + short_number(filter) + ", " + short_number(through - filter);
    } else if (word.ends_with('f') || word.ends_with('t')) {
        numbers += ", " + short_number(through);
    }
    return word + " <" + numbers + ">";
}

}  // namespace language
