#pragma once

#include "render/plan/textures/interior.h"
#include "render/trace/geometry.h"

#include <array>
#include <vector>

/// A ray of shading with all that it inherits from the rays before it.
namespace trace {

/// The interiors a ray is inside of, in order of entry (spec 3, 8.2). Entries past the capacity are forgotten.
class InteriorList {
public:
    InteriorList() = default;
    InteriorList(const InteriorList& other) { *this = other; }
    /// Copies what is there: a list is handed down with every ray, and hardly ever has more than two entries.
    InteriorList& operator=(const InteriorList& other)
    {
        head_ = other.head_;
        for (std::size_t i = 0; i < head_.count; ++i) items_[i] = other.items_[i];
        return *this;
    }
    void append(std::uint32_t interior)
    {
        if (head_.count < kCapacity) items_[head_.count++] = interior;
    }
    void remove_first(std::uint32_t interior);
    void remove_last() { --head_.count; }
    bool holds(std::uint32_t interior) const;
    bool empty() const { return head_.count == 0; }
    std::size_t size() const { return head_.count; }
    std::uint32_t last() const { return items_[head_.count - 1]; }
    std::uint32_t operator[](std::size_t i) const { return items_[i]; }

    /// Nothing solid around: fog shows.
    bool all_hollow(const std::vector<plan::Interior>& interiors) const;
    /// POV-Ray clears the list between the rays of a blurred position and forgets that they were inside something
    /// solid: a ray is taken to be so still, until it leaves something solid.
    void cloud() { head_.clouded = 1; }
    void uncloud() { head_.clouded = 0; }

private:
    static constexpr std::size_t kCapacity = 32;
    std::array<std::uint32_t, kCapacity> items_;
    struct Head {
        std::uint32_t count = 0, clouded = 0;
    } head_;  ///< one word
};

/// One ray with what it inherits.
struct RayState {
    csg::Ray ray;
    double start = 0;  ///< nearer crossings do not count (csg::Tolerance)
    float weight = 1;  ///< share of the pixel; below adc_bailout the ray is not traced
    int level = 0;     ///< levels in use before this ray
    plan::RayKind kind = plan::RayKind::Image;
    std::uint8_t root = 0;   ///< the ray of the tile that it stems from
    bool scattered = false;  ///< one of many off a rough mirror
    InteriorList interiors;
    float wavelength = 0;  ///< nm; 0: white
    double stretch =
        1;  ///< length of POV-Ray's direction, which a normal not of length 1 has bent; refraction goes by it
};

}  // namespace trace
