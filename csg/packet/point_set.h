#pragma once

#include "csg/packet/lanes/tile_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

/// Points that rays begin or end at, in vector lanes.
namespace csg {

/// One to kTileRays points; call pad() after the last add() and before anything else.
class PointSet {
public:
    void add(const glm::dvec3& p)
    {
        x_[count_] = p.x, y_[count_] = p.y, z_[count_] = p.z;
        ++count_;
    }
    /// Fills up the last vector with copies of the last point.
    void pad()
    {
        for (std::size_t i = count_; i % lanes::kDoubles != 0; ++i)
            x_[i] = x_[i - 1], y_[i] = y_[i - 1], z_[i] = z_[i - 1];
    }

    glm::dvec3 at(std::size_t i) const { return {x_[i], y_[i], z_[i]}; }
    glm::dvec3 last() const { return at(count_ - 1); }

    glm::dvec3 middle() const
    {
        Double x(0.0), y(0.0), z(0.0);
        double empty = -static_cast<double>(count_);
        each([&](const Double& px, const Double& py, const Double& pz) {
            x += px, y += py, z += pz;
            empty += lanes::kDoubles;
        });
        const glm::dvec3 sum(lanes::sum(x), lanes::sum(y), lanes::sum(z));
        return (sum - empty * last()) / static_cast<double>(count_);
    }

    /// The largest absolute value of each coordinate.
    glm::dvec3 widest() const
    {
        Double x(0.0), y(0.0), z(0.0);
        each([&](const Double& px, const Double& py, const Double& pz) {
            x = xsimd::max(x, xsimd::abs(px)), y = xsimd::max(y, xsimd::abs(py)), z = xsimd::max(z, xsimd::abs(pz));
        });
        return {-lanes::lowest(-x), -lanes::lowest(-y), -lanes::lowest(-z)};
    }

    struct Range {
        double low, high;
    };
    /// Of dot(v, point).
    Range along(const glm::dvec3& v) const
    {
        Double low(kInfinity), high(-kInfinity);
        each([&](const Double& x, const Double& y, const Double& z) {
            const Double d = x * Double(v.x) + y * Double(v.y) + z * Double(v.z);
            low = xsimd::min(low, d), high = xsimd::max(high, d);
        });
        return {lanes::lowest(low), -lanes::lowest(-high)};
    }

    /// A point with the least dot(v, point).
    glm::dvec3 foremost(const glm::dvec3& v) const
    {
        Double low(kInfinity), place(0.0);
        double first = 0.0;
        each([&](const Double& x, const Double& y, const Double& z) {
            const Double d = x * Double(v.x) + y * Double(v.y) + z * Double(v.z);
            place = xsimd::select(d < low, Double(first), place);
            low = xsimd::min(low, d);
            first += lanes::kDoubles;
        });
        alignas(64) std::array<double, lanes::kDoubles> lows, places;
        low.store_aligned(lows.data());
        place.store_aligned(places.data());
        const auto lane = static_cast<std::size_t>(std::min_element(lows.begin(), lows.end()) - lows.begin());
        return at(static_cast<std::size_t>(places[lane]) + lane);
    }

    /// How far the farthest is from a place.
    double farthest(const glm::dvec3& from) const
    {
        Double most(0.0);
        each([&](const Double& x, const Double& y, const Double& z) {
            const Double dx = x - Double(from.x), dy = y - Double(from.y), dz = z - Double(from.z);
            most = xsimd::max(most, dx * dx + dy * dy + dz * dz);
        });
        return std::sqrt(-lanes::lowest(-most));
    }

private:
    using Double = lanes::Double;

    template <class F>
    void each(F&& f) const
    {
        for (std::size_t i = 0; i < count_; i += lanes::kDoubles)
            f(Double::load_aligned(x_.data() + i), Double::load_aligned(y_.data() + i),
              Double::load_aligned(z_.data() + i));
    }

    alignas(64) std::array<double, kTileRays> x_, y_, z_;
    std::size_t count_ = 0;
};

}  // namespace csg
