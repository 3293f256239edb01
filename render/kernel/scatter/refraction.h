#pragma once

#include "render/kernel/interior/dispersion.h"
#include "render/kernel/context/context.h"

/// How rays go on from a hit (spec 3, section 8): what scatter() sends on, and photons.
namespace trace {

/// How light goes on through a surface, and what it loses on its way.
struct Refraction {
    glm::vec3 fade{1};
    bool straight = true;              ///< unbent: uses no level
    bool total = false;                ///< total internal reflection: the ray is the mirrored one
    int samples = 0;                   ///< of the spectrum: the ray has no direction yet, each sample has its own
    double ratio = 1, dispersion = 1;  ///< how the interface bends light of 555 nm, and others (spec 3, 8.5)
};

/// The same with the ray.
struct Refracted : Refraction {
    RayState ray;
};

/// Writes the state of a ray that goes on from a hit, mirrored or not. It is built in place: a copy of what was just
/// written in smaller pieces would stall on store forwarding.
[[gnu::always_inline]] inline void leave(const RayState& from, int level, std::uint8_t root, const csg::Ray& ray,
                                         float weight, RayState& out)
{
    out.ray = ray;
    out.weight = weight;
    out.level = level;
    out.root = root;
    out.scattered = from.scattered;
    out.wavelength = from.wavelength;
}
/// around: what it is inside of, before and after.
[[gnu::always_inline]] inline void be_mirrored(const InteriorList& around, RayState& out)
{
    out.kind = plan::RayKind::Reflection;
    out.stretch = 1.0;
    out.interiors = around;
}

/// Finds the ray that goes on behind a surface. False: nothing is behind it, as it has no interior.
bool refract(const Context& context, const HitPlace& hit, const glm::dvec3& top_normal, float weight, Refracted& out);

/// Bends direction d (as long as POV-Ray's) at an interface: out.ray.direction, with POV-Ray's length in out.stretch.
/// False: total reflection.
bool bend(const glm::dvec3& d, const glm::dvec3& normal, double ratio, RayState& out);

/// The ray that a mirror with this normal throws back, with the weight that it is given.
RayState mirrored(const Context& context, const HitPlace& hit, const glm::dvec3& normal, float weight);

/// Where a ray that leaves a hit begins to look.
double start_of(const Context& context, const HitPlace& hit, const glm::dvec3& direction);

/// The i-th ray of the spectrum beyond a surface; false: it is mirrored within.
bool disperse(const Context& context, const HitPlace& hit, const glm::dvec3& top_normal, const Refracted& refracted,
              int i, RayState& out);

}  // namespace trace
