#include "bench/numerics/forms.h"
#include "csg/freeform/freeform.h"

#include <array>
#include <cmath>

// Spheres along a curve: a point is inside where the squared distance from a centre, less the squared radius, is
// nowhere above 0.
namespace numerics {
namespace {

const std::vector<csg::SphereSweep::SweptSphere> kSpheres{{{-1, -0.8, 0}, 0.2},
                                                          {{-0.6, 0.4, 0.3}, 0.3},
                                                          {{0.1, 0.7, -0.4}, 0.15},
                                                          {{0.7, -0.2, 0.2}, 0.35},
                                                          {{1, -0.9, -0.3}, 0.2}};

std::function<csg::Solid(const csg::Transform&, double)> sweep(csg::SphereSweep::Spline spline)
{
    const auto shape = csg::make_freeform<csg::SphereSweep>(spline, kSpheres);
    return [shape](const csg::Transform& frame, double) { return csg::Solid(csg::Freeform{shape, frame}); };
}

Form linear_sweep_form()
{
    return {.name = "sweep_linear", .make = sweep(csg::SphereSweep::Spline::Linear), .holds = [](const WidePoint& p) {
                for (std::size_t i = 0; i + 1 < kSpheres.size(); ++i) {
                    const auto &a = kSpheres[i], &b = kSpheres[i + 1];
                    // |p - a - u w|^2 - (r + u dr)^2, least at an end or at its turn.
                    const Wide wx = static_cast<Wide>(b.center.x) - a.center.x,
                               wy = static_cast<Wide>(b.center.y) - a.center.y,
                               wz = static_cast<Wide>(b.center.z) - a.center.z;
                    const Wide x = p.x - a.center.x, y = p.y - a.center.y, z = p.z - a.center.z, r = a.radius,
                               dr = static_cast<Wide>(b.radius) - a.radius;
                    const Wide square = wx * wx + wy * wy + wz * wz - dr * dr,
                               half = -(x * wx + y * wy + z * wz) - r * dr, rest = x * x + y * y + z * z - r * r;
                    const Wide u = square > 0 ? std::min(std::max(-half / square, Wide(0)), Wide(1)) : 0;
                    for (const Wide at : {Wide(0), u, Wide(1)})
                        if ((square * at + 2 * half) * at + rest <= 0) return true;
                }
                return false;
            }};
}

/// Segment i of the curved sweep as powers of its place u, in numbers of type T.
template <class T>
struct SweepSegment {
    std::array<std::array<T, 4>, 4> c;  ///< of x, y, z and the radius

    explicit SweepSegment(std::size_t i)
    {
        for (std::size_t axis = 0; axis < 4; ++axis) {
            const auto of = [&](std::size_t k) {
                const auto& sphere = kSpheres[i + k];
                return static_cast<Wide>(axis < 3 ? sphere.center[static_cast<int>(axis)] : sphere.radius);
            };
            c[axis] = {static_cast<T>((of(0) + 4 * of(1) + of(2)) / 6), static_cast<T>((of(2) - of(0)) / 2),
                       static_cast<T>((of(0) - 2 * of(1) + of(2)) / 2),
                       static_cast<T>((of(3) - 3 * of(2) + 3 * of(1) - of(0)) / 6)};
        }
    }

    struct Distance {
        T value, slope, bend;
    };
    /// The squared distance of p from the sphere's centre less the squared radius, and its derivatives by u.
    Distance at(T x, T y, T z, T u) const
    {
        Distance d{0, 0, 0};
        const T p[4] = {x, y, z, 0};
        for (std::size_t axis = 0; axis < 4; ++axis) {
            const auto& [c0, c1, c2, c3] = c[axis];
            const T sign = axis < 3 ? 1 : -1, from = ((c3 * u + c2) * u + c1) * u + c0 - p[axis],
                    way = (3 * c3 * u + 2 * c2) * u + c1;
            d.value += sign * from * from;
            d.slope += 2 * sign * from * way;
            d.bend += 2 * sign * (way * way + from * (6 * c3 * u + 2 * c2));
        }
        return d;
    }
    /// The least value between lo and hi, where there is one turn: Newton, halving where that leaves the range.
    T least(T x, T y, T z, T lo, T hi, T& u) const
    {
        for (int step = 0; step < 60; ++step) {
            const Distance d = at(x, y, z, u);
            (d.slope > 0 ? hi : lo) = u;
            T next = d.bend > 0 ? u - d.slope / d.bend : lo;
            if (!(next > lo && next < hi)) next = (lo + hi) / 2;
            // The value is flat there: half of its digits are enough for the place.
            const bool close = std::abs(next - u) < T(1e-11);
            u = next;
            if (close) break;
        }
        return at(x, y, z, u).value;
    }
};

/// What `holds` of the curved sweep says: in doubles where they leave no doubt.
class QuickSweep {
public:
    QuickSweep()
    {
        for (std::size_t i = 0; i + 3 < kSpheres.size(); ++i) {
            plain_.emplace_back(i);
            wide_.emplace_back(i);
            csg::Aabb box;
            for (std::size_t k = i; k < i + 4; ++k)
                for (const double side : {-1.0, 1.0}) box.include(kSpheres[k].center + side * (kLargest + kDoubt));
            boxes_.push_back(box);
        }
    }

    bool operator()(const WidePoint& p) const
    {
        const glm::dvec3 q{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
        for (std::size_t i = 0; i < boxes_.size(); ++i)
            if (glm::all(glm::lessThanEqual(boxes_[i].lower, q)) && glm::all(glm::lessThanEqual(q, boxes_[i].upper)) &&
                in_segment(p, q, i))
                return true;
        return false;
    }

private:
    static constexpr int kSteps = 24;
    /// A value is a sum of four squares of numbers below 4: doubles keep 1e-14 of it.
    static constexpr double kDoubt = 1e-12;
    static constexpr double kLargest = 0.35;  ///< no sphere is larger

    bool in_segment(const WidePoint& p, const glm::dvec3& q, std::size_t i) const
    {
        const SweepSegment<double>& segment = plain_[i];
        std::array<double, kSteps + 1> values;
        for (int k = 0; k <= kSteps; ++k) {
            values[static_cast<std::size_t>(k)] = segment.at(q.x, q.y, q.z, static_cast<double>(k) / kSteps).value;
            if (values[static_cast<std::size_t>(k)] < -kDoubt) return true;
        }
        const auto value = [&](int k) { return values[static_cast<std::size_t>(k)]; };
        for (int k = 0; k <= kSteps; ++k) {
            if ((k > 0 && value(k - 1) < value(k)) || (k < kSteps && value(k + 1) < value(k)) || value(k) > 0.05)
                continue;
            const double lo = std::max(k - 1, 0) / static_cast<double>(kSteps),
                         hi = std::min(k + 1, kSteps) / static_cast<double>(kSteps);
            double u = static_cast<double>(k) / kSteps;
            const double least = segment.least(q.x, q.y, q.z, lo, hi, u);
            if (least < -kDoubt) return true;
            if (least > kDoubt) continue;
            Wide place = u;
            if (wide_[i].least(p.x, p.y, p.z, lo, hi, place) <= 0) return true;
        }
        return false;
    }

    std::vector<SweepSegment<double>> plain_;
    std::vector<SweepSegment<Wide>> wide_;
    std::vector<csg::Aabb> boxes_;
};

Form curved_sweep_form()
{
    /// Negative inside the sphere at place u of segment i.
    const auto outside = [](const WidePoint& p, std::size_t i, Wide u) {
        const Wide v = 1 - u, w[4] = {v * v * v / 6, (4 - 6 * u * u + 3 * u * u * u) / 6,
                                      (1 + 3 * u + 3 * u * u - 3 * u * u * u) / 6, u * u * u / 6};
        Wide x = p.x, y = p.y, z = p.z, r = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto& b = kSpheres[i + k];
            x -= w[k] * b.center.x, y -= w[k] * b.center.y, z -= w[k] * b.center.z, r += w[k] * b.radius;
        }
        return x * x + y * y + z * z - r * r;
    };
    return {.name = "sweep_b_spline",
            .make = sweep(csg::SphereSweep::Spline::B),
            .holds =
                [outside](const WidePoint& p) {
                    constexpr int kSteps = 24;
                    for (std::size_t i = 0; i + 3 < kSpheres.size(); ++i) {
                        Wide values[kSteps + 1];
                        for (int k = 0; k <= kSteps; ++k) {
                            values[k] = outside(p, i, static_cast<Wide>(k) / kSteps);
                            if (values[k] <= 0) return true;
                        }
                        for (int k = 0; k <= kSteps; ++k) {
                            if ((k > 0 && values[k - 1] < values[k]) || (k < kSteps && values[k + 1] < values[k]) ||
                                values[k] > 0.05L)
                                continue;
                            Wide lo = std::max(k - 1, 0) / static_cast<Wide>(kSteps),
                                 hi = std::min(k + 1, kSteps) / static_cast<Wide>(kSteps);
                            for (int step = 0; step < 70;
                                 ++step) {  // by thirds: half of the digits of the place, all of the value's
                                const Wide a = lo + (hi - lo) / 3, b = hi - (hi - lo) / 3;
                                (outside(p, i, a) < outside(p, i, b) ? hi : lo) =
                                    outside(p, i, a) < outside(p, i, b) ? b : a;
                            }
                            if (outside(p, i, (lo + hi) / 2) <= 0) return true;
                        }
                    }
                    return false;
                },
            .quick = QuickSweep(),
            .looks = 150};
}

}  // namespace

std::vector<Form> sweep_forms() { return {linear_sweep_form(), curved_sweep_form()}; }

}  // namespace numerics
