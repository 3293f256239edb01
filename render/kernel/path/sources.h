#pragma once

#include "csg/base/types.h"
#include "csg/spans/span.h"
#include "numbers/functions/functions.h"
#include "render/kernel/path/directions.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

/// Light that paths may meet, and which next-event estimation aims at: bodies that glow, and the sky. Built once for a
/// picture, read by all threads.
namespace trace::path {

/// A body that gives off the same light everywhere: a sphere, one with faces that bound it, or faces with two sides.
struct Emitter {
    struct Face {
        enum class Shape : std::uint8_t {
            Parallelogram,  ///< from its corner along a and b
            Triangle,       ///< half of that
            Ring,           ///< an ellipse about `corner` with the half axes a and b, with a hole
            Side            ///< of a round cylinder: a and b across, base at `corner`, along `axis`
        } shape = Shape::Parallelogram;
        glm::dvec3 corner, a, b, normal;  ///< the normal is unit and points out; a side has none
        double area = 0;
        double hole = 0;  ///< its radius as a share of the ring's
        glm::dvec3 axis{0};

        /// A point on it, by two uniform numbers, and its normal. `from`: seen from there; of a side only the near half
        /// is sampled.
        glm::dvec3 place(const glm::dvec3& from, const std::array<double, 2>& u, glm::dvec3& unit) const;
        glm::dvec3 normal_at(const glm::dvec3& place) const;
        /// The area that a point sees: of a flat face all or nothing.
        double seen_area(const glm::dvec3& from) const;
    };
    csg::PartId part = csg::kNoPart;
    bool sphere = false;
    bool convex = true;  ///< faces hide each other in no other way than by turning away; else they have two sides
    glm::dvec3 center{0};
    double radius = 0;
    std::vector<Face> faces;   ///< of a body that is no sphere
    std::vector<double> ends;  ///< of faces with two sides: sums of their areas
    glm::vec3 radiance{0};
    double chance = 0;  ///< of being drawn among the emitters

    static constexpr std::uint32_t kAnyFace = 0xffffffffu;
    /// Samples a direction to it from a point outside.
    /// \param face  receives the face that a ray in this direction must meet, or kAnyFace
    /// \return      density by solid angle, 1/sr; 0: no sample
    double sample(const glm::dvec3& from, const std::array<double, 2>& u, glm::dvec3& direction,
                  std::uint32_t& face) const;
    /// Whether the face that was met is the one asked for.
    bool is(std::uint32_t asked, std::uint32_t met) const
    {
        return asked == kAnyFace || faces.size() == 1 || asked == met;
    }
    /// The density, 1/sr, with which sample() draws the direction that met `face` at `distance`.
    double density(const glm::dvec3& from, const glm::dvec3& direction, double distance, std::uint32_t face) const;
};

/// Brightness of the sky by direction: cells of equal longitude and latitude, with poles on y.
class SkyTable {
public:
    /// \param brightness of the cells, row by row from y = 1 on, 0 and more, not all 0
    SkyTable(std::size_t columns, std::size_t rows, const std::vector<float>& brightness);

    glm::dvec3 sample(const std::array<double, 2>& u) const;
    double density(const glm::dvec3& direction) const;  ///< by solid angle
    /// The direction of a place in the table: x, y in [0, 1]; unit.
    static glm::dvec3 direction(double x, double y);

private:
    double height(std::size_t row) const  ///< where it begins, along y
    {
        return numbers::cos(kPi * static_cast<double>(row) / static_cast<double>(rows_));
    }
    std::size_t columns_, rows_;
    std::vector<double> row_ends_;     ///< sums of the chances of rows
    std::vector<double> column_ends_;  ///< of each row, row by row; the last of a row is 1
};

/// The light that next-event estimation aims at.
struct Sources {
    std::vector<Emitter> emitters;  ///< by part, ascending
    std::unique_ptr<const SkyTable> sky;

    bool any() const { return sky != nullptr || !emitters.empty(); }
    double sky_chance() const { return sky == nullptr ? 0.0 : emitters.empty() ? 1.0 : 0.5; }
    static constexpr std::uint32_t kNone = 0xffffffffu;
    std::uint32_t find(csg::PartId part) const;
};

}  // namespace trace::path
