#pragma once

#include "numbers/functions/functions.h"
#include "render/light/light_set.h"
#include "render/plan/photons.h"
#include "render/kernel/gather/random_tables.h"
#include "render/kernel/photon/emission.h"

#include <cstdint>
#include <vector>

/// How photons leave a light for a target (spec 6, 3.4).
namespace trace {

/// One light and one target.
class PhotonAim {
public:
    /// spacing: between photons at the target, scene units, before its density.
    PhotonAim(const light::Light& light, const plan::PhotonLight& flags, const plan::PhotonTarget& target,
              double spacing, const scene::PhotonSettings& settings);

    const light::Light& light() const { return light_; }
    /// False where the light stands in the middle of the target: there is no way to it (POV-Ray divides by 0).
    bool has_way() const { return parallel_ || distance_ > kNoWay; }
    bool parallel() const { return parallel_; }
    /// Distance between photons at one unit from the light; of a parallel light everywhere.
    double step() const { return step_; }
    /// About how many photons it sends if nothing stops it.
    double estimate() const;

    /// The next ring's photons are appended. False: there is none.
    bool ring(JitterStream& jitter, std::vector<Emission>& out);
    /// The angle of the ring that was made last, as a share of the last there may be.
    double reach() const { return (theta_ - dtheta_) / theta_end_; }

private:
    static constexpr double kNoWay = 1e-10;  ///< from light to target, scene units
    /// The space of a cone around the way to the target.
    struct Frame {
        glm::dvec3 toward, left;
    };
    Frame frame(const glm::dvec3& from) const;
    /// The photons of the angles in off_ and around_.
    void send_ring(std::vector<Emission>& out);
    /// One from each lamp of the area. off, around: the angles from the way to the target and about it.
    void send_from_area(const numbers::SineAndCosine<double>& off, const numbers::SineAndCosine<double>& around,
                        std::vector<Emission>& out) const;
    /// direction: unit.
    void send_from(const glm::dvec3& origin, const glm::dvec3& direction, float share,
                   std::vector<Emission>& out) const;
    bool pass_projector(Emission& photon) const;

    light::Light light_;  ///< without fading
    const plan::PhotonTarget& target_;
    bool parallel_, area_;
    double jitter_;
    Frame frame_;
    double distance_ = 0, step_ = 0, dtheta_ = 0, theta_ = 0, theta_end_ = 0;
    std::uint32_t ring_ = 0;
    std::vector<double> off_, around_;  ///< angles of a ring's photons, radians; from parallel light off_ is a distance
};

}  // namespace trace
