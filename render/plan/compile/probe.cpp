#include "render/plan/probe.h"

#include "csg/tree/program.h"
#include "function/field/field.h"
#include "render/plan/textures/textures.h"
#include "render/texture/function_host.h"
#include "render/texture/noise/noise.h"

#include <algorithm>
#include <stdexcept>

namespace plan {
namespace {

constexpr double kMinDistance = 1e-4;  // nearer crossings do not count (spec 3, 3.1)
constexpr std::uint8_t kEveryRay = 0xff;

/// The geometry alone: a texture costs time and says nothing here.
CompiledScene compile_alone(const scene::Object& object, const scene::GlobalSettings& global,
                            std::optional<scene::PovRay> povray)
{
    scene::Description alone;
    alone.global.noise_generator = global.noise_generator;
    alone.global.number_of_waves = global.number_of_waves;
    auto texture = std::make_shared<scene::Texture>();
    texture->kind = std::vector<scene::Layer>{scene::Layer{}};
    alone.default_texture = texture;
    alone.objects.push_back(object);
    scene::Object& copy = alone.objects.back();
    copy.texture = nullptr;
    copy.default_texture = scene::Object::kNoDefault;
    if (copy.details->interior_texture) copy.details.edit().interior_texture = nullptr;
    copy.flags.no_image = copy.flags.no_shadow = copy.flags.no_reflection = false;
    Options options;
    if (povray) alone.povray = *povray;
    options.last_bits = povray.has_value();
    options.query = true;
    return compile(alone, options);
}

}  // namespace

ObjectProbe::ObjectProbe(const scene::Object& object, const scene::GlobalSettings& global,
                         std::optional<scene::PovRay> povray)
    : compiled_(compile_alone(object, global, povray)), inside_(compiled_.world().data()),
      scratch_(std::make_unique<csg::Scratch>())
{}
ObjectProbe::~ObjectProbe() = default;

ObjectProbe::Answer ObjectProbe::trace(const glm::dvec3& origin, const glm::dvec3& direction)
{
    const csg::Ray ray{origin, direction};
    const csg::World world = compiled_.world();
    const csg::Hit hit = world.nearest(ray, kMinDistance, numbers::kInfinity, kEveryRay, *scratch_);
    if (!hit.found()) return {};
    const csg::HitDetails details = world.details(ray, hit, false);
    return {true, details.point, details.normal};
}

bool ObjectProbe::inside(const glm::dvec3& point) const { return inside_.holds(point); }

glm::dvec3 turbulence(const glm::dvec3& point, int octaves, double lambda, double omega)
{
    return texture::vector_turbulence(point, octaves, lambda, omega);
}

FunctionProbe::FunctionProbe(const function::FunctionPtr& called, const scene::Description& so_far)
{
    constexpr int kWaves = 10;
    scene::Description description;
    description.global = so_far.global;
    description.effective_version = so_far.effective_version;
    description.povray = so_far.povray;
    description.global.number_of_waves = kWaves;
    std::vector<scene::Unsupported> notes;
    TextureCompiler compiler(description, Quality(), set_, notes);  // of all that a picture may have
    if (compiler.function(called) == kNone)
        throw std::runtime_error(notes.empty() ? "this function cannot be evaluated"
                                               : notes.front().what + " is not available yet");
}

function::Values FunctionProbe::evaluate(const double* arguments) const
{
    return function::in_use().all(*set_.functions.back(), arguments, texture::FunctionHost(set_));
}

void FunctionProbe::evaluate(std::span<const glm::dvec3> points, std::span<function::Values> values) const
{
    const function::Function& called = *set_.functions.back();
    const texture::FunctionHost host(set_);
    alignas(64) double at[3][function::kMostTogether],
        out[std::tuple_size_v<function::Values>][function::kMostTogether];
    const double* const arguments[] = {at[0], at[1], at[2]};
    double* const results[] = {out[0], out[1], out[2], out[3], out[4]};
    std::size_t first = 0;
    while (points.size() - first >= function::kLanes) {
        const std::size_t count = std::min(points.size() - first, function::kMostTogether) / function::kLanes *
                                  function::kLanes;
        for (std::size_t k = 0; k < count; ++k)
            for (int axis = 0; axis < 3; ++axis) at[axis][k] = points[first + k][axis];
        function::in_use().lanes(called, arguments, count, host, called.components, results);
        for (std::size_t k = 0; k < count; ++k)
            for (std::size_t part = 0; part < called.components; ++part) values[first + k][part] = out[part][k];
        first += count;
    }
    for (; first < points.size(); ++first) values[first] = evaluate(&points[first].x);
}

}  // namespace plan
