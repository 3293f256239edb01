#include "csg/freeform/sweep/conic_prism_course.h"

#include "csg/base/hit.h"
#include "csg/solids/shared/outline_lines.h"
#include "csg/solids/shared/outline_walls.h"

#include <array>
#include <bit>

namespace csg {

/// Many rays, a ray a lane.
class ConicPrism::Lanes {
public:
    Lanes(const ConicPrism& prism, std::span<const Ray> rays, IntersectionList* out)
        : prism_(prism), rays_(rays), out_(out)
    {}

    void run()
    {
        for (std::size_t k = 0; k < rays_.size(); ++k) {
            for (glm::length_t i = 0; i < 3; ++i) {
                origin_[static_cast<std::size_t>(i)][k] = rays_[k].origin[i];
                direction_[static_cast<std::size_t>(i)][k] = rays_[k].direction[i];
            }
            from_[k] = out_[k].from;
            to_[k] = out_[k].to;
        }
        for (std::size_t at = 0; at < rays_.size(); at += kWide) intersect(at);
    }

private:
    using Double = OutlineLines::Double;
    using Mask = OutlineLines::Mask;
    using Numbers = std::array<double, kTileRays>;
    using Vector = std::array<double, OutlineLines::kWide>;
    static constexpr std::size_t kWide = OutlineLines::kWide;

    void intersect(std::size_t at)
    {
        const auto load = [&](const Numbers& of) { return Double::load_aligned(of.data() + at); };
        const Course<Double> course(prism_, {load(origin_[0]), load(origin_[1]), load(origin_[2])},
                                    {load(direction_[0]), load(direction_[1]), load(direction_[2])}, load(from_),
                                    load(to_));
        const Mask all = (1u << std::min(kWide, rays_.size() - at)) - 1u, asked = all & lanes::mask(course.asked);
        Mask alone = all & lanes::mask(course.through_apex);
        if (asked != 0) alone |= meet_walls(at, course, asked);
        for (; alone != 0; alone &= alone - 1) {
            const std::size_t k = at + static_cast<std::size_t>(std::countr_zero(alone));
            prism_.intersect(rays_[k], out_[k]);
        }
    }

    /// Answers the rays of `asked` by the crossings of their lines with the outline. Returns the lanes with more of
    /// them than OutlineWalls keeps, which have to be asked one by one.
    Mask meet_walls(std::size_t at, const Course<Double>& course, Mask asked)
    {
        const auto line = course.line<OutlineLines>();
        std::array<OutlineWalls, kWide> walls;
        const OutlineShape& outline = *prism_.outline_;
        Mask inside = 0, full = 0;
        const Mask odd = line.crossings(outline, asked, [&](std::uint32_t piece, const Double& w, Mask crossing) {
            const auto c = OutlineLines::at(outline.pieces()[piece], w);
            const Double t = course.wall(c.x, c.y);
            inside ^= crossing & lanes::mask(course.before(t));
            crossing &= lanes::mask(course.holds(t)) & lanes::mask(xsimd::abs(t) < Double(kInfinity));
            if (crossing == 0) return;
            alignas(64) Vector places;
            t.store_aligned(places.data());
            for (; crossing != 0; crossing &= crossing - 1) {
                const auto k = static_cast<std::size_t>(std::countr_zero(crossing));
                if (!walls[k].add(places[k], kFirstWall + piece)) full |= 1u << k;
            }
        });
        inside ^= odd;
        alignas(64) Vector shifts, entries, exits;
        course.shift.store_aligned(shifts.data());
        course.entry.store_aligned(entries.data());
        course.exit.store_aligned(exits.data());
        for (Mask left = asked & ~full; left != 0; left &= left - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(left));
            const bool in = (inside >> k & 1u) != 0;
            if (!in && walls[k].empty()) continue;
            const Interval within = course.within(entries[k], exits[k], direction_[1][at + k]);
            prism_.tell(shifts[k], within, walls[k], in, out_[at + k]);
        }
        return full;
    }

    const ConicPrism& prism_;
    std::span<const Ray> rays_;
    IntersectionList* out_;
    alignas(64) Numbers origin_[3]{}, direction_[3]{}, from_{}, to_{};
};

void ConicPrism::intersect_many(std::span<const Ray> rays, IntersectionList* out) const
{
    constexpr std::size_t kFewest = 3;  // fewer are faster one by one
    if (rays.size() < kFewest)
        for (std::size_t k = 0; k < rays.size(); ++k) intersect(rays[k], out[k]);
    else if (!outline_->empty()) Lanes(*this, rays, out).run();
}

}  // namespace csg
