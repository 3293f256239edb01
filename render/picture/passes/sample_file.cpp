#include "render/picture/passes/sample_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace trace::radiosity {
namespace {

constexpr double kSteps = 127.0, kRound = 0.499999;

std::string written(const glm::vec3& direction)
{
    std::string out;
    for (int k = 0; k < 3; ++k) {
        const double steps = (static_cast<double>(direction[k]) + 1.0) * kSteps + kRound;
        out += fmt::format("{:02x}", static_cast<int>(std::clamp(steps, 0.0, 255.0)));
    }
    return out;
}

/// Zero for what has none.
glm::vec3 direction_of(const char* text)
{
    unsigned x = 0, y = 0, z = 0;
    if (std::sscanf(text, "%2x%2x%2x", &x, &y, &z) != 3) return glm::vec3(0);
    const glm::dvec3 v = glm::dvec3(x, y, z) / kSteps - 1.0;
    const double length = glm::length(v);
    return length > 0.0 ? glm::vec3(v / length) : glm::vec3(0);
}

}  // namespace

std::string line_of(const Found& found)
{
    const Sample& s = found.sample;
    return fmt::format("C{}\t{:g}\t{:g}\t{:g}\t{}\t{:.4f}\t{:.4f}\t{:.4f}\t{:g}\t{:g}\t{}\n", found.bounce + 1,
                       s.point.x, s.point.y, s.point.z, written(s.normal), s.color.x, s.color.y, s.color.z, s.reach,
                       s.nearest, written(s.nearest_way));
}

std::optional<Found> sample_of(std::string_view line)
{
    const std::string text(line);
    Found found{};
    Sample& s = found.sample;
    char normal[8] = {}, way[8] = {};
    constexpr int kFields = 11;
    if (std::sscanf(text.c_str(), "C%d %lf %lf %lf %6s %f %f %f %f %f %6s", &found.bounce, &s.point.x, &s.point.y,
                    &s.point.z, normal, &s.color.x, &s.color.y, &s.color.z, &s.reach, &s.nearest, way) != kFields)
        return std::nullopt;
    --found.bounce;
    s.normal = direction_of(normal);
    s.nearest_way = direction_of(way);
    const bool finite = std::isfinite(s.point.x + s.point.y + s.point.z) &&
                        std::isfinite(s.color.x + s.color.y + s.color.z) && std::isfinite(s.reach);
    if (found.bounce < 0 || !finite || !(s.reach >= 0.0f) || s.normal == glm::vec3(0)) return std::nullopt;
    return found;
}

std::vector<Found> read_samples(const std::string& path)
{
    std::ifstream file(path);
    if (!file) throw std::runtime_error(fmt::format("cannot read the radiosity samples of '{}'", path));
    std::vector<Found> out;
    for (std::string line; std::getline(file, line);)
        if (const std::optional<Found> found = sample_of(line)) out.push_back(*found);
    return out;
}

void write_samples(const std::string& path, const std::vector<SampleGrid>& samples)
{
    std::ofstream file(path);
    for (std::size_t bounce = 0; bounce < samples.size(); ++bounce)
        for (const Sample& sample : samples[bounce].samples()) file << line_of({static_cast<int>(bounce), sample});
    if (!file.flush()) throw std::runtime_error(fmt::format("cannot write the radiosity samples to '{}'", path));
}

}  // namespace trace::radiosity
