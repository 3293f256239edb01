#include "render/trace/path/sources.h"

#include <algorithm>
#include <cmath>

namespace trace::path {
namespace {

bool turned_to(const Emitter::Face& face, const glm::dvec3& from)
{
    return glm::dot(from - face.corner, face.normal) > 0.0;
}

/// Of all faces that a point outside sees.
double seen_area(const Emitter& body, const glm::dvec3& from)
{
    double area = 0.0;
    for (const Emitter::Face& face : body.faces)
        if (turned_to(face, from)) area += face.area;
    return area;
}

/// 1 minus the cosine of the half angle that a sphere is seen under; negative: from within.
double cap_height(const Emitter& ball, const glm::dvec3& from)
{
    const glm::dvec3 to = ball.center - from;
    const double sine2 = ball.radius * ball.radius / glm::dot(to, to);
    return sine2 < 1.0 ? sine2 / (1.0 + std::sqrt(1.0 - sine2)) : -1.0;
}

/// Index of the first end above u, and where u lies between the ends before and there.
std::size_t drawn(const double* ends, std::size_t count, double u, double& within)
{
    std::size_t i = static_cast<std::size_t>(std::upper_bound(ends, ends + count, u) - ends);
    i = std::min(i, count - 1);
    const double before = i > 0 ? ends[i - 1] : 0.0;
    within = ends[i] > before ? std::clamp((u - before) / (ends[i] - before), 0.0, 1.0) : 0.5;
    return i;
}

}  // namespace

double Emitter::sample(const glm::dvec3& from, const std::array<double, 2>& u, glm::dvec3& direction) const
{
    if (sphere) {
        const double height = cap_height(*this, from);
        if (!(height > 0.0)) return 0.0;
        direction = around(glm::normalize(center - from), 1.0 - u[0] * height, u[1]);
        return 1.0 / (2.0 * kPi * height);
    }
    const double area = seen_area(*this, from);
    if (!(area > 0.0)) return 0.0;
    double at = u[0] * area;
    for (const Face& face : faces) {
        if (!turned_to(face, from)) continue;
        if (at < face.area) {
            const glm::dvec3 to = face.corner + (at / face.area) * face.a + u[1] * face.b - from;
            const double length = glm::length(to);
            direction = to / length;
            const double cosine = -glm::dot(direction, face.normal);
            return cosine > 0.0 ? length * length / (area * cosine) : 0.0;
        }
        at -= face.area;
    }
    return 0.0;
}

double Emitter::density(const glm::dvec3& from, const glm::dvec3& direction, double distance, std::uint32_t face) const
{
    if (sphere) {
        const double height = cap_height(*this, from);
        return height > 0.0 ? 1.0 / (2.0 * kPi * height) : 0.0;
    }
    if (face >= faces.size() || !turned_to(faces[face], from)) return 0.0;
    const double cosine = -glm::dot(direction, faces[face].normal);
    return cosine > 0.0 ? distance * distance / (seen_area(*this, from) * cosine) : 0.0;
}

SkyTable::SkyTable(std::size_t columns, std::size_t rows, const std::vector<float>& brightness)
    : columns_(columns), rows_(rows), row_ends_(rows), column_ends_(columns * rows)
{
    double sum = 0.0;
    for (std::size_t y = 0; y < rows; ++y) {
        double row = 0.0;
        const double share = height(y) - height(y + 1);  // of the solid angle
        for (std::size_t x = 0; x < columns; ++x)
            column_ends_[y * columns + x] = row += static_cast<double>(brightness[y * columns + x]);
        for (std::size_t x = 0; x < columns && row > 0.0; ++x) column_ends_[y * columns + x] /= row;
        row_ends_[y] = sum += share * row;
    }
    for (double& end : row_ends_) end /= sum;
}

glm::dvec3 SkyTable::direction(double x, double y)
{
    const double ring = std::sin(kPi * y), angle = 2.0 * kPi * x - kPi;
    return {ring * std::cos(angle), std::cos(kPi * y), ring * std::sin(angle)};
}

glm::dvec3 SkyTable::sample(const std::array<double, 2>& u) const
{
    double y = 0.0, x = 0.0;
    const std::size_t row = drawn(row_ends_.data(), rows_, u[0], y),
                      column = drawn(column_ends_.data() + row * columns_, columns_, u[1], x);
    const double z = height(row) + y * (height(row + 1) - height(row)), ring = std::sqrt(std::max(0.0, 1.0 - z * z)),
                 angle = 2.0 * kPi * (static_cast<double>(column) + x) / static_cast<double>(columns_) - kPi;
    return {ring * std::cos(angle), z, ring * std::sin(angle)};
}

double SkyTable::density(const glm::dvec3& d) const
{
    const auto cell = [](double at, std::size_t count) {
        return std::min(static_cast<std::size_t>(std::max(0.0, at) * static_cast<double>(count)), count - 1);
    };
    const std::size_t row = cell(std::acos(std::clamp(d.y, -1.0, 1.0)) / kPi, rows_),
                      column = cell((std::atan2(d.z, d.x) + kPi) / (2.0 * kPi), columns_);
    const double* ends = column_ends_.data() + row * columns_;
    const double rows = row_ends_[row] - (row > 0 ? row_ends_[row - 1] : 0.0),
                 columns = ends[column] - (column > 0 ? ends[column - 1] : 0.0);
    return rows * columns * static_cast<double>(columns_) / (2.0 * kPi * (height(row) - height(row + 1)));
}

std::uint32_t Sources::find(csg::PartId part) const
{
    const auto at = std::lower_bound(emitters.begin(), emitters.end(), part,
                                     [](const Emitter& e, csg::PartId p) { return e.part < p; });
    return at != emitters.end() && at->part == part ? static_cast<std::uint32_t>(at - emitters.begin()) : kNone;
}

}  // namespace trace::path
