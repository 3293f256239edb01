#include "render/model/base/polygon_triangles.h"

#include <algorithm>
#include <numeric>

namespace model {
namespace {

/// Perpendicular to the polygon, twice its area long (Newell).
glm::dvec3 area_of(std::span<const glm::dvec3> outline)
{
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < outline.size(); ++i)
        sum += glm::cross(outline[i] - outline[0], outline[(i + 1) % outline.size()] - outline[0]);
    return sum;
}

class Ears {
public:
    explicit Ears(std::span<const glm::dvec3> outline) : outline_(outline), up_(area_of(outline)), left_(outline.size())
    {
        std::iota(left_.begin(), left_.end(), 0u);
    }

    bool convex() const
    {
        for (std::size_t i = 0; i < left_.size(); ++i)
            if (turn(i) < 0.0) return false;
        return true;
    }
    void cut(std::vector<std::array<std::uint32_t, 3>>& out)
    {
        // An outline that winds and crosses itself needs the cube of its corners: past this many looks at a corner ears
        // are cut anywhere. Whatever has fewer than 64 corners stays below.
        std::size_t looks = 4000 * left_.size();
        while (left_.size() > 3) {
            std::size_t ear = 0;  // any, where the outline crosses itself and has none
            for (std::size_t i = 0; i < left_.size() && looks > 0; ++i)
                if (looks -= std::min(looks, left_.size()); is_ear(i)) {
                    ear = i;
                    break;
                }
            out.push_back({at(ear, -1), left_[ear], at(ear, 1)});
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
        }
        out.push_back({left_[0], left_[1], left_[2]});
    }

private:
    std::uint32_t at(std::size_t i, int by) const
    {
        const std::size_t n = left_.size();
        return left_[(by < 0 ? i + n - 1 : i + 1) % n];
    }
    /// Above 0: the outline turns its own way from a to c about b.
    double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const
    {
        return glm::dot(glm::cross(outline_[b] - outline_[a], outline_[c] - outline_[b]), up_);
    }
    double turn(std::size_t i) const { return turn(at(i, -1), left_[i], at(i, 1)); }
    bool is_ear(std::size_t i) const
    {
        const std::uint32_t a = at(i, -1), b = left_[i], c = at(i, 1);
        if (!(turn(a, b, c) > 0.0)) return false;
        for (const std::uint32_t p : left_) {
            if (p == a || p == b || p == c) continue;
            if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) return false;
        }
        return true;
    }

    std::span<const glm::dvec3> outline_;
    glm::dvec3 up_;
    std::vector<std::uint32_t> left_;  ///< places that no ear has taken
};

}  // namespace

void triangulate(std::span<const glm::dvec3> outline, std::vector<std::array<std::uint32_t, 3>>& out)
{
    out.clear();
    if (outline.size() < 3) return;
    if (outline.size() > 3)
        if (Ears ears(outline); !ears.convex()) return ears.cut(out);
    for (std::uint32_t i = 1; i + 1 < outline.size(); ++i) out.push_back({0, i, i + 1});
}

}  // namespace model
