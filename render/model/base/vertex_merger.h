#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace model {

/// Gives equal points one number: files of STL repeat a point for each triangle that it is a corner of.
class VertexMerger {
public:
    /// \param expected so many different points are likely; more may come
    explicit VertexMerger(std::size_t expected);

    /// The number of the first point that was equal; 0 and -0 are.
    std::uint32_t number(const glm::vec3& p);
    const std::vector<glm::vec3>& points() const { return points_; }

private:
    std::size_t place_of(const glm::vec3& p) const;
    void grow();

    std::uint64_t seed_;                ///< other in each run: nobody writes a file whose points all fall on one place
    std::vector<std::uint32_t> table_;  ///< numbers of points, at most half of it; kNone: free
    std::vector<glm::vec3> points_;
};

}  // namespace model
