#pragma once

#include "render/plan/interior.h"
#include "render/kernel/tile/geometry.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

/// A ray of shading with all that it inherits from the rays before it.
namespace trace {

/// The interiors a ray is inside of, in order of entry (spec 3, 8.2). Entries past the capacity are forgotten.
class InteriorList {
public:
    InteriorList() = default;
    InteriorList(const InteriorList& other) { *this = other; }
    /// Copies what is there: a list is handed down with every ray, and hardly ever has more than the few entries that
    /// are copied without asking how many there are.
    InteriorList& operator=(const InteriorList& other)
    {
        head_ = other.head_;
        std::memcpy(items_.data(), other.items_.data(), kFew * sizeof(std::uint32_t));
        for (std::size_t i = kFew; i < head_.count; ++i) items_[i] = other.items_[i];
        return *this;
    }
    void append(std::uint32_t interior)
    {
        if (head_.count < kCapacity) items_[head_.count++] = interior;
    }
    void remove_first(std::uint32_t interior)
    {
        std::uint32_t* const end = items_.data() + head_.count;
        std::uint32_t* const found = std::find(items_.data(), end, interior);
        if (found == end) return;
        std::copy(found + 1, end, found);
        --head_.count;
    }
    void remove_last() { --head_.count; }
    bool holds(std::uint32_t interior) const
    {
        for (std::size_t i = 0; i < head_.count; ++i)
            if (items_[i] == interior) return true;
        return false;
    }
    bool empty() const { return head_.count == 0; }
    bool operator==(const InteriorList& other) const
    {
        if (head_.count != other.head_.count || head_.clouded != other.head_.clouded) return false;
        for (std::size_t i = 0; i < head_.count; ++i)  // a call to compare memory takes longer than the few there are
            if (items_[i] != other.items_[i]) return false;
        return true;
    }
    std::size_t size() const { return head_.count; }
    /// 0 where there is nothing around and nothing forgotten: all_hollow() without a look at any interior.
    std::uint32_t closed() const { return head_.count | head_.clouded; }
    std::uint32_t last() const { return items_[head_.count - 1]; }
    std::uint32_t operator[](std::size_t i) const { return items_[i]; }

    /// Nothing solid around: fog shows.
    bool all_hollow(const std::vector<plan::Interior>& interiors) const
    {
        if (empty()) return head_.clouded == 0;  // as most are
        return head_.clouded == 0 && std::all_of(items_.data(), items_.data() + head_.count,
                                                 [&](std::uint32_t i) { return interiors[i].hollow; });
    }
    /// Marks the ray as inside of something solid until it leaves something solid. POV-Ray clears the list between the
    /// rays of one focal blur position but keeps counting them as inside.
    void cloud() { head_.clouded = 1; }
    void uncloud() { head_.clouded = 0; }

private:
    static constexpr std::size_t kCapacity = 32, kFew = 4;
    struct Head {
        std::uint32_t count = 0, clouded = 0;
    } head_;  ///< one word
    std::array<std::uint32_t, kCapacity> items_;
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
    float wavelength = 0;    ///< nm; 0: white
    double stretch =
        1;  ///< length of POV-Ray's direction, which a normal not of length 1 has bent; refraction goes by it
    InteriorList interiors;  ///< last: most of it is empty as a rule
};

}  // namespace trace
