#pragma once

#include "render/kernel/gather/photon.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace trace {

/// A part of the tree that fills this box: what a search of a point in it comes to first.
struct PhotonCell {
    std::size_t first = 0, end = 0;
    glm::dvec3 low{0}, high{0};  ///< high is beyond it

    bool holds(const glm::dvec3& point) const
    {
        return low.x <= point.x && point.x < high.x && low.y <= point.y && point.y < high.y && low.z <= point.z &&
               point.z < high.z;
    }
};

/// Where photons are, as arrays in the order of the map: a balanced tree without pointers. The node of photons first to
/// last is the one in the middle; those before it lie below it along its axis, those behind it above.
struct PhotonPlaces {
    static constexpr std::size_t kPadding = 16;  ///< places behind the last, so that lanes may look beyond it
    static constexpr std::uint32_t kNoGate = 0xffffffffu;
    std::vector<float> x, y, z;
    std::vector<std::uint8_t> axis;
    /// The nodes above a photon that have it on the wrong side, as POV-Ray's order of two leaves it now and then: it is
    /// not found from the other side of such a node's plane if the plane is out of reach.
    /// Of some there are two; a third is left out.
    struct Gates {
        std::uint32_t first = kNoGate, second = kNoGate;
    };
    std::vector<Gates> gates;

    std::size_t size() const { return axis.size(); }
    double along(std::size_t i, int which) const
    {
        return static_cast<double>(which == 0 ? x[i] : which == 1 ? y[i] : z[i]);
    }
    /// How far the planes of its gates are off a photon, rounded up.
    float gate_off(std::uint32_t photon) const
    {
        double out = 0.0;
        for (const std::uint32_t gate : {gates[photon].first, gates[photon].second})
            if (gate != kNoGate) out = std::max(out, std::abs(along(gate, axis[gate]) - along(photon, axis[gate])));
        return std::nextafter(static_cast<float>(out), std::numeric_limits<float>::infinity());
    }
    /// The first part of up to so many photons that POV-Ray comes to.
    PhotonCell cell(const glm::dvec3& point, std::size_t most) const
    {
        constexpr double kEnd = std::numeric_limits<double>::infinity();
        PhotonCell out{0, size(), glm::dvec3(-kEnd), glm::dvec3(kEnd)};
        while (out.end - out.first > most) {
            const std::size_t middle = (out.first + out.end - 1) / 2;
            const int side = axis[middle];
            const double at = along(middle, side);
            const bool below = at - point[side] > 0.0;
            (below ? out.end : out.first) = below ? middle : middle + 1;
            (below ? out.high : out.low)[side] = at;
        }
        return out;
    }
    void take(const std::vector<Photon>& photons)
    {
        const std::size_t room = photons.size() + kPadding;
        x.assign(room, 0.0f);
        y.assign(room, 0.0f);
        z.assign(room, 0.0f);
        axis.resize(photons.size());
        for (std::size_t i = 0; i < photons.size(); ++i) {
            x[i] = photons[i].x;
            y[i] = photons[i].y;
            z[i] = photons[i].z;
            axis[i] = photons[i].axis;
        }
        gates.resize(photons.size());
        for (std::size_t i = 0; i < photons.size(); ++i) gates[i] = find_gates(i);
    }

private:
    Gates find_gates(std::size_t photon) const
    {
        Gates out;
        for (std::size_t first = 0, end = size();;) {
            const std::size_t middle = (first + end - 1) / 2;
            if (middle == photon) return out;
            const double off = along(photon, axis[middle]) - along(middle, axis[middle]);
            const bool below = photon < middle;
            if (below ? off > 0.0 : off < 0.0)
                (out.first == kNoGate ? out.first : out.second) = static_cast<std::uint32_t>(middle);
            (below ? end : first) = below ? middle : middle + 1;
        }
    }
};

}  // namespace trace
