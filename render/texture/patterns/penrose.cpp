#include "render/texture/patterns/penrose.h"

#include "numbers/functions/functions.h"
#include "numbers/remainder.h"
#include "render/texture/points/angle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texture {
namespace {

constexpr double kGolden = std::numbers::phi;
constexpr double kMargin = 1e-6;  // keeps the ranges of two shapes apart

/// Sine, cosine and tangent of whole degrees, all multiples of 18, made once.
struct Degrees {
    explicit Degrees(int degrees)
        : sine(numbers::sin(degrees * std::numbers::pi / 180.0)),
          cosine(numbers::cos(degrees * std::numbers::pi / 180.0)), tangent(sine / cosine)
    {}
    double sine, cosine, tangent;
};
const Degrees k18(18), k36(36), k54(54), k72(72), k108(108), k126(126), k144(144), k162(162);

glm::dvec2 left(const Degrees& t, const glm::dvec2& p)
{
    return {p.x * t.cosine - p.y * t.sine, p.x * t.sine + p.y * t.cosine};
}
glm::dvec2 right(const Degrees& t, const glm::dvec2& p)
{
    return {p.x * t.cosine + p.y * t.sine, p.y * t.cosine - p.x * t.sine};
}
glm::dvec2 upward(const glm::dvec2& p) { return {p.x, std::abs(p.y)}; }

/// Into the sector of 36 degrees above the x axis, of which ten with their mirror images make the plane.
glm::dvec2 five_fold(glm::dvec2 p)
{
    const double r = std::sqrt(p.x * p.x + p.y * p.y);
    p = upward(p);
    if (p.x >= r * k36.cosine) return p;
    return upward(right(p.x < r * k108.cosine ? k144 : k72, p));
}

/// Distance from the line through (x0, 0) at the angle t.
double from_line(const Degrees& t, double x0, const glm::dvec2& p)
{
    return std::abs(t.sine * (p.x - x0) - t.cosine * p.y);
}
/// Whether the point lies below that line, by its slope.
bool below(const Degrees& t, double x0, const glm::dvec2& p) { return p.y < (p.x - x0) * t.tangent; }

double levels(double size, double growth)
{
    return std::max(0.0, std::ceil(numbers::log(size) / numbers::log(growth)));
}

double low(double a, double b) { return std::min(std::max({0.5 - a / 2.0, 0.5 - b / 2.0, 0.0}), 0.5 - kMargin); }
double high(double a, double b) { return std::max({1.0 - a / 2.0, 1.0 - b / 2.0, 0.5 + kMargin}); }

/// Half kites and half darts, divided from one half kite that holds the point.
double kites(bool rhombs, glm::dvec2 p)
{
    constexpr double kInner = 1.0 / kGolden;
    p = five_fold(p);
    if (rhombs) p *= kInner;
    const double n = levels(std::abs(p.x * k108.sine - p.y * k108.cosine) / k18.cosine, kGolden * kGolden);
    p *= numbers::pow(kGolden, -2.0 * n);
    if (numbers::fmod(n, 2.0) == 1.0) p = upward(right(k36, p));
    bool kite = true;
    for (double level = 0; level < 2.0 * n; ++level) {
        p = upward(p);
        if (kite) {
            kite = !below(k144, kInner, p);
            if (kite) p = left(k108, {p.x - k36.cosine, p.y - k36.sine});
        } else if (below(k108, kInner, p)) {
            kite = true;
            p = right(k36, p);
        } else {
            p = right(k144, {p.x - 1.0, p.y});
        }
        p *= kGolden;
    }
    p = upward(p);
    if (!rhombs) {
        constexpr double k = 4.46;
        return kite ? low(k * from_line(k36, 0, p), k * from_line(k108, 1, p))
                    : high(k * p.y, k * from_line(k144, 1, p));
    }
    constexpr double k = 5.55;
    if (!kite) return low(k * from_line(k36, 0, p), k * from_line(k144, 1, p));
    if (below(k72, kInner, p)) return high(k * from_line(k72, kInner, p), k * from_line(k108, 1, p));
    return low(k * p.y, k * from_line(k72, kInner, p));
}

/// Pieces of the pentagon tiling, by the letters of spec 4, 6.2.
enum class Piece { A, B, B2, C, C2, S, O, O2, D1, D2 };

const double kCorner = 1.0 / (2.0 * k36.sine);   // of a pentagon with sides of 1: from its middle to a corner,
const double kSide = 1.0 / (2.0 * k36.tangent);  // to a side

/// One level down: which piece of the piece holds the point, and the point in its space before it grows.
void divide(Piece& piece, glm::dvec2& p)
{
    const double a = kCorner, m = kSide, inner = a / (kGolden * kGolden);
    const auto become = [&](Piece next, const glm::dvec2& q) { piece = next, p = q; };
    switch (piece) {
    case Piece::A:
        p = five_fold(p);
        if (p.y < (p.x - m) * k54.tangent + 0.5) become(Piece::B, {p.x - m - a / kGolden * k72.cosine, p.y});
        else become(Piece::S, right(k36, p));
        return;
    case Piece::B:
        if (p.y < (p.x + a) * k18.tangent) return become(Piece::D2, {p.x + a - inner, p.y});
        p = right(k36, p);
        return become(Piece::C, {-p.x - a * k72.cosine, p.y - a * k72.sine});
    case Piece::B2:
        if (below(k54, inner, p)) return become(Piece::A, {p.x - a, p.y});
        if (below(k162, inner, p)) return become(Piece::D1, {-p.x, p.y});
        p = left(k108, p);
        return become(Piece::B2, {p.x + a / kGolden, p.y});
    case Piece::C:
        if (p.x < a * k108.cosine) {
            p = right(k144, p);
            return become(Piece::B, {p.x - a, p.y});
        }
        if (p.y <= (p.x - inner) * k126.tangent) return become(Piece::O, p);
        p = left(k36, p);
        return become(Piece::C, {-p.x - a * k72.cosine, p.y - a * k72.sine});
    case Piece::C2:
        if (p.x > inner * k72.cosine) return become(Piece::B2, {-(p.x - inner * k72.cosine - m / kGolden), p.y});
        return become(Piece::O2, p);
    case Piece::S:
        if (p.x < m / kGolden) return become(Piece::A, p);
        return become(Piece::C2, {-(p.x - 2.0 * m / kGolden), p.y});
    case Piece::O: p = left(k72, p); return become(Piece::C2, {p.x + a, p.y});
    case Piece::O2:
        if (p.x > kGolden * a * k108.cosine) return become(Piece::A, {-p.x, p.y});
        return become(Piece::C2, {p.x + a, p.y});
    case Piece::D1: return become(Piece::A, p);
    case Piece::D2: return become(Piece::C2, p);
    }
}

/// The shape that a piece belongs to, 1 to 6, and the distance from its nearest edge in units of the shade's width.
double pentagon_value(Piece piece, const glm::dvec2& p)
{
    constexpr double k = 5.55 / kGolden;
    const double a = kCorner, m = kSide;
    const auto tip = [&](const glm::dvec2& q) { return k * from_line(k162, kGolden * a, q); };
    double shape = 1, distance = 0;
    switch (piece) {
    case Piece::A: shape = 1; break;
    case Piece::B:
    case Piece::B2: shape = 2; break;
    case Piece::C:
    case Piece::C2: shape = 3; break;
    case Piece::S: shape = 4; break;
    case Piece::O:
    case Piece::O2: shape = 5; break;
    case Piece::D1:
    case Piece::D2: shape = 6; break;
    }
    if (shape <= 3) distance = k * std::abs(five_fold(p).x - m);
    else if (shape == 4) distance = tip(p);
    else if (shape == 5) distance = std::min(k * std::abs(p.x - a / kGolden * k72.cosine), tip(five_fold({-p.x, p.y})));
    else distance = k * from_line(k18, -a / kGolden, p);
    const double lower = shape == 1 ? 0.0 : (shape - 1.0) / 6.0 + kMargin;
    return std::min(std::max((shape - distance) / 6.0, lower), shape / 6.0 - kMargin);
}

double pentagons(glm::dvec2 p)
{
    p = five_fold(p);
    const double n = levels(2.0 * p.x * k36.tangent, kGolden * kGolden * kGolden * kGolden);
    p *= numbers::pow(kGolden, -4.0 * n);
    Piece piece = Piece::A;
    for (double level = 0; level < 4.0 * n; ++level) {
        p = upward(p);
        divide(piece, p);
        p *= kGolden;
    }
    return pentagon_value(piece, upward(p));
}

}  // namespace

double penrose(int kind, glm::dvec2 p)
{
    if (std::sqrt(p.x * p.x + p.y * p.y) <= kTiny) return 1.0;
    return kind == 25 ? pentagons(p) : kites(kind == 27, p);
}

}  // namespace texture
