#include "render/plan/textures/compile_subsurface.h"
#include "numbers/functions/functions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace plan {
namespace {

/// The digits of n in a base, mirrored at the radix point: the van der Corput sequence.
double radical_inverse(std::uint32_t n, std::uint32_t base)
{
    double weight = 1.0, sum = 0.0;
    for (; n != 0; n /= base) {
        weight /= base;
        sum += (n % base) * weight;
    }
    return sum;
}

std::vector<glm::dvec3> sphere_directions()
{
    constexpr std::uint32_t kCycle = 32767;
    std::vector<glm::dvec3> out;
    out.reserve(kCycle);
    for (std::uint32_t n = 1; n <= kCycle; ++n) {
        const double x = 2.0 * radical_inverse(n, 2) - 1.0, turn = 2.0 * std::numbers::pi * radical_inverse(n, 3);
        const double around = std::sqrt(1.0 - x * x);
        out.push_back({x, around * numbers::cos(turn), around * numbers::sin(turn)});
    }
    return out;
}

}  // namespace

double diffuse_reflectance(double albedo, double internal)
{
    const double q = std::sqrt(3.0 * (1.0 - albedo));
    return 0.5 * albedo * (1.0 + numbers::exp(-4.0 / 3.0 * internal * q)) * numbers::exp(-q);
}

AlbedoTable::AlbedoTable(double internal)
{
    albedo_[0] = 0.0f;
    albedo_[kSteps] = 1.0f;
    for (std::size_t i = 1; i < kSteps; ++i) {
        const double wanted = static_cast<double>(i) / kSteps;
        double low = 0.0, high = 1.0;
        constexpr int kHalvings = 50;
        for (int k = 0; k < kHalvings; ++k) {
            const double middle = 0.5 * (low + high);
            (diffuse_reflectance(middle, internal) < wanted ? low : high) = middle;
        }
        albedo_[i] = static_cast<float>(0.5 * (low + high));
    }
}

bool has_subsurface(const scene::GlobalSettings& global, const Quality& quality)
{
    return global.subsurface.has_value() && quality.effects;
}

std::shared_ptr<const SubsurfacePlan> compile_subsurface(const scene::Description& description, const Quality& quality,
                                                         const std::vector<Interior>& interiors)
{
    const scene::GlobalSettings& global = description.global;
    if (!has_subsurface(global, quality)) return nullptr;
    auto plan = std::make_shared<SubsurfacePlan>();
    plan->diffuse_samples = std::max(0, global.subsurface->diffuse_samples);
    plan->single_samples = std::max(0, global.subsurface->single_samples);
    plan->radiosity = global.subsurface->radiosity;
    plan->mm_per_unit = global.mm_per_unit;
    plan->directions = sphere_directions();
    std::map<float, std::uint32_t> known;
    for (const Interior& interior : interiors) {
        const auto [at, fresh] = known.try_emplace(interior.ior, static_cast<std::uint32_t>(plan->tables.size()));
        if (fresh) plan->tables.emplace_back(internal_reflection(static_cast<double>(interior.ior)));
        plan->table_of.push_back(at->second);
    }
    return plan;
}

}  // namespace plan
