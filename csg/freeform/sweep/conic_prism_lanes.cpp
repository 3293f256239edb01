#include "csg/freeform/sweep/conic_prism_walls.h"

#include "csg/base/hit.h"
#include "csg/solids/shared/outline_lines.h"
#include "csg/solids/shared/outline_walls.h"

#include <array>
#include <bit>

namespace csg {

/// ConicPrism::intersect() of many rays, a ray a lane: every number comes from the same operations in the same order.
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
    using Bool = OutlineLines::Bool;
    using Mask = OutlineLines::Mask;
    using Place = OutlineLines::Place;
    using Numbers = std::array<double, kTileRays>;
    using Vector = std::array<double, OutlineLines::kWide>;
    static constexpr std::size_t kWide = OutlineLines::kWide;

    /// Rays near the apex.
    struct Near {
        Double ox, oy, oz, dx, dy, dz;
    };
    /// What of the rays is asked for, and which are told of walls before it.
    struct Stretch {
        Double nearest, farthest, apex;
        Mask rises, apex_behind, one_sided;

        Mask before(const Double& t) const
        {
            const Mask past = lanes::mask(t > apex) & apex_behind, sooner = lanes::mask(t < nearest),
                       later = lanes::mask(t > apex);
            return (one_sided & ((sooner & (~rises | apex_behind | later)) | (~sooner & past))) |
                   (~one_sided & rises & lanes::mask(t < apex));
        }
    };

    static Double load(const Numbers& of, std::size_t at) { return Double::load_aligned(of.data() + at); }
    static Double smaller(const Double& a, const Double& b) { return xsimd::select(b < a, b, a); }
    static Double larger(const Double& a, const Double& b) { return xsimd::select(a < b, b, a); }
    static Double negated(const Double& v) { return v ^ Double(-0.0); }
    static Double widened(const Double& end, double sign) { return end + Double(sign * kWider) * xsimd::abs(end); }

    void intersect(std::size_t at)
    {
        const std::size_t count = std::min(kWide, rays_.size() - at);
        const Double px = load(origin_[0], at), py = load(origin_[1], at), pz = load(origin_[2], at);
        Near ray;
        ray.dx = load(direction_[0], at), ray.dy = load(direction_[1], at), ray.dz = load(direction_[2], at);
        const Double zero(0.0), infinite(kInfinity), low(prism_.low_), high(prism_.high_);
        const Double square = ray.dx * ray.dx + ray.dy * ray.dy + ray.dz * ray.dz;
        Mask asked = ((1u << count) - 1u) & lanes::mask((square > zero) & (square < infinite));
        const Double shift = negated(px * ray.dx + py * ray.dy + pz * ray.dz) / square;
        ray.ox = px + shift * ray.dx, ray.oy = py + shift * ray.dy, ray.oz = pz + shift * ray.dz;
        // slab()
        const Bool level = ray.dy == zero, forward = ray.dy > zero;
        const Double to_low = (low - ray.oy) / ray.dy, to_high = (high - ray.oy) / ray.dy;
        const Double entry = xsimd::select(level, negated(infinite), xsimd::select(forward, to_low, to_high)),
                     exit = xsimd::select(level, infinite, xsimd::select(forward, to_high, to_low));
        asked &= lanes::mask((level & (ray.oy >= low) & (ray.oy <= high)) | ((!level) & (entry <= exit)));
        if (asked == 0) return;
        const Double nx = ray.oy * ray.dz - ray.dy * ray.oz, ny = ray.oz * ray.dx - ray.dz * ray.ox,
                     nz = ray.ox * ray.dy - ray.dx * ray.oy;
        Mask alone = asked & lanes::mask((nx == zero) & (nz == zero));

        Stretch stretch;
        stretch.apex = negated(ray.oy) / ray.dy;
        stretch.rises = ~lanes::mask(level);
        const bool both_sides = !(prism_.low_ > 0.0 || prism_.high_ < 0.0),
                   touches = prism_.low_ == 0.0 || prism_.high_ == 0.0;
        stretch.one_sided = !both_sides ? ~Mask{0} : touches ? stretch.rises : 0;
        stretch.nearest = larger(entry, widened(load(from_, at), -1.0) - shift);
        stretch.farthest = smaller(exit, widened(load(to_, at), 1.0) - shift);
        asked &= ~(alone | lanes::mask(stretch.nearest > stretch.farthest));
        stretch.apex_behind = stretch.rises & lanes::mask(stretch.apex >= exit);
        if (asked != 0) {
            OutlineLines line;
            line.side = {nx, nz};
            line.level = negated(ny);
            line.along = {negated(nz), nx};
            const Bool one_sided = lanes::lanes_of(stretch.one_sided);
            line.lo =
                xsimd::select(one_sided, negated(farthest_along(line, ray, stretch.nearest, -1.0)), negated(infinite));
            line.hi = xsimd::select(one_sided, farthest_along(line, ray, stretch.farthest, 1.0), infinite);
            alone |= meet_walls(at, line, ray, stretch, asked, shift, entry, exit);
        }
        for (; alone != 0; alone &= alone - 1) {
            const std::size_t k = at + static_cast<std::size_t>(std::countr_zero(alone));
            prism_.intersect(rays_[k], out_[k]);
        }
    }

    /// Those whose walls are too many to be kept here.
    Mask meet_walls(std::size_t at, const OutlineLines& line, const Near& ray, const Stretch& stretch, Mask asked,
                    const Double& shift, const Double& entry, const Double& exit)
    {
        std::array<OutlineWalls, kWide> walls;
        const OutlineShape& outline = *prism_.outline_;
        Mask inside = 0, full = 0;
        const Mask odd = line.crossings(outline, asked, [&](std::uint32_t piece, const Double& w, Mask crossing) {
            const Place c = OutlineLines::at(outline.pieces()[piece], w);
            const Place gap{c.x * ray.oy - ray.ox, c.y * ray.oy - ray.oz},
                closing{ray.dx - c.x * ray.dy, ray.dz - c.y * ray.dy};
            const Double t = OutlineLines::dot(gap, closing) / OutlineLines::dot(closing, closing);
            inside ^= crossing & stretch.before(t);
            crossing &= ~stretch.one_sided | lanes::mask((t >= stretch.nearest) & (t <= stretch.farthest));
            crossing &= lanes::mask(xsimd::abs(t) < Double(kInfinity));
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
        shift.store_aligned(shifts.data());
        entry.store_aligned(entries.data());
        exit.store_aligned(exits.data());
        for (Mask left = asked & ~full; left != 0; left &= left - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(left));
            const bool in = (inside >> k & 1u) != 0;
            if (!in && walls[k].empty()) continue;
            // As of slab(): a level ray's are those of an interval without ends.
            const double dy = direction_[1][at + k];
            const Interval within = dy == 0.0 ? Interval{}
                                              : Interval{entries[k], exits[k], dy > 0.0 ? 0u : 1u, dy > 0.0 ? 1u : 0u};
            prism_.tell({shifts[k], within}, walls[k], in, out_[at + k]);
        }
        return full;
    }

    /// ConicPrism::farthest_along().
    Double farthest_along(const OutlineLines& line, const Near& ray, const Double& t, double sign) const
    {
        const Double low(prism_.low_), high(prism_.high_), infinite(kInfinity);
        const Double y = smaller(larger(ray.oy + t * ray.dy, low), high);
        const Place p{ray.ox + t * ray.dx, ray.oz + t * ray.dz},
            size{xsimd::abs(ray.ox) + xsimd::abs(t * ray.dx), xsimd::abs(ray.oz) + xsimd::abs(t * ray.dz)};
        const Double along = OutlineLines::dot(line.along, p) / y;
        const Double room = OutlineLines::dot({xsimd::abs(line.along.x), xsimd::abs(line.along.y)}, size) +
                            xsimd::abs(along) * (xsimd::abs(ray.oy) + xsimd::abs(t * ray.dy));
        const Double found = Double(sign) * along + Double(1e-12) * room / xsimd::abs(y);
        return xsimd::select((xsimd::abs(t) < infinite) & (y != Double(0.0)), found, infinite);
    }

    const ConicPrism& prism_;
    std::span<const Ray> rays_;
    IntersectionList* out_;
    alignas(64) Numbers origin_[3]{}, direction_[3]{}, from_{}, to_{};
};

void ConicPrism::intersect_many(std::span<const Ray> rays, IntersectionList* out) const
{
    constexpr std::size_t kFewest = 3;  // fewer are told sooner one by one
    if (rays.size() < kFewest)
        for (std::size_t k = 0; k < rays.size(); ++k) intersect(rays[k], out[k]);
    else if (!outline_->empty()) Lanes(*this, rays, out).run();
}

}  // namespace csg
