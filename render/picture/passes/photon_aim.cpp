#include "render/picture/passes/photon_aim.h"

#include "numbers/functions/lane_functions.h"
#include "numbers/lane_arithmetic.h"
#include "render/kernel/context/projected.h"
#include "render/light/illuminate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace trace {
namespace {

constexpr double kPi = std::numbers::pi, kCenter = 1e-10;

using numbers::lanes::Double;
constexpr std::size_t kLanes = static_cast<std::size_t>(numbers::lanes::kDoubles);

/// One vector, or one in each lane.
template <class V>
struct Vectors {
    V x, y, z;

    Vectors of_unit_length() const
    {
        const V inverse = V(1.0) / numbers::lanes::root_of(V(x * x + y * y + z * z));
        return {x * inverse, y * inverse, z * inverse};
    }
};

/// v turned about a unit axis, right-handed, by the angle of this sine and cosine.
template <class V>
Vectors<V> turned(const Vectors<V>& v, const glm::dvec3& axis, const numbers::SineAndCosine<V>& angle)
{
    const V &s = angle.sine, &c = angle.cosine;
    const V along = (1.0 - c) * (axis.x * v.x + axis.y * v.y + axis.z * v.z);
    return {c * v.x + s * (axis.y * v.z - v.y * axis.z) + along * axis.x,
            c * v.y + s * (axis.z * v.x - v.z * axis.x) + along * axis.y,
            c * v.z + s * (axis.x * v.y - v.x * axis.y) + along * axis.z};
}

/// The direction at an angle from the way ahead, away from `left`.
template <class V>
Vectors<V> aside(const glm::dvec3& ahead, const glm::dvec3& left, const numbers::SineAndCosine<V>& off)
{
    const V &s = off.sine, &c = off.cosine;
    return {c * ahead.x - s * left.x, c * ahead.y - s * left.y, c * ahead.z - s * left.z};
}

}  // namespace

PhotonAim::PhotonAim(const light::Light& light, const plan::PhotonLight& flags, const plan::PhotonTarget& target,
                     double spacing, const scene::PhotonSettings& settings)
    : light_(light), target_(target), parallel_(flags.parallel), area_(flags.area && !flags.parallel),
      jitter_(settings.jitter)
{
    light_.fade_power = 0.0;
    frame_ = frame(light.location);
    distance_ = glm::length(target.center - light.location);
    step_ = target.density * spacing;
    if (!parallel_) step_ /= distance_;
    if (area_) step_ *= std::sqrt(static_cast<double>(light.size1 * light.size2));
    dtheta_ = parallel_ ? step_ : numbers::atan(step_);
    theta_end_ = parallel_                    ? target.radius
                 : distance_ >= target.radius ? numbers::asin(target.radius / distance_)
                                              : kPi;
}

PhotonAim::Frame PhotonAim::frame(const glm::dvec3& from) const
{
    constexpr double kNearZ = 0.1;
    Frame out;
    out.toward = glm::normalize(target_.center - from);
    const bool along_z = std::abs(std::abs(out.toward.z) - 1.0) < kNearZ;
    const glm::dvec3 up = along_z ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    out.left = glm::normalize(glm::cross(parallel_ ? light_.axis : out.toward, up));
    return out;
}

double PhotonAim::estimate() const
{
    const double rings = theta_end_ / dtheta_;
    const double many = parallel_ ? kPi * rings * rings
                                  : 2.0 * kPi * (1.0 - numbers::cos(theta_end_)) / (dtheta_ * dtheta_);
    return area_ ? many * light_.size1 * light_.size2 : many;
}

bool PhotonAim::ring(JitterStream& jitter, std::vector<Emission>& out)
{
    if (!(theta_ < theta_end_)) return false;
    const double dphi = theta_ < kCenter ? 2.0 * kPi : parallel_ ? dtheta_ / theta_ : dtheta_ / numbers::sin(theta_);
    const double start = -kPi + dphi * jitter.draw() * 0.5;
    const double end = 2.0 * kPi + start - dphi * 0.5;
    off_.clear();
    around_.clear();
    for (double phi = start; phi < end; phi += dphi) {
        around_.push_back(phi + dphi * (jitter.draw() - 0.5) * jitter_);
        off_.push_back(theta_ + dtheta_ * (jitter.draw() - 0.5) * jitter_);
    }
    send_ring(out);
    theta_ += dtheta_;
    ++ring_;
    return true;
}

void PhotonAim::send_ring(std::vector<Emission>& out)
{
    const std::size_t count = off_.size();
    off_.resize(count + kLanes);  // the last lanes read beyond
    around_.resize(count + kLanes);
    const glm::dvec3 ahead = glm::normalize(light_.axis),
                     foot = target_.center - light_.axis * glm::dot(light_.axis, frame_.toward) * distance_;
    for (std::size_t i = 0; i < count; i += kLanes) {
        const Double off = Double::load_unaligned(&off_[i]);
        const auto around = numbers::sine_and_cosine(Double::load_unaligned(&around_[i]));
        std::array<double, kLanes> x, y, z;
        const auto each = [&](const Vectors<Double>& v, auto&& f) {
            v.x.store_unaligned(x.data());
            v.y.store_unaligned(y.data());
            v.z.store_unaligned(z.data());
            for (std::size_t k = 0; k < std::min(kLanes, count - i); ++k) f(k, glm::dvec3(x[k], y[k], z[k]));
        };
        if (parallel_) {
            const glm::dvec3& left = frame_.left;
            each(turned<Double>({left.x * off, left.y * off, left.z * off}, light_.axis, around),
                 [&](std::size_t, const glm::dvec3& from) { send_from(foot + from, ahead, 1.0f, out); });
            continue;
        }
        const auto cone = numbers::sine_and_cosine(off);
        if (!area_) {
            each(turned(aside(frame_.toward, frame_.left, cone), frame_.toward, around).of_unit_length(),
                 [&](std::size_t, const glm::dvec3& way) { send_from(light_.location, way, 1.0f, out); });
            continue;
        }
        std::array<double, kLanes> across, along;
        cone.sine.store_unaligned(across.data());
        cone.cosine.store_unaligned(along.data());
        each({around.sine, around.cosine, off}, [&](std::size_t k, const glm::dvec3& turn) {
            send_from_area({across[k], along[k]}, {turn.x, turn.y}, out);
        });
    }
}

void PhotonAim::send_from_area(const numbers::SineAndCosine<double>& off, const numbers::SineAndCosine<double>& around,
                               std::vector<Emission>& out) const
{
    const float share = 1.0f / static_cast<float>(light_.size1 * light_.size2);
    const auto place = [](int i, int size) { return size > 1 ? static_cast<double>(i) / (size - 1) - 0.5 : 0.0; };
    for (int i = 0; i < light_.size1; ++i)
        for (int j = 0; j < light_.size2; ++j) {
            const glm::dvec3 origin = light_.location + place(i, light_.size1) * light_.axis1 +
                                      place(j, light_.size2) * light_.axis2;
            const Frame own = frame(origin);
            const Vectors<double> way = turned(aside(own.toward, own.left, off), own.toward, around).of_unit_length();
            send_from(origin, {way.x, way.y, way.z}, share, out);
        }
}

void PhotonAim::send_from(const glm::dvec3& origin, const glm::dvec3& direction, float share,
                          std::vector<Emission>& out) const
{
    constexpr float kDimmest = 1e-5f;
    Emission photon{origin, direction, light_.color * share, 0.0, ring_};
    if (light_.kind == light::Light::Kind::Spot || (light_.kind == light::Light::Kind::Cylinder && parallel_)) {
        light::Light shape = light_;
        shape.color = glm::vec3(1);
        const float dimmed = light::illuminate(shape, origin + photon.direction).color.x;
        if (dimmed < kDimmest) return;
        photon.color *= dimmed;
    }
    if (light_.projector && !pass_projector(photon)) return;
    out.push_back(photon);
}

/// To behind the last crossing with what the light is projected through.
bool PhotonAim::pass_projector(Emission& photon) const
{
    constexpr int kMost = 1000;
    bool met = false;
    for (int i = 0; i < kMost; ++i) {
        const double depth = projected_depth(*light_.projector, {photon.origin, photon.direction});
        if (depth < 0.0) break;
        photon.origin += depth * photon.direction;
        photon.depth += depth;
        met = true;
    }
    return met;
}

}  // namespace trace
