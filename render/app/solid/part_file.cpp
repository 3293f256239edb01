#include "render/app/solid/part_file.h"

#include "function/build/builder.h"
#include "render/plan/probe.h"
#include "render/scene/function.h"

#include "render/app/report/json_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

double srgb(double linear)
{
    const double v = std::clamp(linear, 0.0, 1.0);
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
}

/// The first pigment for which `wanted` holds, of the object's own layers or of those of its parts.
template <class F>
const scene::Pigment* pigment_of(const scene::Object& object, const F& wanted)
{
    if (object.texture != nullptr)
        if (const auto* layers = std::get_if<std::vector<scene::Layer>>(&object.texture->kind))
            for (const scene::Layer& layer : *layers)
                if (wanted(layer.pigment)) return &layer.pigment;
    if (const auto* csg = std::get_if<scene::Csg>(&object.shape))
        for (const scene::Object& operand : *csg->operands)
            if (const scene::Pigment* found = pigment_of(operand, wanted)) return found;
    return nullptr;
}

bool is_plain(const scene::Pigment& pigment) { return std::holds_alternative<scene::Color>(pigment.kind); }

}  // namespace

bool color_of(const scene::Object& object, std::array<double, 3>& out)
{
    const scene::Pigment* found = pigment_of(object, is_plain);
    if (found == nullptr) return false;
    const glm::vec3 rgb = std::get<scene::Color>(found->kind).rgb();
    for (std::size_t k = 0; k < 3; ++k) out[k] = srgb(static_cast<double>(rgb[static_cast<int>(k)]));
    return true;
}

std::vector<std::array<double, 3>> colors_at(const scene::Object& object, const scene::Description& description,
                                             const std::vector<glm::vec3>& points)
{
    std::vector<std::array<double, 3>> out;
    const scene::Pigment* found = pigment_of(object, [](const scene::Pigment&) { return true; });
    if (found == nullptr || is_plain(*found)) return out;
    constexpr std::uint32_t kParameters = 3, kComponents = 5;
    const function::SceneUse use{function::SceneUse::Kind::Pigment, std::make_shared<scene::PigmentFunction>(*found)};
    const plan::FunctionProbe probe(function::make_outer(use, kParameters, kComponents), description);
    const std::vector<glm::dvec3> places(points.begin(), points.end());
    std::vector<function::Values> values(places.size());
    probe.evaluate(places, values);
    for (const function::Values& v : values) out.push_back({srgb(v[0]), srgb(v[1]), srgb(v[2])});
    return out;
}

solid::RefineOptions refine_options(double tolerance, int cells, PartClock::time_point start, double seconds,
                                    const Cancellation& cancel)
{
    solid::RefineOptions out;
    out.tolerance = tolerance;
    out.cells = cells;
    out.cancel = &cancel.requested;
    out.deadline = start + std::chrono::duration_cast<PartClock::duration>(std::chrono::duration<double>(seconds));
    return out;
}

void tell_too_far(const std::string& part, const char* what, double worst, double tolerance,
                  const solid::RefineFacts& facts)
{
    fmt::print(stderr, "{}: warning: {} is off by {:.3g} somewhere, more than {:g}{}\n", part, what, worst, tolerance,
               facts.full   ? ": there was no room for finer triangles"
               : facts.late ? ": there was no time for finer triangles (--seconds)"
                            : "");
}

}  // namespace app
