#include "csg/freeform/shared/ray_batch.h"
#include "csg/solids/extrusion.h"
#include "csg/solids/shared/outline_lines.h"
#include "csg/solids/shared/outline_walls.h"

#include <bit>

namespace csg {

/// Extrusion::each_span() of many rays, a ray a lane.
class Extrusion::Lanes {
public:
    Lanes(const Extrusion& solid, RayBatch& batch) : solid_(solid), batch_(batch) {}

    void run()
    {
        for (std::size_t k = 0; k < batch_.count; ++k) {
            const Ray local = local_ray(solid_.frame, batch_.rays[k]);
            origin_[0][k] = local.origin.x, origin_[1][k] = local.origin.y, origin_[2][k] = local.origin.z;
            way_[0][k] = local.direction.x, way_[1][k] = local.direction.y, way_[2][k] = local.direction.z;
            from_[k] = batch_.records[k].from;
            to_[k] = batch_.records[k].to;
        }
        for (std::size_t at = 0; at < batch_.count; at += kWide) intersect(at);
    }

    void run_one_by_one()
    {
        for (std::size_t k = 0; k < batch_.count; ++k) ask(k);
    }

private:
    using Double = OutlineLines::Double;
    using Bool = OutlineLines::Bool;
    using Mask = OutlineLines::Mask;
    using Place = OutlineLines::Place;
    using Numbers = std::array<double, kTileRays>;
    static constexpr std::size_t kWide = OutlineLines::kWide;

    static Double load(const Numbers& of, std::size_t at) { return Double::load_aligned(of.data() + at); }

    void intersect(std::size_t at)
    {
        const std::size_t count = std::min(kWide, batch_.count - at);
        const Double zero(0.0);
        const Double z = load(origin_[2], at), dz = load(way_[2], at);
        EndsOf<Double> within;
        const auto met = slab(z, dz, solid_.low, solid_.high, within);
        const Double entry = within.entry, exit = within.exit;
        const Double from = load(from_, at), to = load(to_, at);
        const Double nearest = xsimd::select(entry < from, from, entry), farthest = xsimd::select(to < exit, to, exit);
        const Place start{load(origin_[0], at), load(origin_[1], at)}, along{load(way_[0], at), load(way_[1], at)};
        Mask asked = ((1u << count) - 1u) & ~lanes::mask(nearest > farthest) & lanes::mask(met);
        Mask alone = asked & lanes::mask((along.x == zero) & (along.y == zero));
        asked &= ~(alone | missing(start, along, nearest, farthest));
        if (asked != 0) alone |= meet_walls(at, asked, start, along, nearest, farthest, entry, exit);
        for (; alone != 0; alone &= alone - 1) ask(at + static_cast<std::size_t>(std::countr_zero(alone)));
    }

    /// Extrusion::misses().
    Mask missing(const Place& from, const Place& along, Double nearest, Double farthest) const
    {
        const glm::dvec2 &lower = solid_.shape->lower(), &upper = solid_.shape->upper(),
                         most = glm::max(glm::abs(lower), glm::abs(upper));
        const Double room = Double(1e-10) *
                            (xsimd::abs(from.x) + Double(most.x) + (xsimd::abs(from.y) + Double(most.y)));
        const auto axis = [&](const Double& at, const Double& slope, double least, double greatest) {
            const Double inverse = Double(1.0) / slope, a = (Double(least) - room - at) * inverse,
                         b = (Double(greatest) + room - at) * inverse, first = xsimd::select(b < a, b, a),
                         last = xsimd::select(a < b, b, a);
            nearest = xsimd::select(nearest < first, first, nearest);
            farthest = xsimd::select(last < farthest, last, farthest);
        };
        axis(from.x, along.x, lower.x, upper.x);
        axis(from.y, along.y, lower.y, upper.y);
        return lanes::mask(nearest > farthest);
    }

    void ask(std::size_t k)
    {
        IntersectionList& record = batch_.records[k];
        std::uint32_t count = 0;
        solid_.each_span(
            batch_.rays[k],
            [&](double in, std::uint32_t in_face, double end, std::uint32_t end_face) {
                if (count++ < IntersectionList::kMostSpans) put(record, in, in_face, end, end_face);
            },
            record.from, record.to, record.first_only);
    }

    /// Whether more is wanted does not matter: of ends in one place the last one counts.
    static void put(IntersectionList& record, double in, std::uint32_t in_face, double end, std::uint32_t end_face)
    {
        record.enter(in, in_face);
        record.leave(end, end_face);
    }

    /// Extrusion::meet_walls() and what it is asked for. Returns the rays that pass too many.
    Mask meet_walls(std::size_t at, Mask asked, const Place& start, const Place& along, const Double& nearest,
                    const Double& farthest, const Double& entry, const Double& exit)
    {
        const OutlineRay<OutlineLines, Place, Double> ray(start, along);
        const OutlineLines line = ray.line(nearest, farthest);
        std::array<OutlineWalls, kWide> walls;
        Mask full = 0;
        const Mask odd = line.crossings(*solid_.shape, asked, [&](std::uint32_t piece, const Double& w, Mask crossing) {
            const Double t = ray.at(OutlineLines::at(solid_.shape->pieces()[piece], w));
            alignas(64) std::array<double, kWide> places;
            t.store_aligned(places.data());
            for (; crossing != 0; crossing &= crossing - 1) {
                const auto k = static_cast<std::size_t>(std::countr_zero(crossing));
                if (!walls[k].add(places[k], kFirstWall + piece)) full |= 1u << k;
            }
        });
        alignas(64) std::array<double, kWide> entries, exits;
        entry.store_aligned(entries.data());
        exit.store_aligned(exits.data());
        for (Mask left = asked & ~full; left != 0; left &= left - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(left));
            const bool inside = (odd >> k & 1u) != 0;
            if (!inside && walls[k].empty()) continue;
            const double dz = way_[2][at + k];
            const Interval within = dz == 0.0 ? Interval{}
                                              : Interval{entries[k], exits[k], dz > 0.0 ? 0u : 1u, dz > 0.0 ? 1u : 0u};
            solid_.tell(within, walls[k], inside,
                        [&](double in, std::uint32_t in_face, double end, std::uint32_t end_face) {
                            put(batch_.records[at + k], in, in_face, end, end_face);
                        });
        }
        return full;
    }

    const Extrusion& solid_;
    RayBatch& batch_;
    alignas(64) Numbers origin_[3]{}, way_[3]{}, from_{}, to_{};
};

void Extrusion::intersect_many(RayBatch& batch) const
{
    constexpr std::size_t kFewest = 3;  // fewer are told sooner one by one
    if (shape->empty()) return;
    Lanes lanes(*this, batch);
    if (batch.count < kFewest) lanes.run_one_by_one();
    else lanes.run();
}

}  // namespace csg
