#include "render/kernel/path/sources.h"
#include "numbers/functions/functions.h"

#include <algorithm>
#include <cmath>

namespace trace::path {
namespace {

/// The area of all faces that a point outside sees.
double seen_area(const Emitter& body, const glm::dvec3& from)
{
    if (!body.convex) return body.ends.empty() ? 0.0 : body.ends.back();
    double area = 0.0;
    for (const Emitter::Face& face : body.faces) area += face.seen_area(from);
    return area;
}

/// The offset of a point from the axis of a round cylinder, in radii, and half of the angle of its side that the point
/// sees.
struct Around {
    double x, y, half;

    Around(const Emitter::Face& side, const glm::dvec3& from)
    {
        const double radius2 = glm::dot(side.a, side.a);
        x = glm::dot(from - side.corner, side.a) / radius2;
        y = glm::dot(from - side.corner, side.b) / radius2;
        const double away = std::sqrt(x * x + y * y);
        half = away > 1.0 ? numbers::acos(1.0 / away) : 0.0;
    }
};

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

double Emitter::Face::seen_area(const glm::dvec3& from) const
{
    if (shape != Shape::Side) return glm::dot(from - corner, normal) > 0.0 ? area : 0.0;
    return area * Around(*this, from).half / kPi;
}

glm::dvec3 Emitter::Face::normal_at(const glm::dvec3& place) const
{
    if (shape != Shape::Side) return normal;
    const glm::dvec3 off = place - corner;
    return glm::normalize(off - axis * (glm::dot(off, axis) / glm::dot(axis, axis)));
}

glm::dvec3 Emitter::Face::place(const glm::dvec3& from, const std::array<double, 2>& u, glm::dvec3& unit) const
{
    unit = normal;
    switch (shape) {
    case Shape::Parallelogram: break;
    case Shape::Triangle: {
        const double root = std::sqrt(u[0]);
        return corner + (root * (1.0 - u[1])) * a + (root * u[1]) * b;
    }
    case Shape::Ring: {
        const double r = std::sqrt(hole * hole + u[0] * (1.0 - hole * hole)), angle = 2.0 * kPi * u[1];
        return corner + (r * numbers::cos(angle)) * a + (r * numbers::sin(angle)) * b;
    }
    case Shape::Side: {
        const Around seen(*this, from);
        const double angle = numbers::atan2(seen.y, seen.x) + (2.0 * u[1] - 1.0) * seen.half;
        const glm::dvec3 out = numbers::cos(angle) * a + numbers::sin(angle) * b;
        unit = glm::normalize(out);
        return corner + out + u[0] * axis;
    }
    }
    return corner + u[0] * a + u[1] * b;
}

double Emitter::sample(const glm::dvec3& from, const std::array<double, 2>& u, glm::dvec3& direction,
                       std::uint32_t& face) const
{
    face = kAnyFace;
    if (sphere) {
        const double height = cap_height(*this, from);
        if (!(height > 0.0)) return 0.0;
        direction = around(glm::normalize(center - from), 1.0 - u[0] * height, u[1]);
        return 1.0 / (2.0 * kPi * height);
    }
    const double area = seen_area(*this, from);
    if (!(area > 0.0)) return 0.0;
    const double at = u[0] * area;
    std::size_t i = 0;
    double before = 0.0, own = 0.0;
    if (convex) {
        for (; i < faces.size(); ++i, before += own) {
            own = faces[i].seen_area(from);
            if (at < before + own) break;
        }
    } else {
        i = static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), at) - ends.begin());
        if (i > 0) before = ends[i - 1];
        if (i < faces.size()) own = faces[i].area;
        face = static_cast<std::uint32_t>(i);
    }
    if (i >= faces.size() || !(own > 0.0)) return 0.0;
    glm::dvec3 normal;
    const glm::dvec3 to = faces[i].place(from, {std::min((at - before) / own, 1.0), u[1]}, normal) - from;
    const double length = glm::length(to);
    if (!(length > 0.0)) return 0.0;
    direction = to / length;
    const double turned = -glm::dot(direction, normal), cosine = convex ? turned : std::abs(turned);
    return cosine > 0.0 ? length * length / (area * cosine) : 0.0;
}

double Emitter::density(const glm::dvec3& from, const glm::dvec3& direction, double distance, std::uint32_t face) const
{
    if (sphere) {
        const double height = cap_height(*this, from);
        return height > 0.0 ? 1.0 / (2.0 * kPi * height) : 0.0;
    }
    const std::size_t i = faces.size() == 1 ? 0 : face;
    if (i >= faces.size()) return 0.0;
    const double area = seen_area(*this, from);
    const double turned = -glm::dot(direction, faces[i].normal_at(from + distance * direction));
    const double cosine = convex ? turned : std::abs(turned);
    if (!(area > 0.0) || (convex && !(faces[i].seen_area(from) > 0.0))) return 0.0;
    return cosine > 0.0 ? distance * distance / (area * cosine) : 0.0;
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
    const double ring = numbers::sin(kPi * y), angle = 2.0 * kPi * x - kPi;
    return {ring * numbers::cos(angle), numbers::cos(kPi * y), ring * numbers::sin(angle)};
}

glm::dvec3 SkyTable::sample(const std::array<double, 2>& u) const
{
    double y = 0.0, x = 0.0;
    const std::size_t row = drawn(row_ends_.data(), rows_, u[0], y),
                      column = drawn(column_ends_.data() + row * columns_, columns_, u[1], x);
    const double z = height(row) + y * (height(row + 1) - height(row)), ring = std::sqrt(std::max(0.0, 1.0 - z * z)),
                 angle = 2.0 * kPi * (static_cast<double>(column) + x) / static_cast<double>(columns_) - kPi;
    return {ring * numbers::cos(angle), z, ring * numbers::sin(angle)};
}

double SkyTable::density(const glm::dvec3& d) const
{
    const auto cell = [](double at, std::size_t count) {
        return std::min(static_cast<std::size_t>(std::max(0.0, at) * static_cast<double>(count)), count - 1);
    };
    const std::size_t row = cell(numbers::acos(std::clamp(d.y, -1.0, 1.0)) / kPi, rows_),
                      column = cell((numbers::atan2(d.z, d.x) + kPi) / (2.0 * kPi), columns_);
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
