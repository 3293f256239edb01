#include "csg/freeform/sphere_sweep.h"

#include "csg/freeform/bernstein.h"
#include "csg/freeform/similarity.h"
#include "csg/solids/common.h"
#include "csg/traverse.h"

namespace csg {
namespace {

constexpr int kHalvings = 40;
constexpr std::uint32_t kPlaceBits = 12, kPlaces = (1u << kPlaceBits) - 1;      // of the place on a segment in a face's number
constexpr std::size_t kMostSegments = (std::size_t{1} << (32 - kPlaceBits)) - 2;

std::uint32_t face_of(std::uint32_t segment, double u)
{
    return segment << kPlaceBits | static_cast<std::uint32_t>(glm::clamp(u, 0.0, 1.0) * kPlaces + 0.5);
}

glm::dvec4 joined(const SphereSweep::Ball& ball) { return {ball.center, ball.radius}; }

bool finite(const glm::dvec4& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w); }

/// What a line has in the balls of a segment: the ball at u is met at m(u) -+ sqrt(reach(u)). Both by Bernstein ordinates.
template <std::size_t count>
struct Balls {
    std::array<double, count> m;
    std::array<double, 2 * count - 1> reach;
};

/// The ends of the union of these intervals over [a, b], where none is empty: they are at one of its ends, or where
/// m' = +-reach' / (2 sqrt(reach)).
template <std::size_t count>
class Extremes {
public:
    explicit Extremes(const Balls<count>& balls) : balls_(balls)
    {
        const auto rate = derivative(balls.reach);
        const auto way = derivative(balls.m);
        auto turn = product(rate, rate);
        const auto both = product(product(way, way), balls.reach);
        for (std::size_t i = 0; i < turn.size(); ++i) turn[i] -= 4.0 * both[i];
        const auto keep = [&](double u) {
            places_[count_++] = u;
            return count_ < places_.size();
        };
        each_change(turn, 0.0, 1.0, kHalvings, keep);
        // Across the line m' vanishes, and these are double.
        if (count_ < places_.size()) each_change(rate, 0.0, 1.0, kHalvings, keep);
    }

    template <class End>
    void find(double a, double b, End& in, End& out) const
    {
        in = {kInfinity, a};
        out = {-kInfinity, a};
        offer(a, in, out);
        offer(b, in, out);
        for (std::size_t i = 0; i < count_; ++i)
            if (places_[i] > a && places_[i] < b) offer(places_[i], in, out);
    }

private:
    template <class End>
    void offer(double u, End& in, End& out) const
    {
        double m = 0.0, reach = 0.0, unused = 0.0;
        detail::casteljau(balls_.m, u, m, unused);
        detail::casteljau(balls_.reach, u, reach, unused);
        const double half = std::sqrt(std::max(reach, 0.0));
        if (m - half < in.t) in = {m - half, u};
        if (m + half > out.t) out = {m + half, u};
    }

    const Balls<count>& balls_;
    std::array<double, 6 * count> places_;
    std::size_t count_ = 0;
};

/// f(in, out) for each interval of the line in the union of the balls.
template <class End, std::size_t count, class F>
void each_interval(const Balls<count>& balls, F&& f)
{
    bool met = balls.reach[0] > 0.0;
    if (!met && ordinate_changes(balls.reach) == 0) return;
    const Extremes<count> extremes(balls);
    double since = 0.0;
    const auto end = [&](double u) {
        End in, out;
        extremes.find(since, u, in, out);
        f(in, out);
    };
    each_change(balls.reach, 0.0, 1.0, kHalvings, [&](double u) {
        if (met) end(u);
        since = u;
        met = !met;
        return true;
    });
    if (met) end(1.0);
}

/// `direction` of unit length; from(k): control point k from a point of the line, and its radius.
template <std::size_t count, class From>
Balls<count> balls_along(const glm::dvec3& direction, From&& from)
{
    Balls<count> balls;
    std::array<double, count> r, aside[3];
    for (std::size_t k = 0; k < count; ++k) {
        const glm::dvec4 c = from(k);
        balls.m[k] = glm::dot(glm::dvec3(c), direction);
        const glm::dvec3 side = glm::dvec3(c) - balls.m[k] * direction;
        for (int i = 0; i < 3; ++i) aside[i][k] = side[i];
        r[k] = c.w;
    }
    balls.reach = product(r, r);
    for (const auto& axis : aside) {
        const auto square = product(axis, axis);
        for (std::size_t i = 0; i < square.size(); ++i) balls.reach[i] -= square[i];
    }
    return balls;
}

/// Whether the point lies in one of the balls.
template <std::size_t count, class From>
bool within(From&& from)
{
    std::array<double, count> part[4];
    for (std::size_t k = 0; k < count; ++k)
        for (int i = 0; i < 4; ++i) part[i][k] = from(k)[i];
    auto reach = product(part[3], part[3]);
    for (int axis = 0; axis < 3; ++axis) {
        const auto square = product(part[axis], part[axis]);
        for (std::size_t i = 0; i < square.size(); ++i) reach[i] -= square[i];
    }
    bool found = reach.front() >= 0.0 || reach.back() >= 0.0;
    if (!found) each_change(reach, 0.0, 1.0, kHalvings, [&](double) { found = true; return false; });
    return found;
}

}  // namespace

glm::dvec4 SphereSweep::Segment::at(double u) const
{
    const double v = 1.0 - u;
    if (linear) return v * control[0] + u * control[1];
    return v * v * v * control[0] + 3.0 * v * v * u * control[1] + 3.0 * v * u * u * control[2] + u * u * u * control[3];
}

glm::dvec4 SphereSweep::Segment::rate(double u) const
{
    const double v = 1.0 - u;
    if (linear) return control[1] - control[0];
    return 3.0 * (v * v * (control[1] - control[0]) + 2.0 * v * u * (control[2] - control[1]) + u * u * (control[3] - control[2]));
}

SphereSweep::SphereSweep(Spline spline, std::span<const Ball> balls) : spline_(spline), balls_(balls.begin(), balls.end())
{
    const std::size_t wanted = spline == Spline::Linear ? 2 : 4;
    for (std::size_t i = 0; i + wanted <= balls.size() && segments_.size() < kMostSegments; ++i) {
        const glm::dvec4 a = joined(balls[i]), b = joined(balls[i + 1]);
        if (spline == Spline::Linear) {
            add({{a, b, b, b}, true});
            continue;
        }
        const glm::dvec4 c = joined(balls[i + 2]), d = joined(balls[i + 3]);
        if (spline == Spline::Cubic) add({{b, b + (c - a) / 6.0, c - (d - b) / 6.0, c}, false});
        else add({{(a + 4.0 * b + c) / 6.0, (2.0 * b + c) / 3.0, (b + 2.0 * c) / 3.0, (b + 4.0 * c + d) / 6.0}, false});
    }
    for (const Aabb& box : boxes_) box_.include(box);
    if (box_.empty()) return;
    middle_ = 0.5 * (box_.lower + box_.upper);
    if (segments_.size() <= kMostLoose) return;
    std::vector<BvhInput> inputs;
    for (std::size_t i = 0; i < boxes_.size(); ++i) inputs.push_back({.bounds = boxes_[i], .index = static_cast<std::uint32_t>(i)});
    tree_ = build_bvh(std::move(inputs));
}

void SphereSweep::add(const Segment& segment)
{
    Aabb box;
    for (const glm::dvec4& c : segment.control) {
        if (!finite(c)) return;
        box.include({glm::dvec3(c) - std::abs(c.w), glm::dvec3(c) + std::abs(c.w)});
    }
    segments_.push_back(segment);
    boxes_.push_back(padded(box));
}

Aabb SphereSweep::extent(const Transform& moved) const
{
    const double times = spline_ == Spline::Cubic ? 2.0 : 1.0;
    double factor = 1.0;
    const bool round = keeps_balls(moved.linear, factor);
    Aabb box;
    for (const Ball& ball : balls_) {
        const double reach = times * std::abs(ball.radius) * (round ? factor : 1.0);
        const glm::dvec3 c = round ? moved.point(ball.center) : ball.center;
        box.include({c - reach, c + reach});
    }
    return round ? box : transformed_box(moved, box);
}

void SphereSweep::gather(std::uint32_t index, const Ray& ray, std::vector<Piece>& out) const
{
    const Segment& segment = segments_[index];
    const double length = std::sqrt(glm::dot(ray.direction, ray.direction));
    const glm::dvec3 direction = ray.direction / length;
    const auto from = [&](std::size_t k) { return segment.control[k] - glm::dvec4(ray.origin, 0.0); };
    const auto keep = [&](const End& in, const End& end) { out.push_back({{in.t / length, in.u}, {end.t / length, end.u}, index}); };
    if (segment.linear) each_interval<End>(balls_along<2>(direction, from), keep);
    else each_interval<End>(balls_along<4>(direction, from), keep);
}

void SphereSweep::meet(const Ray& ray, RayRecord& out) const
{
    if (segments_.empty()) return;
    thread_local std::vector<Piece> pieces;
    pieces.clear();
    // From the point nearest to the middle, so that the way there does not set the rounding.
    const double start = -glm::dot(ray.origin - middle_, ray.direction) / glm::dot(ray.direction, ray.direction);
    if (!std::isfinite(start)) return;
    const Ray near{ray.at(start), ray.direction};
    if (tree_.nodes.empty()) {
        for (std::uint32_t i = 0; i < segments_.size(); ++i) gather(i, near, pieces);
    } else {
        const double limit = std::max(out.to - start, 0.0);  // below 0 the walk would end
        traverse(tree_, RaySlabs(near), out.from - start, limit, ~0u, [&](ChildWord leaf) {
            gather(leaf.index(), near, pieces);
            return limit;
        });
    }
    std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
        return a.in.t != b.in.t ? a.in.t < b.in.t : a.segment < b.segment;
    });
    for (std::size_t i = 0; i < pieces.size();) {
        const Piece& first = pieces[i];
        if (!out.enter(start + first.in.t, face_of(first.segment, first.in.u))) return;
        const Piece* last = &first;
        for (++i; i < pieces.size() && pieces[i].in.t <= last->out.t; ++i)
            if (pieces[i].out.t > last->out.t) last = &pieces[i];
        if (!out.leave(start + last->out.t, face_of(last->segment, last->out.u))) return;
    }
}

bool SphereSweep::contains(const glm::dvec3& p) const
{
    for (std::size_t i = 0; i < segments_.size(); ++i) {
        const Aabb& box = boxes_[i];
        if (!(glm::all(glm::lessThanEqual(box.lower, p)) && glm::all(glm::lessThanEqual(p, box.upper)))) continue;
        const auto from = [&](std::size_t k) { return segments_[i].control[k] - glm::dvec4(p, 0.0); };
        if (segments_[i].linear ? within<2>(from) : within<4>(from)) return true;
    }
    return false;
}

glm::dvec3 SphereSweep::gradient(const glm::dvec3& p, std::uint32_t face) const
{
    const Segment& segment = segments_[std::min<std::size_t>(face >> kPlaceBits, segments_.size() - 1)];
    const double place = static_cast<double>(face & kPlaces) / kPlaces, step = 1.0 / kPlaces;
    double low = std::max(0.0, place - step), high = std::min(1.0, place + step);
    // The ball that touches p there: the distance from its surface is least.
    const auto grows = [&](double u) {
        const glm::dvec4 c = segment.at(u), rate = segment.rate(u);
        return glm::dot(glm::dvec3(c) - p, glm::dvec3(rate)) - c.w * rate.w > 0.0;
    };
    if (grows(low)) high = low;
    else if (!grows(high)) low = high;
    while (low < high) {
        const double middle = 0.5 * (low + high);
        if (middle == low || middle == high) break;
        (grows(middle) ? high : low) = middle;
    }
    const glm::dvec4 c = segment.at(low);
    return (p - glm::dvec3(c)) * (c.w < 0.0 ? -1.0 : 1.0);
}

}  // namespace csg
