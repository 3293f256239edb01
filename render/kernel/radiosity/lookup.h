#pragma once

#include "numbers/lanes.h"
#include "render/kernel/radiosity/gather_scratch.h"
#include "render/kernel/radiosity/samples/sample_grid.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

/// Which samples points may use, and how much they count (spec 6, 4.5).
namespace trace::radiosity {

/// Up to eight points that ask together, since neighbours read the same lists. What a point finds, and the order in
/// which it is added up, does not depend on the others.
class LookupGroup {
public:
    static constexpr std::size_t kLanes = 8;

    /// \param smooth  weights fade smoothly, as in the picture for what the camera sees
    explicit LookupGroup(bool smooth) : smooth_(smooth) {}

    /// Lets a point stop reading once its weight is above 0 and at least quarters / 4: for callers that only ask
    /// whether it gets that far.
    void stop_at(double quarters)
    {
        stops_ = true;
        quarters_ = static_cast<float>(quarters);
    }

    /// Adds a point. bound: the error_bound of its bounce.
    void add(const glm::dvec3& point, const glm::dvec3& normal, double bound)
    {
        const std::size_t k = count_++;
        px_[k] = point.x, py_[k] = point.y, pz_[k] = point.z;
        nx_[k] = static_cast<float>(normal.x);
        ny_[k] = static_cast<float>(normal.y);
        nz_[k] = static_cast<float>(normal.z);
        bound_[k] = static_cast<float>(bound);
    }
    std::size_t size() const { return count_; }

    /// Adds up the samples of a grid that the points find.
    void ask(const SampleGrid& grid)
    {
        if (grid.empty()) return;
        std::array<List, kMostLists> lists;
        std::size_t count = 0;
        for (const SampleGrid::Level& level : grid.levels()) {
            if (count + kLanes > kMostLists) {
                read(grid, lists.data(), count);
                count = 0;
            }
            add_lists(grid, level, lists.data(), count);
        }
        read(grid, lists.data(), count);
    }

    /// Adds a sample that all points may use.
    void ask(const Sample& sample)
    {
        for (std::size_t k = 0; k < kLanes; ++k) {
            count_from(sample.point, k);
            here_[k] = k < count_ ? bound_[k] : 0.0f;
        }
        weigh(sample, glm::vec3(0));
    }

    void add_to(std::size_t k, Lookup& to) const
    {
        to.weight += static_cast<double>(weight_[k]);
        to.sum += glm::dvec3(red_[k], green_[k], blue_[k]);
    }

private:
    using Floats = std::array<float, kLanes>;
    using Float = numbers::lanes::FloatPart;
    using Doubles = std::array<double, kLanes>;
    using Double = numbers::lanes::Double;

    /// A list of samples that some points read. They lie anywhere in memory: it is asked for what is needed of several
    /// of them before any is looked at.
    struct List {
        std::uint64_t key;
        glm::dvec3 from;     ///< what its samples are counted from
        std::uint32_t same;  ///< a bit each: the points that read it
        std::uint32_t chunk;
    };
    static constexpr std::size_t kMostLists = 64;
    static constexpr float kSame = 1e-5f;     ///< relative to a sample's reach: nearer points lie where the sample does
    static constexpr float kBehind = -0.05f;  ///< how far behind a point a sample may lie

    /// The lists of one size of cells.
    void add_lists(const SampleGrid& grid, const SampleGrid::Level& level, List* lists, std::size_t& count) const
    {
        alignas(64) Doubles x, y, z;
        for (std::size_t at = 0; at < kLanes; at += Double::size) {
            const auto corner = [&](const Doubles& of, Doubles& to) {
                corner_of(load(of, at), level).store_aligned(to.data() + at);
            };
            corner(px_, x), corner(py_, y), corner(pz_, z);
        }
        std::uint32_t left = (1u << count_) - 1u;
        while (left != 0) {
            const auto first = static_cast<std::size_t>(std::countr_zero(left));
            const Double fx(x[first]), fy(y[first]), fz(z[first]);
            std::uint32_t same = 0;
            for (std::size_t at = 0; at < kLanes; at += Double::size)
                same |= numbers::lanes::mask((load(x, at) == fx) & (load(y, at) == fy) & (load(z, at) == fz)) << at;
            same &= left;
            left &= ~same;
            const glm::dvec3 corner(x[first], y[first], z[first]);
            const std::uint64_t key = grid.key(corner, level);
            lists[count++] = {key, corner * level.size - CellPlace::kOrigin, same, SampleGrid::kNone};
            grid.fetch_list(key);
        }
    }

    void read(const SampleGrid& grid, List* lists, std::size_t count)
    {
        std::size_t found = 0;
        for (std::size_t i = 0; i < count; ++i) {
            List list = lists[i];
            list.chunk = grid.find(list.key);
            if (list.chunk == SampleGrid::kNone) continue;
            grid.fetch_chunk(list.chunk);
            lists[found++] = list;
        }
        for (std::size_t i = 0; i < found; ++i) read(grid, lists[i]);
    }

    /// The points that have what stop_at() said.
    std::uint32_t stopped() const
    {
        if (!stops_) return 0;
        std::uint32_t out = 0;
        for (std::size_t at = 0; at < kLanes; at += Float::size) {
            const Float w = load(weight_, at);
            out |= numbers::lanes::mask((w > Float(0.0f)) & !(Float(4.0f) * w < Float(quarters_))) << at;
        }
        return out;
    }

    void read(const SampleGrid& grid, const List& list)
    {
        const std::uint32_t reading = list.same & ~stopped();
        if (reading == 0) return;
        for (std::size_t k = 0; k < kLanes; ++k) {
            count_from(list.from, k);
            here_[k] = (reading >> k & 1u) != 0 ? bound_[k] : 0.0f;
        }
        for (std::uint32_t at = list.chunk; at != SampleGrid::kNone;)
            at = grid.with_chunk(at, [&](const auto& chunk) { return read_chunk(grid, chunk, reading); });
    }

    /// The samples of a chunk for these points. The chunk to go on with.
    template <class Chunk>
    std::uint32_t read_chunk(const SampleGrid& grid, const Chunk& chunk, std::uint32_t reading)
    {
        if (chunk.next != SampleGrid::kNone) grid.fetch_chunk(chunk.next);
        const std::uint32_t close = static_cast<std::uint32_t>(std::popcount(reading)) < chunk.count
                                        ? close_to_any(chunk, reading)
                                        : close_to_some(chunk);
        for (std::uint32_t left = close; left != 0; left &= left - 1)
            grid.fetch_sample(chunk.number[static_cast<std::size_t>(std::countr_zero(left))]);
        for (std::uint32_t left = close; left != 0; left &= left - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(left));
            weigh(grid.samples()[chunk.number[i]], {chunk.x[i], chunk.y[i], chunk.z[i]});
        }
        return (reading & ~stopped()) == 0 ? SampleGrid::kNone : chunk.next;
    }

    /// One coordinate of the corner of the list that a point reads.
    static Double corner_of(const Double& p, const SampleGrid::Level& level)
    {
        const Double cell = (p + Double(CellPlace::kOrigin)) * Double(level.inverse) - Double(0.5);
        return xsimd::floor(xsimd::min(xsimd::max(cell, Double(-2.0)), Double(2e9)));
    }

    /// Point k from here.
    void count_from(const glm::dvec3& from, std::size_t k)
    {
        x_[k] = static_cast<float>(px_[k] - from.x);
        y_[k] = static_cast<float>(py_[k] - from.y);
        z_[k] = static_cast<float>(pz_[k] - from.z);
    }

    /// Samples of the chunk that some point may be near enough to: the points together, sample after sample.
    template <class Chunk>
    std::uint32_t close_to_some(const Chunk& chunk) const
    {
        std::uint32_t close = 0;
        for (std::size_t i = 0; i < chunk.count; ++i) {
            std::uint32_t any = 0;
            for (std::size_t at = 0; at < kLanes; at += Float::size) {
                const Float x = load(x_, at) - Float(chunk.x[i]), y = load(y_, at) - Float(chunk.y[i]),
                            z = load(z_, at) - Float(chunk.z[i]), far = load(here_, at) * Float(chunk.reach[i]);
                any |= numbers::lanes::mask(x * x + y * y + z * z < far * far);
            }
            close |= any != 0 ? 1u << i : 0u;
        }
        return close;
    }

    /// The same, the samples together, point after point: where fewer points than samples are at hand.
    template <class Chunk>
    std::uint32_t close_to_any(const Chunk& chunk, std::uint32_t points) const
    {
        // A register may reach over the arrays behind the one that is read, whose lanes do not count.
        static_assert(offsetof(Chunk, reach) + sizeof(Float) <= sizeof(Chunk));
        std::uint32_t close = 0;
        for (std::size_t at = 0; at < Chunk::kMost; at += Float::size) {
            const auto samples = [&](const auto& from) {
                return Float::load_unaligned(reinterpret_cast<const float*>(&chunk) + (from.data() - chunk.x.data()) +
                                             at);
            };
            const Float cx = samples(chunk.x), cy = samples(chunk.y), cz = samples(chunk.z),
                        reach = samples(chunk.reach);
            for (std::uint32_t left = points; left != 0; left &= left - 1) {
                const auto k = static_cast<std::size_t>(std::countr_zero(left));
                const Float x = Float(x_[k]) - cx, y = Float(y_[k]) - cy, z = Float(z_[k]) - cz,
                            far = Float(here_[k]) * reach;
                close |= numbers::lanes::mask(x * x + y * y + z * z < far * far) << at;
            }
        }
        return close & ((1u << Chunk::kMost) - 1u);
    }

    static Float load(const Floats& from, std::size_t at) { return Float::load_aligned(from.data() + at); }
    static Double load(const Doubles& from, std::size_t at) { return Double::load_aligned(from.data() + at); }

    /// False: weigh() would find that none of the points uses the sample, and need not take roots and quotients for it.
    /// Too far, turned too much by itself, or too far behind (all with a margin for rounding).
    static bool some_may_use(const Float& square, const Float& above, const Float& length_square, const Float& off,
                             const Float& bound, float reach)
    {
        constexpr float kMargin = 1.001f;
        const Float limit = bound * bound * Float(kMargin);
        const auto near = square < limit * Float(reach * reach), alike = Float(4.0f) * off < limit,
                   before = (above > Float(0.0f)) |
                            (above * above < Float(kMargin * kBehind * kBehind) * square * length_square) |
                            (square < Float(kMargin * kSame * kSame * reach * reach));
        return numbers::lanes::mask(near & alike & before) != 0;
    }

    /// p: the sample's place where the points' are x_, y_ and z_.
    void weigh(const Sample& s, const glm::vec3& p)
    {
        constexpr float kLeast = 0.001f;
        const Float one(1.0f), zero(0.0f);
        const Float nx(s.normal.x), ny(s.normal.y), nz(s.normal.z), reach(s.reach);
        for (std::size_t at = 0; at < kLanes; at += Float::size) {
            const Float x = load(x_, at) - Float(p.x), y = load(y_, at) - Float(p.y), z = load(z_, at) - Float(p.z);
            const Float bound = load(here_, at), qx = load(nx_, at), qy = load(ny_, at), qz = load(nz_, at);
            const Float mx = qx + nx, my = qy + ny, mz = qz + nz;
            const Float square = x * x + y * y + z * z, above = mx * x + my * y + mz * z,
                        length_square = mx * mx + my * my + mz * mz;
            const Float off = xsimd::abs(one - (qx * nx + qy * ny + qz * nz));
            if (!some_may_use(square, above, length_square, off, bound, s.reach)) continue;
            const Float d = xsimd::sqrt(square);
            const auto apart = d > Float(kSame * s.reach);
            const Float over = one / xsimd::select(apart, d, one);
            const Float toward =
                (Float(s.nearest_way.x) * x + Float(s.nearest_way.y) * y + Float(s.nearest_way.z) * z) * over;
            const Float r =
                xsimd::select(apart & (toward > zero), toward * Float(s.nearest) + (one - toward) * reach, reach);
            const Float error = d / r + Float(2.0f) * xsimd::sqrt(off), e = error / bound, rest = one - e;
            Float w = rest;
            if (smooth_) w = xsimd::select(e < Float(0.5f), one - Float(2.0f) * e * e, Float(2.0f) * rest * rest);
            auto used = (d < reach * bound) & (d < r * bound) & (error < bound);
            if (numbers::lanes::mask(used & apart & (above <= zero)) != 0) {  // elsewhere the sample is in front
                const Float front = xsimd::select(apart, above * over / xsimd::sqrt(length_square), one);
                w = xsimd::select(front <= zero, w * (one + Float(20.0f) * front), w);
                used = used & (front > Float(kBehind));
            }
            used = used & (w > Float(kLeast));
            w = xsimd::select(used, w * Float(s.quality), zero);
            (load(weight_, at) + w).store_aligned(weight_.data() + at);
            (load(red_, at) + w * Float(s.color.x)).store_aligned(red_.data() + at);
            (load(green_, at) + w * Float(s.color.y)).store_aligned(green_.data() + at);
            (load(blue_, at) + w * Float(s.color.z)).store_aligned(blue_.data() + at);
        }
    }

    bool smooth_, stops_ = false;
    float quarters_ = 0.0f;
    std::size_t count_ = 0;
    alignas(64) Doubles px_{}, py_{}, pz_{};
    alignas(64) Floats nx_{}, ny_{}, nz_{}, bound_{};
    alignas(64) Floats x_{}, y_{}, z_{};  ///< of the points, from what the samples at hand are counted from
    alignas(64) Floats here_{};           ///< bounds of those that the samples at hand are for, 0 for the others
    alignas(64) Floats weight_{}, red_{}, green_{}, blue_{};
};

}  // namespace trace::radiosity
