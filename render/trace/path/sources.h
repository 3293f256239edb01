#pragma once

#include "csg/base/types.h"
#include "csg/spans/span.h"
#include "render/trace/path/directions.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace plan {
struct CompiledScene;
}

/// Light that paths may meet, and which next-event estimation aims at: bodies that glow, and the sky. Built once for a
/// picture, read by all threads.
namespace trace::path {

/// A convex body that gives off the same light everywhere.
struct Emitter {
    struct Face {
        glm::dvec3 corner, a, b, normal;  ///< a parallelogram; the normal is unit and points out
        double area;
    };
    csg::PartId part = csg::kNoPart;
    bool sphere = false;
    glm::dvec3 center{0};
    double radius = 0;
    std::vector<Face> faces;  ///< of a body that is no sphere
    glm::vec3 radiance{0};
    double chance = 0;  ///< of being drawn among the emitters

    /// A direction to it from a point outside; its density by solid angle, 0: none.
    double sample(const glm::dvec3& from, const std::array<double, 2>& u, glm::dvec3& direction) const;
    /// The density of the direction that met it there.
    double density(const glm::dvec3& from, const glm::dvec3& direction, double distance, std::uint32_t face) const;
};

/// Brightness of the sky by direction: cells of equal longitude and latitude, with poles on y.
class SkyTable {
public:
    /// \param brightness of the cells, row by row from y = 1 on, 0 and more, not all 0
    SkyTable(std::size_t columns, std::size_t rows, const std::vector<float>& brightness);

    glm::dvec3 sample(const std::array<double, 2>& u) const;
    double density(const glm::dvec3& direction) const;  ///< by solid angle
    /// Of a place in the table: x, y in [0, 1].
    static glm::dvec3 direction(double x, double y);

private:
    double height(std::size_t row) const  ///< where it begins, along y
    {
        return std::cos(kPi * static_cast<double>(row) / static_cast<double>(rows_));
    }
    std::size_t columns_, rows_;
    std::vector<double> row_ends_;     ///< sums of the chances of rows
    std::vector<double> column_ends_;  ///< of each row, row by row; the last of a row is 1
};

/// What light there is to aim at.
struct Sources {
    std::vector<Emitter> emitters;  ///< by part, ascending
    std::unique_ptr<const SkyTable> sky;

    bool any() const { return sky != nullptr || !emitters.empty(); }
    double sky_chance() const { return sky == nullptr ? 0.0 : emitters.empty() ? 1.0 : 0.5; }
    static constexpr std::uint32_t kNone = 0xffffffffu;
    std::uint32_t find(csg::PartId part) const;
};

Sources find_sources(const plan::CompiledScene& scene);

}  // namespace trace::path
