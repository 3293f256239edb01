#include "render/picture/passes/photon_aim.h"

#include "numbers/functions/functions.h"
#include "render/kernel/context/projected.h"
#include "render/light/illuminate.h"

#include <cmath>
#include <numbers>

namespace trace {
namespace {

constexpr double kPi = std::numbers::pi, kCenter = 1e-10;

/// v turned about a unit axis, right-handed.
glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double angle)
{
    const auto [s, c] = numbers::sine_and_cosine(angle);
    return c * v + s * glm::cross(axis, v) + (1.0 - c) * glm::dot(axis, v) * axis;
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
    for (double phi = start; phi < end; phi += dphi) {
        const double around = phi + dphi * (jitter.draw() - 0.5) * jitter_;
        const double off = theta_ + dtheta_ * (jitter.draw() - 0.5) * jitter_;
        send(off, around, out);
    }
    theta_ += dtheta_;
    ++ring_;
    return true;
}

void PhotonAim::send(double theta, double phi, std::vector<Emission>& out) const
{
    if (parallel_) {
        const glm::dvec3& l = light_.axis;
        const glm::dvec3 foot = target_.center - l * glm::dot(l, frame_.toward) * distance_;
        return send_from(foot + turned(frame_.left * theta, l, phi), l, 1.0f, out);
    }
    const auto [across, along] = numbers::sine_and_cosine(theta);
    const auto from = [&, across = across, along = along](const Frame& frame, const glm::dvec3& origin, float share) {
        const glm::dvec3 off = along * frame.toward - across * frame.left;
        send_from(origin, turned(off, frame.toward, phi), share, out);
    };
    if (!area_) return from(frame_, light_.location, 1.0f);
    const float share = 1.0f / static_cast<float>(light_.size1 * light_.size2);
    const auto place = [](int i, int size) { return size > 1 ? static_cast<double>(i) / (size - 1) - 0.5 : 0.0; };
    for (int i = 0; i < light_.size1; ++i)
        for (int j = 0; j < light_.size2; ++j) {
            const glm::dvec3 origin = light_.location + place(i, light_.size1) * light_.axis1 +
                                      place(j, light_.size2) * light_.axis2;
            from(frame(origin), origin, share);
        }
}

void PhotonAim::send_from(const glm::dvec3& origin, const glm::dvec3& direction, float share,
                          std::vector<Emission>& out) const
{
    constexpr float kDimmest = 1e-5f;
    Emission photon{origin, glm::normalize(direction), light_.color * share, 0.0, ring_};
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
