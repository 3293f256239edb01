#pragma once

#include "render/texture/texture_set.h"
#include "render/kernel/camera/camera_rays.h"

#include <array>
#include <vector>

namespace trace {

/// Focal blur: rays from places on a lens through each sample's place on the focal plane, until the mean is certain
/// (reference manual 3.4.1.8; spec 2, section 7).
class FocalBlur {
public:
    /// Red, green, blue and transmit of the samples so far; transmit for the variance holds samples without a ray too.
    struct Sums {
        int count = 0;
        std::array<float, 4> sum{}, squares{};
        float filter = 0, shown_transmit = 0;
        void add(const scene::Color& c, bool has_ray);
        scene::Color mean() const;
    };

    /// bokeh: a pigment of the set whose brightness over the unit square says where on the lens rays start; kNone: a
    /// round lens.
    FocalBlur(const scene::Camera& camera, const texture::TextureSet& set, std::uint32_t bokeh);

    bool active() const { return samples_ > 0; }
    int most_samples() const { return samples_; }
    /// How many samples come next when `taken` are there; 0: that was the last.
    int batch(int taken) const;
    bool converged(const Sums& sums) const;
    /// Sample n of a position; false: it has no ray, though it starts somewhere.
    bool ray(const CameraRays& rays, const glm::dvec2& position, int n, csg::Ray& out) const;

    /// Samples that wait to become a tile of rays: number n of the position (x, y). What lies behind them is from
    /// before.
    struct Waiting {
        alignas(64) std::array<double, csg::kTileRays> x{}, y{};
        std::array<int, csg::kTileRays> n{};
        int count = 0;
    };
    /// Their rays in vector lanes, the same bits as from ray(). False if one has none, or the camera is no perspective
    /// one.
    bool rays(const CameraRays& rays, const Waiting& samples, csg::RayTile& out) const;

private:
    void place_further_samples();
    void place_by_brightness(const texture::TextureSet& set, std::uint32_t bokeh);

    int samples_ = 0, fewest_ = 0, set_ = 0;
    double radius_ = 0, amplitude_ = 0, focal_ratio_ = 1;
    double row_ = -0.5;  ///< how far below a sample the jitter upon the lens is asked, in pixels (spec 7d, 6)
    glm::dvec3 location_{0}, right_{0}, up_{0};
    std::vector<glm::dvec2> places_;
    std::vector<glm::dvec2> moves_;   ///< by which way jitter moves each of 16 x 16 places within a pixel
    std::vector<double> thresholds_;  ///< by the number of samples
};

}  // namespace trace
