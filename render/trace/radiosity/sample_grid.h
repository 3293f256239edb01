#pragma once

#include "render/trace/radiosity/sample.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

/// Which samples a point may use. POV-Ray files a sample in one cell of an octree of loose cells, by the size of the
/// ball that it may be used in, and a point finds those of the cells that reach over it (spec 6, 4.6). Here each sample
/// stands in a list of every place that its cell reaches over, so that a point reads one list a size.
namespace trace::radiosity {

/// Where an octree of loose cells files a ball: cell `index` of size 2^level reaches half its size beyond itself.
struct CellPlace {
    int level = 0;
    std::array<std::int32_t, 3> index{};

    static constexpr double kOrigin = 1e7;  ///< cells are counted from minus this
    static double size(int level) { return std::ldexp(1.0, level); }

    static CellPlace of_ball(const glm::dvec3& center, double radius)
    {
        constexpr double kMostCells = 1e9;
        CellPlace place;
        double size = radius > 0.0 && radius < 1e9 ? std::exp2(std::floor(std::log2(2.0 * radius))) : 1.0;
        const glm::dvec3 low = glm::abs(center - radius);
        const double farthest = std::min(glm::max(low.x, glm::max(low.y, low.z)), 1e9);
        while ((farthest + kOrigin) / size > kMostCells) size *= 2.0;
        place.level = std::ilogb(size);
        for (int k = 0; k < 3; ++k) place.index[static_cast<std::size_t>(k)] = cell_of(center[k], size);
        while (!place.holds(center - radius) || !place.holds(center + radius)) {
            if (place.level >= 40) break;
            ++place.level;
            for (std::int32_t& i : place.index) i >>= 1;
        }
        return place;
    }
    /// Whether a point finds what is filed here.
    bool holds(const glm::dvec3& p) const
    {
        const double b = size(level);
        for (int k = 0; k < 3; ++k) {
            const double center = (index[static_cast<std::size_t>(k)] + 0.5) * b - kOrigin;
            if (!(std::abs(p[k] - center) < b)) return false;
        }
        return true;
    }
    /// The place of the list that a point reads: cells `index` and `index + 1` of each axis reach over it.
    static CellPlace of_point(const glm::dvec3& p, int level)
    {
        CellPlace place;
        place.level = level;
        const double b = size(level);
        for (int k = 0; k < 3; ++k) place.index[static_cast<std::size_t>(k)] = cell_of(p[k] - 0.5 * b, b);
        return place;
    }

    bool operator==(const CellPlace&) const = default;

private:
    static std::int32_t cell_of(double coordinate, double size)
    {
        return static_cast<std::int32_t>(std::floor(glm::clamp((coordinate + kOrigin) / size, -2.0, 2e9)));
    }
};

class SampleGrid {
public:
    bool empty() const { return samples_.empty(); }
    std::size_t size() const { return samples_.size(); }
    const std::vector<Sample>& samples() const { return samples_; }

    /// radius: of the ball that it is filed for.
    void add(const Sample& sample, double radius)
    {
        const auto number = static_cast<std::uint32_t>(samples_.size());
        samples_.push_back(sample);
        const CellPlace cell = CellPlace::of_ball(sample.point, radius);
        levels_ |= std::uint64_t{1} << (cell.level + kLowest);
        for (std::int32_t x = -1; x <= 0; ++x)
            for (std::int32_t y = -1; y <= 0; ++y)
                for (std::int32_t z = -1; z <= 0; ++z)
                    append({cell.level, {cell.index[0] + x, cell.index[1] + y, cell.index[2] + z}}, number, sample);
    }

    /// Forgets all samples, keeps the memory.
    void clear()
    {
        if (samples_.empty()) return;
        samples_.clear();
        chunks_.clear();
        for (const std::uint32_t slot : used_) slots_[slot].first = kNone;
        used_.clear();
        levels_ = 0;
    }

    /// f(sample) for every sample that the point finds and that is nearer than `factor` times its reach, give or take
    /// rounding; those of one point always in the same order.
    template <class F>
    void visit(const glm::dvec3& p, double factor, F&& f) const
    {
        for (std::uint64_t left = levels_; left != 0; left &= left - 1) {
            const CellPlace place = CellPlace::of_point(p, std::countr_zero(left) - kLowest);
            std::uint32_t at = find(place);
            if (at == kNone) continue;
            const glm::vec3 in_cell = relative(p, place);
            const float most = static_cast<float>(factor * factor) * kSlack;
            for (; at != kNone; at = chunks_[at].next) {
                const Chunk& chunk = chunks_[at];
                for (std::uint32_t near = chunk.near(in_cell, most); near != 0; near &= near - 1)
                    f(samples_[chunk.number[static_cast<std::size_t>(std::countr_zero(near))]]);
            }
        }
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffffu;
    static constexpr int kLowest = 16;  ///< levels begin at minus this
    static constexpr float kSlack = 1.001f;
    static constexpr std::size_t kInChunk = 8;

    /// Samples of one list: points from the list's corner, and squares of reaches.
    struct alignas(32) Chunk {
        std::array<float, kInChunk> x, y, z, reach2;
        std::array<std::uint32_t, kInChunk> number;
        std::uint32_t count = 0, next = kNone;

        std::uint32_t near(const glm::vec3& p, float factor2) const
        {
            std::array<std::uint32_t, kInChunk> is{};
            for (std::size_t i = 0; i < kInChunk; ++i) {
                const float dx = p.x - x[i], dy = p.y - y[i], dz = p.z - z[i];
                is[i] = dx * dx + dy * dy + dz * dz < reach2[i] * factor2 ? 1u << i : 0u;
            }
            std::uint32_t mask = 0;
            for (std::size_t i = 0; i < kInChunk; ++i) mask |= is[i];
            return mask;
        }
    };
    struct Slot {
        CellPlace place;
        std::uint32_t first = kNone, last = kNone;
    };

    /// From the corner of a list's place, in which numbers are small.
    static glm::vec3 relative(const glm::dvec3& p, const CellPlace& place)
    {
        const double b = CellPlace::size(place.level);
        glm::vec3 out;
        for (int k = 0; k < 3; ++k)
            out[k] = static_cast<float>((p[k] + CellPlace::kOrigin) - place.index[static_cast<std::size_t>(k)] * b);
        return out;
    }
    static std::uint64_t hash(const CellPlace& place)
    {
        const auto word = [&](std::size_t k) {
            return static_cast<std::uint64_t>(static_cast<std::uint32_t>(place.index[k]));
        };
        std::uint64_t h = word(0) * 0x9e3779b97f4a7c15u + word(1) * 0xc2b2ae3d27d4eb4fu + word(2) * 0x165667b19e3779f9u;
        h += static_cast<std::uint64_t>(place.level + kLowest) * 0x27d4eb2f165667c5u;
        return (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9u >> 20;
    }
    std::uint32_t find(const CellPlace& place) const
    {
        if (slots_.empty()) return kNone;
        const std::size_t mask = slots_.size() - 1;
        for (std::size_t i = hash(place) & mask;; i = (i + 1) & mask) {
            const Slot& slot = slots_[i];
            if (slot.first == kNone || slot.place == place) return slot.first;
        }
    }
    void append(const CellPlace& place, std::uint32_t number, const Sample& sample)
    {
        if (2 * (used_.size() + 1) > slots_.size()) grow();
        const std::size_t mask = slots_.size() - 1;
        std::size_t i = hash(place) & mask;
        while (slots_[i].first != kNone && slots_[i].place != place) i = (i + 1) & mask;
        Slot& slot = slots_[i];
        if (slot.first == kNone) {
            used_.push_back(static_cast<std::uint32_t>(i));
            slot = {place, new_chunk(), kNone};
            slot.last = slot.first;
        } else if (chunks_[slot.last].count == kInChunk) {
            const std::uint32_t fresh = new_chunk();
            chunks_[slot.last].next = fresh;
            slot.last = fresh;
        }
        Chunk& chunk = chunks_[slot.last];
        const std::uint32_t k = chunk.count++;
        const glm::vec3 p = relative(sample.point, place);
        chunk.x[k] = p.x;
        chunk.y[k] = p.y;
        chunk.z[k] = p.z;
        chunk.reach2[k] = sample.reach * sample.reach;
        chunk.number[k] = number;
    }
    std::uint32_t new_chunk()
    {
        Chunk& chunk = chunks_.emplace_back();
        chunk.x.fill(0.0f);
        chunk.y.fill(0.0f);
        chunk.z.fill(0.0f);
        chunk.reach2.fill(-1.0f);
        return static_cast<std::uint32_t>(chunks_.size() - 1);
    }
    void grow()
    {
        std::vector<Slot> before(slots_.empty() ? 256 : 2 * slots_.size());
        before.swap(slots_);
        std::vector<std::uint32_t> used;
        used.swap(used_);
        const std::size_t mask = slots_.size() - 1;
        for (const std::uint32_t from : used) {
            std::size_t i = hash(before[from].place) & mask;
            while (slots_[i].first != kNone) i = (i + 1) & mask;
            slots_[i] = before[from];
            used_.push_back(static_cast<std::uint32_t>(i));
        }
    }

    std::vector<Sample> samples_;
    std::vector<Chunk> chunks_;
    std::vector<Slot> slots_;  ///< a power of two of them
    std::vector<std::uint32_t> used_;
    std::uint64_t levels_ = 0;  ///< sizes of cells in use
};

}  // namespace trace::radiosity
