#include "csg/freeform/isosurface_search.h"

#include <algorithm>

namespace csg {
namespace {

constexpr int kParts = 8;
constexpr double kLeastPart = 0x1p-40;    // of a ray's way through the container: parameters must stay apart
constexpr double kNarrow = 1e-4;          // of the accuracy: a crossing is known as well before its last secant
constexpr double kRoom = 4 * 0x1p-52;     // relative error of a point of the ray, generously

/// Sides of the boxes between t[k] and t[k + 1], with room for rounding.
void sides(double origin, double direction, double from, double step, EightRanges& out)
{
    for (int k = 0; k < kParts; ++k) {
        const double a = origin + (from + k * step) * direction, b = origin + (from + (k + 1) * step) * direction;
        const double room = kRoom * (std::abs(origin) + std::abs(a) + std::abs(b));
        out.low.v[k] = std::min(a, b) - room;
        out.high.v[k] = std::max(a, b) + room;
    }
}

}  // namespace

void IsosurfaceSearch::sample(const Eight& t, double sign, Eight& f) const
{
    EightPoints p;
    for (int k = 0; k < kParts; ++k) {
        p.x.v[k] = ray_.origin.x + t.v[k] * ray_.direction.x;
        p.y.v[k] = ray_.origin.y + t.v[k] * ray_.direction.y;
        p.z.v[k] = ray_.origin.z + t.v[k] * ray_.direction.z;
    }
    terms_.field->values(p, f);
    for (double& v : f.v) v = sign * (v - terms_.threshold);
}

bool IsosurfaceSearch::first(double from, double end, double sign, Crossed& out)
{
    leaf_ = std::max(terms_.accuracy, (end - from) * kLeastPart);
    if (terms_.field->ranged()) return by_ranges(from, end, sign, out);
    if (terms_.evaluate && gradient_ > terms_.growth.x) gradient_ *= terms_.growth.z;
    return bisect({from, sign * value(from)}, {end, sign * value(end)}, sign, out);
}

bool IsosurfaceSearch::by_ranges(double from, double end, double sign, Crossed& out)
{
    const double step = (end - from) / kParts;
    EightBoxes boxes;
    sides(ray_.origin.x, ray_.direction.x, from, step, boxes.x);
    sides(ray_.origin.y, ray_.direction.y, from, step, boxes.y);
    sides(ray_.origin.z, ray_.direction.z, from, step, boxes.z);
    EightRanges f;
    terms_.field->ranges(boxes, f);
    const auto clear = [&](int k) { return (sign > 0.0 ? f.low.v[k] - terms_.threshold : terms_.threshold - f.high.v[k]) > 0.0; };
    if (step >= leaf_) {
        for (int k = 0; k < kParts && from + k * step <= to_; ++k)
            if (!clear(k) && by_ranges(from + k * step, from + (k + 1) * step, sign, out)) return true;
        return false;
    }
    bool all_clear = true;
    for (int k = 0; k < kParts; ++k) all_clear = all_clear && clear(k);
    if (all_clear) return false;
    Eight t, at;
    for (int k = 0; k < kParts; ++k) t.v[k] = from + (k + 1) * step;
    sample(t, sign, at);
    for (int k = 0; k < kParts; ++k) {
        if (clear(k) || !(at.v[k] < 0.0)) continue;
        const double before = k == 0 ? from : t.v[k - 1];
        out = {before, t.v[k], k == 0 ? sign * value(from) : at.v[k - 1], at.v[k]};
        return true;
    }
    return false;
}

/// POV-Ray's own rule (spec 5b, 13.2): halves, the nearer one first, while the ends allow a root under the gradient.
bool IsosurfaceSearch::bisect(const Sample& left, const Sample& right, double sign, Crossed& out)
{
    if (left.t > to_) return false;
    const double length = right.t - left.t, world = speed_ * length;
    if (terms_.evaluate) {
        const double slope = std::abs(right.f - left.f) / world;
        if (gradient_ < slope * terms_.growth.y) gradient_ = slope * terms_.growth.y * terms_.growth.y;
    }
    if (length < leaf_) {
        out = {left.t, right.t, left.f, right.f};
        return right.f < 0.0;
    }
    if (!(left.f + right.f - gradient_ * world < 0.0)) return false;
    const double t = left.t + 0.5 * length;
    const Sample middle{t, sign * value(t)};
    return bisect(left, middle, sign, out) || bisect(middle, right, sign, out);
}

double IsosurfaceSearch::narrow(Crossed c, double sign) const
{
    const auto secant = [&] {
        const double part = c.f_before / (c.f_before - c.f_behind);
        return part > 0.0 && part < 1.0 ? c.before + part * (c.behind - c.before) : 0.5 * (c.before + c.behind);
    };
    constexpr int kMostRounds = 40;
    const double enough = terms_.accuracy * kNarrow;
    for (int round = 0; round < kMostRounds && c.behind - c.before > enough; ++round) {
        // Close about where a secant puts the root, and two far away: smooth fields are done in one round, all in a few.
        static constexpr double kOffsets[] = {-0.25, -2e-2, -1e-3, -3e-5, 3e-5, 1e-3, 2e-2, 0.25};
        const double guess = secant(), width = c.behind - c.before;
        Eight t, f;
        for (int k = 0; k < kParts; ++k) t.v[k] = std::clamp(guess + kOffsets[k] * width, c.before, c.behind);
        sample(t, sign, f);
        for (int k = 0; k < kParts; ++k) {
            if (f.v[k] < 0.0) {
                c.behind = t.v[k];
                c.f_behind = f.v[k];
                break;
            }
            c.before = t.v[k];
            c.f_before = f.v[k];
        }
        if (!(c.behind - c.before < width)) break;  // as near as numbers go
    }
    return secant();
}

}  // namespace csg
