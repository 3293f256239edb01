#include "render/kernel/camera/camera_rays.h"

#include "numbers/functions/functions.h"
#include "numbers/lanes.h"
#include "render/plan/camera_starts.h"
#include "render/texture/evaluate.h"
#include "render/texture/function_host.h"
#include "render/kernel/camera/mesh_camera_ray.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace trace {
namespace {

using Kind = scene::Camera::Kind;

constexpr double kPi = std::numbers::pi;
constexpr double kDefaultAngleDeg = 90.0;
constexpr double kDefaultSphericalAngleDeg = 360.0;
/// Aspect ratio above which an omnimax picture is cropped at the sides instead of squeezed (spec 2, 4.6).
constexpr double kOmnimaxAspect = 1.283458;

double radians(double degrees) { return degrees * (kPi / 180.0); }

/// A zero vector stays zero: a camera without an extent gives rays along its axis, not NaN.
glm::dvec3 unit(const glm::dvec3& v)
{
    const double length = glm::length(v);
    return length > 0 ? v / length : v;
}

/// Rotation by `angle` about the unit vector `axis`, in POV-Ray's left-handed sense (as vaxis_rotate).
glm::dvec3 rotated(const glm::dvec3& v, const glm::dvec3& axis, double angle)
{
    const double c = numbers::cos(angle), s = numbers::sin(angle);
    return v * c + glm::cross(axis, v) * s + axis * (glm::dot(axis, v) * (1 - c));
}

/// The polar angle of a place in a round picture as a normal of the camera sees it, in [-pi/2, 3/2 pi): POV-Ray goes on
/// from the left half into the lower left quarter, and breaks off below the centre.
double polar_angle(double a, double b)
{
    const double phi = numbers::atan2(b, a);
    return a < 0.0 && b < 0.0 ? phi + 2.0 * kPi : phi;
}

/// A place from the middle of the screen, in screens up; the last bit goes by the program (spec 7d, 6).
template <class T>
T screen_row(const T& py, double height, scene::PovRay povray)
{
    if (povray == scene::PovRay::V38) return T(0.5) - (py + T(0.5)) / T(height);
    return (T(height - 0.5) - py) / T(height) - T(0.5);
}

/// Pixels' places from the middle of the screen, in screens to the right and up.
std::pair<numbers::lanes::Double, numbers::lanes::Double> on_screen(const double* px, const double* py, double width,
                                                                    double height, scene::PovRay povray)
{
    using numbers::lanes::Double;
    return {(Double::load_aligned(px) + Double(0.5)) / Double(width) - Double(0.5),
            screen_row(Double::load_aligned(py), height, povray)};
}

}  // namespace

CameraRays::CameraRays(const scene::Camera& camera, int width, int height, const Extras& extras)
    : camera_(camera), extras_(extras), width_(width), height_(height), unit_direction_(unit(camera.direction)),
      unit_right_(unit(camera.right)), unit_up_(unit(camera.up)), length_right_(glm::length(camera.right)),
      length_up_(glm::length(camera.up)), common_origin_(!plan::starts_differ(camera))
{
    const bool spherical = camera.kind == Kind::Spherical;
    const double fallback = spherical ? kDefaultSphericalAngleDeg : kDefaultAngleDeg;
    const double angle = camera.angle_deg != 0 ? camera.angle_deg : fallback;
    angle_ = radians(angle);
    angle2_ = radians(camera.angle2_deg != 0 ? camera.angle2_deg : angle / 2);
}

bool CameraRays::ray(double px, double py, csg::Ray& out, int k) const
{
    glm::dvec2 place;
    if (!project(px, py, k, out, place)) return false;
    const double length = glm::length(out.direction);
    if (!(length > 0)) return false;
    out.direction /= length;
    if (extras_.normal == texture::kNone) return true;
    texture::Surroundings around;
    out.direction = glm::normalize(
        texture::perturb(*extras_.textures, extras_.normal, out.direction, {place.x, place.y, 0.0}, around));
    return out.direction == out.direction;
}

void CameraRays::fetch(double px, double py, int k) const
{
    if (camera_.kind == Kind::Mesh && extras_.mesh)
        fetch_mesh_camera_ray(*extras_.mesh, px, py, static_cast<int>(width_), static_cast<int>(height_), k);
}

bool CameraRays::unscaled_ray(double px, double py, csg::Ray& out) const
{
    glm::dvec2 place;
    return project(px, py, 0, out, place);
}

bool CameraRays::project(double px, double py, int k, csg::Ray& out, glm::dvec2& place) const
{
    const double u = (px + 0.5) / width_ - 0.5;
    const double v = screen_row(py, height_, camera_.povray);
    out.origin = camera_.location;
    place = {u, v};
    bool found = true;
    switch (camera_.kind) {
    case Kind::Perspective: out.direction = camera_.direction + u * camera_.right + v * camera_.up; break;
    case Kind::Orthographic:
        out.origin += u * camera_.right + v * camera_.up;
        out.direction = camera_.direction;
        break;
    case Kind::Fisheye: found = fisheye(u, v, out, place); break;
    case Kind::UltraWideAngle: {
        const double alpha = u * angle_, beta = v * angle_ * length_up_ / length_right_;
        place = {alpha, beta};
        out.direction = numbers::sin(alpha) * unit_right_ + numbers::sin(beta) * unit_up_ +
                        numbers::cos(alpha) * numbers::cos(beta) * unit_direction_;
        break;
    }
    case Kind::Omnimax: found = omnimax(u, v, out, place); break;
    case Kind::Panoramic: panoramic(px, v, out, place); break;
    case Kind::Cylinder: cylinder(u, v, out, place); break;
    case Kind::Spherical: spherical(u, v, out, place); break;
    case Kind::UserDefined: user_defined(u, v, out); break;
    case Kind::Mesh:
        place = {0, 0};
        found = extras_.mesh &&
                mesh_camera_ray(*extras_.mesh, px, py, static_cast<int>(width_), static_cast<int>(height_), k, out);
        break;
    }
    return found;
}

bool CameraRays::perspective(const double* px, const double* py, csg::RayTile& rays) const
{
    using numbers::lanes::Double;
    const glm::dvec3 &d = camera_.direction, &r = camera_.right, &up = camera_.up;
    std::uint32_t long_enough = ~0u;
    for (int i = 0; i < rays.count; i += numbers::lanes::kDoubles) {
        const auto [u, v] = on_screen(px + i, py + i, width_, height_, camera_.povray);
        const Double x = Double(d.x) + u * Double(r.x) + v * Double(up.x);
        const Double y = Double(d.y) + u * Double(r.y) + v * Double(up.y);
        const Double z = Double(d.z) + u * Double(r.z) + v * Double(up.z);
        const Double length = xsimd::sqrt(x * x + y * y + z * z);
        long_enough &= numbers::lanes::mask(length > Double(0.0));
        (x / length).store_aligned(rays.dx.data() + i);
        (y / length).store_aligned(rays.dy.data() + i);
        (z / length).store_aligned(rays.dz.data() + i);
    }
    constexpr std::uint32_t kAll = (1u << numbers::lanes::kDoubles) - 1u;
    return (long_enough & kAll) == kAll;
}

bool CameraRays::parallel(const double* px, const double* py, csg::RayTile& rays) const
{
    using numbers::lanes::Double;
    const glm::dvec3 &o = camera_.location, &r = camera_.right, &up = camera_.up;
    const double length = glm::length(camera_.direction);
    if (!(length > 0)) return false;
    const glm::dvec3 d = camera_.direction / length;
    for (int i = 0; i < rays.count; i += numbers::lanes::kDoubles) {
        const auto [u, v] = on_screen(px + i, py + i, width_, height_, camera_.povray);
        (Double(o.x) + (u * Double(r.x) + v * Double(up.x))).store_aligned(rays.ox.data() + i);
        (Double(o.y) + (u * Double(r.y) + v * Double(up.y))).store_aligned(rays.oy.data() + i);
        (Double(o.z) + (u * Double(r.z) + v * Double(up.z))).store_aligned(rays.oz.data() + i);
        Double(d.x).store_aligned(rays.dx.data() + i);
        Double(d.y).store_aligned(rays.dy.data() + i);
        Double(d.z).store_aligned(rays.dz.data() + i);
    }
    return true;
}

void CameraRays::unscaled_perspective(const double* px, const double* py, int count, double* dx, double* dy,
                                      double* dz) const
{
    using numbers::lanes::Double;
    const glm::dvec3 &d = camera_.direction, &r = camera_.right, &up = camera_.up;
    for (int i = 0; i < count; i += numbers::lanes::kDoubles) {
        const auto [u, v] = on_screen(px + i, py + i, width_, height_, camera_.povray);
        (Double(d.x) + u * Double(r.x) + v * Double(up.x)).store_aligned(dx + i);
        (Double(d.y) + u * Double(r.y) + v * Double(up.y)).store_aligned(dy + i);
        (Double(d.z) + u * Double(r.z) + v * Double(up.z)).store_aligned(dz + i);
    }
}

glm::dvec3 CameraRays::polar(double theta, double a, double b) const
{
    const double phi = numbers::atan2(b, a);
    return numbers::sin(theta) * numbers::cos(phi) * unit_right_ + numbers::sin(theta) * numbers::sin(phi) * unit_up_ +
           numbers::cos(theta) * unit_direction_;
}

bool CameraRays::fisheye(double u, double v, csg::Ray& out, glm::dvec2& place) const
{
    const double a = 2 * u * length_right_, b = 2 * v * length_up_, rho = numbers::hypot(a, b);
    if (rho > 1) return false;
    place = {polar_angle(a, b), rho * angle_ / 2};
    out.direction = polar(place.y, a, b);
    return true;
}

bool CameraRays::omnimax(double u, double v, csg::Ray& out, glm::dvec2& place) const
{
    const double q = length_right_ / length_up_;
    double a = 2 * u, b = 2 * v;
    if (q > kOmnimaxAspect) {
        a *= q / kOmnimaxAspect;
        b = (b - 1) / kOmnimaxAspect + 1;
    } else if (q > 1) {
        b = (b - 1) / q + 1;
    } else {
        b /= q;
    }
    const double rho = numbers::hypot(a, b);
    if (rho > 1) return false;
    const double rho2 = rho * rho;
    const double theta = rho * (1.411269 + rho2 * (-0.09439 + rho2 * 0.25674));
    place = {polar_angle(a, b), theta};
    // More than 45 degrees below the horizon there is only the projection booth.
    if (numbers::sin(numbers::atan2(b, a)) * numbers::sin(theta) < numbers::tan(radians(135)) * numbers::cos(theta))
        return false;
    out.direction = polar(theta, a, b);
    return true;
}

void CameraRays::user_defined(double u, double v, csg::Ray& out) const
{
    constexpr std::size_t kMostParameters = 8;
    out.direction = camera_.direction;
    for (std::size_t i = 0; i < extras_.functions.size(); ++i) {
        if (extras_.functions[i] == texture::kNone) continue;
        const function::Function& one = *extras_.textures->functions[extras_.functions[i]];
        if (one.parameters > kMostParameters) continue;
        const std::array<double, kMostParameters> place{u, v};
        const auto axis = static_cast<glm::length_t>(i % 3);
        (i < 3 ? out.origin : out.direction)[axis] =
            function::evaluate(one, place.data(), texture::FunctionHost(*extras_.textures));
    }
}

void CameraRays::panoramic(double px, double v, csg::Ray& out, glm::dvec2& place) const
{
    constexpr double kVertical = 1e-10;  // closer to straight up than this counts as straight up
    constexpr double kVerticalTangent = 2e10;
    const double a = (1 - (px + 0.5) / width_) * kPi, b = v * kPi;
    place = {a, b};
    const double rise = std::abs(kPi / 2 - std::abs(b)) < kVertical ? std::copysign(kVerticalTangent, b)
                                                                    : numbers::tan(b);
    out.direction = numbers::cos(a) * camera_.right + rise * camera_.up + numbers::sin(a) * camera_.direction;
}

void CameraRays::cylinder(double u, double v, csg::Ray& out, glm::dvec2& place) const
{
    const double across = u * angle_, along = v * angle_;
    if (camera_.cylinder_type == 1 || camera_.cylinder_type == 3) {
        place = {across, v * length_up_};
        out.direction = numbers::sin(across) * unit_right_ + numbers::cos(across) * unit_direction_;
        (camera_.cylinder_type == 1 ? out.direction : out.origin) += v * length_up_ * unit_up_;
    } else {
        place = {u * length_right_, along};
        out.direction = numbers::sin(along) * unit_up_ + numbers::cos(along) * unit_direction_;
        (camera_.cylinder_type == 2 ? out.direction : out.origin) += u * length_right_ * unit_right_;
    }
}

void CameraRays::spherical(double u, double v, csg::Ray& out, glm::dvec2& place) const
{
    place = {u * angle_, v * angle2_};
    const glm::dvec3 tilted = rotated(unit_direction_, unit_right_, -v * angle2_);
    out.direction = rotated(tilted, unit_up_, u * angle_);
}

}  // namespace trace
