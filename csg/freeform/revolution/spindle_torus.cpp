#include "csg/freeform/revolution/spindle_torus.h"

#include "numbers/functions/functions.h"

namespace csg {

void SpindleTorus::intersect(const Ray& ray, IntersectionList& out) const
{
    double t[4];  // the outer sheet's pair; then the inner one's within it, or the outer one's second
    const int n = torus_.roots(ray, t);
    const bool nested = n == 4 && t[2] <= t[1];
    const auto span = [&](double in, std::uint32_t in_face, double end, std::uint32_t end_face) {
        return out.enter(in, in_face) && out.leave(end, end_face);
    };
    switch (spindle_) {
    case Spindle::Intersection:
        if (nested) span(t[2], kInner, t[3], kInner);
        return;
    case Spindle::Difference:
        if (nested) {
            if (span(t[0], kOuter, t[2], kInner)) span(t[3], kInner, t[1], kOuter);
            return;
        }
        break;
    case Spindle::Union:
        if (nested) {
            out.touch(t[2], kInner);
            out.touch(t[3], kInner);
        }
        break;
    case Spindle::Merge: break;
    }
    for (int i = 0; i + 1 < (nested ? 2 : n); i += 2)
        if (!span(t[i], kOuter, t[i + 1], kOuter)) return;
}

bool SpindleTorus::in_spindle(double rho, double y) const
{
    const double away = rho + torus_.major;
    return away * away + (y - torus_.minor) * (y + torus_.minor) <= 0.0;
}

bool SpindleTorus::contains(const glm::dvec3& p) const
{
    const double rho = numbers::hypot(p.x, p.z);
    if (spindle_ == Spindle::Intersection) return in_spindle(rho, p.y);
    return torus_.contains(p) && !(spindle_ == Spindle::Difference && in_spindle(rho, p.y));
}

glm::dvec3 SpindleTorus::gradient(const glm::dvec3& p, std::uint32_t face) const
{
    const double rho = numbers::hypot(p.x, p.z), away = face == kInner ? torus_.major : -torus_.major;
    const double stretch = rho > 0.0 ? 1.0 + away / rho : 0.0;
    return {p.x * stretch, p.y, p.z * stretch};
}

Aabb SpindleTorus::bounds() const
{
    const double major = torus_.major, minor = torus_.minor;
    if (spindle_ != Spindle::Intersection)
        return {{-major - minor, -minor, -major - minor}, {major + minor, minor, major + minor}};
    const double wide = minor - major, high = std::sqrt(wide * (minor + major));
    return {{-wide, -high, -wide}, {wide, high, wide}};
}

}  // namespace csg
