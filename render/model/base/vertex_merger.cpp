#include "render/model/base/vertex_merger.h"

#include "render/model/base/model.h"

#include <array>
#include <bit>
#include <random>

namespace model {

VertexMerger::VertexMerger(std::size_t expected) : seed_(std::uint64_t{std::random_device{}()} << 32 | 1)
{
    table_.assign(std::bit_ceil(2 * expected + 16), kNone);
    points_.reserve(expected);
}

std::size_t VertexMerger::place_of(const glm::vec3& p) const
{
    const auto bits = std::bit_cast<std::array<std::uint32_t, 3>>(p);
    constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15u;
    std::uint64_t h = (bits[0] | std::uint64_t{bits[1]} << 32) ^ seed_;
    h *= kOdd;
    h ^= h >> 29;
    h = (h + bits[2]) * kOdd;
    return static_cast<std::size_t>(h >> 20) & (table_.size() - 1);
}

std::uint32_t VertexMerger::number(const glm::vec3& given)
{
    const glm::vec3 p = given + 0.0f;  // no -0
    std::size_t at = place_of(p);
    for (; table_[at] != kNone; at = (at + 1) & (table_.size() - 1))
        if (points_[table_[at]] == p) return table_[at];
    const auto fresh = static_cast<std::uint32_t>(points_.size());
    points_.push_back(p);
    table_[at] = fresh;
    if (2 * points_.size() > table_.size()) grow();
    return fresh;
}

void VertexMerger::grow()
{
    table_.assign(2 * table_.size(), kNone);
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
        std::size_t at = place_of(points_[i]);
        while (table_[at] != kNone) at = (at + 1) & (table_.size() - 1);
        table_[at] = i;
    }
}

}  // namespace model
