#pragma once

#include "render/kernel/radiosity/samples/sample.h"

#include <array>
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
        double size = radius > 0.0 && radius < 1e9 ? std::ldexp(1.0, std::ilogb(2.0 * radius)) : 1.0;
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

    bool operator==(const CellPlace& other) const
    {
        return ((index[0] ^ other.index[0]) | (index[1] ^ other.index[1]) | (index[2] ^ other.index[2]) |
                (level ^ other.level)) == 0;
    }

private:
    static std::int32_t cell_of(double coordinate, double size)
    {
        return static_cast<std::int32_t>(std::floor(glm::clamp((coordinate + kOrigin) / size, -2.0, 2e9)));
    }
};

class SampleGrid {
public:
    static constexpr std::uint32_t kNone = 0xffffffffu;  ///< no chunk

    /// Samples of one list: points from the list's corner, and reaches. Arrays lie one behind the other, as
    /// close_to_any() needs.
    template <std::size_t most>
    struct alignas(most * sizeof(float)) ChunkOf {
        static constexpr std::size_t kMost = most;
        std::array<float, most> x{}, y{}, z{}, reach{};
        std::array<std::uint32_t, most> number;
        std::uint32_t count = 0, next = kNone;
    };
    /// A list has two samples in the mean where they lie far apart, and all that it has lie in one of these; more are
    /// in larger ones, one behind the other.
    using Few = ChunkOf<4>;
    using Many = ChunkOf<8>;
    /// Cells of one size.
    struct Level {
        int number;
        double size, inverse;
    };

    bool empty() const { return samples_.empty(); }
    std::size_t size() const { return samples_.size(); }
    const std::vector<Sample>& samples() const { return samples_; }

    const std::vector<Level>& levels() const { return levels_; }
    /// Of the list that a point reads: cells `corner` and the next of each axis reach over it.
    static std::uint64_t key(const glm::dvec3& corner, const Level& level)
    {
        return key_of(level.number, {static_cast<std::int32_t>(corner.x), static_cast<std::int32_t>(corner.y),
                                     static_cast<std::int32_t>(corner.z)});
    }
    /// Its first chunk.
    std::uint32_t find(std::uint64_t key) const
    {
        for (std::size_t at = home(key); slots_[at].first != kNone; at = (at + 1) & (slots_.size() - 1))
            if (slots_[at].key == key) return slots_[at].first;
        return kNone;
    }
    /// f(chunk), whichever it is; what f returns.
    template <class F>
    auto with_chunk(std::uint32_t number, F&& f) const
    {
        return (number & kMany) != 0 ? f(many_[number & ~kMany]) : f(few_[number]);
    }

    /// Asks memory for what find(), with_chunk() and samples() will look at.
    void fetch_list(std::uint64_t key) const { fetch(&slots_[home(key)], sizeof(Slot)); }
    void fetch_chunk(std::uint32_t number) const
    {
        with_chunk(number, [](const auto& chunk) { fetch(&chunk, sizeof chunk); });
    }
    void fetch_sample(std::uint32_t number) const { fetch(&samples_[number], sizeof(Sample)); }

    /// radius: of the ball that it is filed for.
    void add(const Sample& sample, double radius)
    {
        const auto number = static_cast<std::uint32_t>(samples_.size());
        samples_.push_back(sample);
        const CellPlace cell = CellPlace::of_ball(sample.point, radius);
        use_level(cell.level);
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
        few_.clear();
        many_.clear();
        left_.clear();
        for (const std::uint32_t slot : used_) slots_[slot].first = kNone;
        used_.clear();
        levels_.clear();
    }

private:
    struct Slot {
        std::uint64_t key = 0;  ///< the place's: two places with one key share a list, which does no harm
        std::uint32_t first = kNone, last = kNone;
    };

    static constexpr std::uint32_t kMany = 0x80000000u;  ///< in the number of a chunk: it is of many_

    static void fetch(const void* at, std::size_t size)
    {
        constexpr std::size_t kLine = 64;
        for (std::size_t i = 0; i < size; i += kLine) __builtin_prefetch(static_cast<const char*>(at) + i);
    }

    void use_level(int number)
    {
        for (const Level& level : levels_)
            if (level.number == number) return;
        levels_.push_back({number, CellPlace::size(number), CellPlace::size(-number)});
    }

    /// From the corner of a list's place, in which numbers are small.
    static glm::vec3 relative(const glm::dvec3& p, const CellPlace& place)
    {
        const double b = CellPlace::size(place.level);
        glm::vec3 out;
        for (int k = 0; k < 3; ++k)
            out[k] = static_cast<float>((p[k] + CellPlace::kOrigin) - place.index[static_cast<std::size_t>(k)] * b);
        return out;
    }
    static std::uint64_t key_of(int level, const std::array<std::int32_t, 3>& index)
    {
        const auto word = [](std::int32_t v) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(v)); };
        const std::uint64_t h = (word(index[0]) << 32 | word(index[1])) * 0x9e3779b97f4a7c15u ^
                                (word(index[2]) << 8 | (word(level) & 0xffu)) * 0xc2b2ae3d27d4eb4fu;
        return (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9u;
    }
    std::size_t home(std::uint64_t key) const { return static_cast<std::size_t>(key >> 24) & (slots_.size() - 1); }
    void append(const CellPlace& place, std::uint32_t number, const Sample& sample)
    {
        if (2 * (used_.size() + 1) > slots_.size()) grow();
        const std::uint64_t key = key_of(place.level, place.index);
        std::size_t i = home(key);
        while (slots_[i].first != kNone && slots_[i].key != key) i = (i + 1) & (slots_.size() - 1);
        Slot& slot = slots_[i];
        if (slot.first == kNone) {
            used_.push_back(static_cast<std::uint32_t>(i));
            slot = {key, new_few(), kNone};
            slot.last = slot.first;
        } else if (slot.last < kMany && few_[slot.last].count == Few::kMost) {
            const std::uint32_t before = slot.last;
            slot.first = slot.last = new_many();
            move(few_[before], many_[slot.last & ~kMany]);
            few_[before] = {};
            left_.push_back(before);
        } else if (slot.last >= kMany && many_[slot.last & ~kMany].count == Many::kMost) {
            const std::uint32_t fresh = new_many();
            many_[slot.last & ~kMany].next = fresh;
            slot.last = fresh;
        }
        const glm::vec3 p = relative(sample.point, place);
        const auto put = [&](auto& chunk) {
            const std::uint32_t k = chunk.count++;
            chunk.x[k] = p.x;
            chunk.y[k] = p.y;
            chunk.z[k] = p.z;
            chunk.reach[k] = sample.reach;
            chunk.number[k] = number;
        };
        if (slot.last < kMany) put(few_[slot.last]);
        else put(many_[slot.last & ~kMany]);
    }
    static void move(const Few& from, Many& to)
    {
        for (std::size_t k = 0; k < from.count; ++k) {
            to.x[k] = from.x[k];
            to.y[k] = from.y[k];
            to.z[k] = from.z[k];
            to.reach[k] = from.reach[k];
            to.number[k] = from.number[k];
        }
        to.count = from.count;
    }
    std::uint32_t new_few()
    {
        if (!left_.empty()) {
            const std::uint32_t number = left_.back();
            left_.pop_back();
            return number;
        }
        few_.emplace_back();
        return static_cast<std::uint32_t>(few_.size() - 1);
    }
    std::uint32_t new_many()
    {
        many_.emplace_back();
        return static_cast<std::uint32_t>(many_.size() - 1) | kMany;
    }
    void grow()
    {
        std::vector<Slot> before(slots_.empty() ? 256 : 2 * slots_.size());
        before.swap(slots_);
        std::vector<std::uint32_t> used;
        used.swap(used_);
        for (const std::uint32_t from : used) {
            std::size_t i = home(before[from].key);
            while (slots_[i].first != kNone) i = (i + 1) & (slots_.size() - 1);
            slots_[i] = before[from];
            used_.push_back(static_cast<std::uint32_t>(i));
        }
    }

    std::vector<Sample> samples_;
    std::vector<Few> few_;
    std::vector<Many> many_;
    std::vector<std::uint32_t> left_;  ///< of few_, those whose samples have moved to a larger one
    std::vector<Slot> slots_;          ///< a power of two of them
    std::vector<std::uint32_t> used_;
    std::vector<Level> levels_;  ///< in use
};

}  // namespace trace::radiosity
