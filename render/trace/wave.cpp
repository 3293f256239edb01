#include "render/trace/wave.h"

#include "render/texture/finish.h"
#include "render/trace/shade_context.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

/// As trace_ray decides it.
bool worth_tracing(const Context& context, const RayState& state)
{
    const plan::Settings& settings = context.scene.settings;
    return state.level < settings.max_trace_level && !(static_cast<double>(state.weight) < settings.adc_bailout);
}

Place wait(Context& context, std::vector<WaitingRay>& queue, const RayState& state, bool straight, double reach)
{
    if (!worth_tracing(context, state)) return kNowhere;
    Wave& wave = context.scratch.shade.wave;
    const auto place = static_cast<Place>(wave.colors.size());
    wave.colors.emplace_back();
    queue.push_back({state, place, straight ? state.level : state.level + 1, reach});
    return place;
}

/// The ray behind the surface, or the one that is mirrored where none gets through.
void go_through(Context& context, const HitPlace& hit, const texture::Finish& finish, Branch& branch, double reach)
{
    Onward next;
    if (!onward(context, hit, hit.normal, hit.state.weight * largest(glm::abs(branch.filter)), next)) return;
    Wave& wave = context.scratch.shade.wave;
    if (next.samples > 0) {
        branch.fade = next.fade;
        const scene::Color seen = dispersed(context, hit, hit.normal, finish, next);   // by recursion: few rays are dispersed
        branch.through = static_cast<Place>(wave.colors.size());
        wave.colors.push_back(seen);
        return;
    }
    branch.total = next.total;
    branch.fade = next.fade;
    ++(next.total ? context.scratch.counts.reflected : context.scratch.counts.refracted);
    branch.through = wait(context, next.total ? wave.mirrors : wave.rays, next.ray, next.straight, reach);
}

scene::Color color_of(const Wave& wave, const Branch& branch)
{
    glm::vec3 sum = branch.own;
    float transmit = 0.0f;
    if (branch.through != kNowhere) {
        const scene::Color& seen = wave.colors[branch.through];
        const glm::vec3 behind = seen.rgb() * branch.fade;
        sum += branch.total ? behind : behind * branch.filter;
        if (!branch.total) transmit = seen.transmit * scene::grey(branch.fade) * branch.residual;
    }
    if (branch.mirror != kNowhere) sum += branch.reflectivity * raised(wave.colors[branch.mirror], branch.power);
    scene::Color out = scene::Color::of(sum);
    out.transmit = transmit;
    return out;
}

}  // namespace

void Wave::clear(std::size_t camera_rays)
{
    rays.clear();
    mirrors.clear();
    batches.clear();
    branches.clear();
    airs.clear();
    colors.resize(camera_rays);
}

void Wave::end_tile(std::size_t first)
{
    if (rays.size() > first) batches.push_back(static_cast<std::uint32_t>(first));
    if (mirrors.empty()) return;
    batches.push_back(static_cast<std::uint32_t>(rays.size()));
    rays.insert(rays.end(), mirrors.begin(), mirrors.end());
    mirrors.clear();
}

void add_branch(Context& context, const HitPlace& hit, const texture::Finish& finish, const scene::Color& c,
                const glm::vec3& own, Place place, double reach)
{
    Wave& wave = context.scratch.shade.wave;
    Branch branch{own, glm::vec3(1), glm::vec3(1), glm::vec3(0), 0.0f, finish.reflection_power, false, place, kNowhere, kNowhere, kNowhere};
    float mirror_weight = 0.0f;
    if (finish.reflects()) {
        const double eta = finish.fresnel ? fresnel_index(context, hit) : 1.0;
        branch.reflectivity = texture::reflectivity(finish, c, hit.state.ray.direction, hit.normal, eta);
        const float strength = finish.fresnel ? largest(branch.reflectivity)
                                              : std::max(largest(finish.reflection_max), largest(finish.reflection_min));
        mirror_weight = hit.state.weight * std::max(0.0f, strength);
    }
    branch.filter = c.filter * c.rgb() + c.transmit;
    if (finish.conserve_energy) branch.filter *= glm::min(glm::vec3(1.0f), 1.0f - branch.reflectivity);
    branch.residual = std::min(1.0f, std::abs(scene::grey(branch.filter)));
    if (branch.residual > static_cast<float>(context.scene.settings.adc_bailout)) go_through(context, hit, finish, branch, reach);
    // Total reflection has already sent the mirrored ray.
    if (!black(branch.reflectivity) && !branch.total) {
        ++context.scratch.counts.reflected;
        branch.mirror = wait(context, wave.mirrors, mirrored(context, hit, hit.normal, mirror_weight), false, reach);
    }
    if (foggy(context)) {
        branch.air = static_cast<std::uint32_t>(wave.airs.size());
        wave.airs.push_back({hit.state, hit.met.t});
    }
    wave.branches.push_back(branch);
}

bool from_one_point(const WaitingRay* rays, int count, glm::dvec3& origin)
{
    // Some ten roundings of the distances at hand.
    constexpr double kRounding = 1e-14;
    const auto behind = [&](int i) { return rays[i].state.ray.origin - rays[i].reach * rays[i].state.ray.direction; };
    origin = behind(0);
    const glm::dvec3 size = glm::abs(origin);
    const double most = kRounding * (std::max({size.x, size.y, size.z}) + rays[0].reach);
    for (int i = 1; i < count; ++i) {
        const glm::dvec3 off = glm::abs(behind(i) - origin);
        if (!(std::max({off.x, off.y, off.z}) <= most)) return false;
    }
    return true;
}

void collect(Context& context)
{
    Wave& wave = context.scratch.shade.wave;
    for (std::size_t i = wave.branches.size(); i-- > 0;) {
        const Branch& branch = wave.branches[i];
        scene::Color c = color_of(wave, branch);
        if (branch.air != kNowhere) c = through_air(context, wave.airs[branch.air].state, wave.airs[branch.air].length, c);
        wave.colors[branch.place] = c;
    }
}

}  // namespace trace
