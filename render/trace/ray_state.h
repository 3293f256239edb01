#pragma once

#include "render/trace/geometry.h"

#include <array>

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
        count_ = other.count_;
        for (std::size_t i = 0; i < count_; ++i) items_[i] = other.items_[i];
        return *this;
    }
    void append(std::uint32_t interior)
    {
        if (count_ < kCapacity) items_[count_++] = interior;
    }
    void remove_first(std::uint32_t interior);
    void remove_last() { --count_; }
    bool holds(std::uint32_t interior) const;
    bool empty() const { return count_ == 0; }
    std::size_t size() const { return count_; }
    std::uint32_t last() const { return items_[count_ - 1]; }
    std::uint32_t operator[](std::size_t i) const { return items_[i]; }

private:
    static constexpr std::size_t kCapacity = 32;
    std::array<std::uint32_t, kCapacity> items_;
    std::size_t count_ = 0;
};

/// One ray with what it inherits.
struct RayState {
    csg::Ray ray;
    double start = 0;                ///< nearer crossings do not count (csg::Tolerance)
    float weight = 1;                ///< share of the pixel; below adc_bailout the ray is not traced
    int level = 0;                   ///< levels in use before this ray
    plan::RayKind kind = plan::RayKind::Image;
    InteriorList interiors;
    float wavelength = 0;            ///< nm; 0: white
    double stretch = 1;              ///< length of POV-Ray's direction, which a normal not of length 1 has bent; refraction goes by it
};

}  // namespace trace
