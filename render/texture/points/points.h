#pragma once

#include "render/scene/base/color.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

namespace texture {

inline constexpr int kMostPoints = 64;   ///< a tile's
inline constexpr unsigned kAllLive = 7;  ///< all three components are asked for (bit 0: x)

/// A value for each of some points; what lies behind the last one is anything.
struct alignas(64) Values {
    std::array<double, kMostPoints> v;
    double& operator[](std::size_t i) { return v[i]; }
    double operator[](std::size_t i) const { return v[i]; }
    double* data() { return v.data(); }
    const double* data() const { return v.data(); }
};

/// Up to 64 points side by side, or an octave each of one point.
struct Points {
    Values x, y, z;
    int count = 0;
    bool density = false;  ///< of media: noise is told in single precision, colours without filter and transmittance

    std::size_t size() const { return static_cast<std::size_t>(count); }
    glm::dvec3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
    void set(std::size_t i, const glm::dvec3& p)
    {
        x[i] = p.x;
        y[i] = p.y;
        z[i] = p.z;
    }
    /// A copy of padded points; what lies behind them is not.
    void take(const Points& from) { take(from, from.count); }
    /// The same of the first so many.
    void take(const Points& from, int first)
    {
        count = first;
        density = from.density;
        constexpr std::size_t kLine = 8;  // as a rule there are few, and a call takes longer
        const auto line = [](Values& to, const Values& of, std::size_t i) {
            std::memcpy(to.data() + i, of.data() + i, kLine * sizeof(double));
        };
        for (std::size_t i = 0; i < size(); i += kLine) {
            line(x, from.x, i);
            line(y, from.y, i);
            line(z, from.z, i);
        }
    }
    void add(const glm::dvec3& p) { set(static_cast<std::size_t>(count++), p); }

    /// Repeats the last point up to the end of its vector, so that nothing there is in a cell of its own.
    void pad()
    {
        for (std::size_t i = size(), end = std::min<std::size_t>((i + 7) & ~std::size_t{7}, kMostPoints); i < end; ++i)
            set(i, at(size() - 1));
    }
};

/// A colour for each of some points, its components apart.
struct alignas(64) ColorPoints {
    alignas(64) std::array<float, kMostPoints> red, green, blue, filter, transmit;

    scene::Color at(std::size_t i) const { return {red[i], green[i], blue[i], filter[i], transmit[i]}; }
    void set(std::size_t i, const scene::Color& c)
    {
        red[i] = c.red;
        green[i] = c.green;
        blue[i] = c.blue;
        filter[i] = c.filter;
        transmit[i] = c.transmit;
    }
    void fill(const scene::Color& c)
    {
        red.fill(c.red);
        green.fill(c.green);
        blue.fill(c.blue);
        filter.fill(c.filter);
        transmit.fill(c.transmit);
    }
    /// What lets light through.
    void fill_clear(float share)
    {
        filter.fill(share);
        transmit.fill(share);
    }
};

}  // namespace texture
