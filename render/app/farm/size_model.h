#pragma once

#include <vector>

namespace app {

/// What one small render of a frame took: processor seconds and counts.
struct SizedCost {
    double pixels = 0.0;
    double reading = 0.0;       ///< scene and plan
    double passes = 0.0;        ///< photons, radiosity
    double picture = 0.0;       ///< tracing without those
    double supersamples = 0.0;  ///< rays of antialiasing
    double writing = 0.0;
    double rest = 0.0;    ///< to start
    double memory = 0.0;  ///< bytes at most
};

/// Seconds and bytes of a frame in a picture of another size.
struct FrameCost {
    double reading = 0.0, passes = 0.0, picture = 0.0;  ///< processor seconds
    double memory = 0.0;                                ///< bytes
    double seconds() const { return reading + passes + picture; }
};

/// How the costs of a frame grow with its pixels, told by two or more sizes of it. Antialiasing goes where there are
/// edges, so that its share falls in larger pictures; photons cost the same in all.
class SizeModel {
public:
    /// \param costs of one frame, smallest size first; at least one
    explicit SizeModel(const std::vector<SizedCost>& costs);
    /// Of a frame of which one size was measured.
    FrameCost at(double pixels, const SizedCost& measured) const;
    /// How far the largest measured size is from what the smaller ones say of it; 0 where there is none smaller.
    double error() const { return error_; }

private:
    double passes_growth_ = 1.0, edges_growth_ = 1.0;  ///< exponents of pixels
    double sample_weight_ = 1.0;                       ///< what a ray of antialiasing costs, in pixels without it
    double error_ = 0.0;
};

}  // namespace app
