#pragma once

#include "render/image/levels/transfer_curve.h"
#include "render/study/ladder.h"
#include "render/picture/render.h"

#include <optional>

namespace study {

/// A picture as its file holds it: three values from 0 to 1 a pixel, not rounded.
struct Shown {
    int width = 0, height = 0;
    std::vector<float> values;
};

/// How far a picture is from the truth.
struct Error {
    double linear = 0.0;  ///< root mean square over pixels and colours of linear light, white being 1
    double levels = 0.0;  ///< the same of shown levels, 0 to 255
    double beyond = 0.0;  ///< share of the pixels with a colour more than 3 of 255 off
    double flip = 0.0;    ///< mean FLIP (image/compare/flip.h)
};

/// \param file the curve that the values are stored by
Error error_of(const Shown& truth, const Shown& picture, const image::TransferCurve& file);

/// A rung that was rendered.
struct Result {
    std::string family, name;
    bool povray = false;   ///< by the real POV-Ray
    double seconds = 0.0;  ///< of all passes and the trace, wall clock; the least of the runs
    Error error;
    double asked_error = 0.0;    ///< levels that the setting promised; 0: none
    double asked_seconds = 0.0;  ///< that it was to take; 0: none
    std::uint64_t rays = 0;      ///< camera, shadow, reflected and refracted; 0: not told
    Shown picture;
};

/// What a scene was measured against.
struct Truth {
    Shown picture;
    double expected_error = 0.0;  ///< of its own, levels
    double samples = 0.0;         ///< of a pixel, on average
    double seconds = 0.0;
};

/// Renders settings of one scene and measures them against its truth.
class Study {
public:
    /// \param options  size of the picture and quality; where they are for paths, the truth is of paths, and paths are
    ///        measured beside the rest
    /// \param curves  from light to stored values
    Study(const scene::Description& scene, const plan::Options& options, const trace::RenderOptions& render,
          const image::OutputCurves& curves);

    /// The truth, with samples until the error is expected to be `error` levels or the time is over. Before all else.
    const Truth& find_truth(double error, double seconds);
    const Truth& truth() const { return truth_; }
    /// The rungs of this scene.
    const std::vector<Setting>& settings() const { return settings_; }
    /// Nothing: cancelled. What is done in less than a fifth of a second is done again, up to five times.
    std::optional<Result> run(const Setting& setting) const;
    /// A picture that another program made of it.
    Error error(const Shown& picture) const { return error_of(truth_.picture, picture, curves_.file); }

private:
    struct Rendered {
        Shown picture;
        trace::RenderStatistics statistics;
        double seconds;
    };
    Rendered render(const Trial& trial) const;
    trace::ShownLevel level() const;

    const scene::Description& scene_;
    plan::Options options_;
    bool paths_;
    trace::RenderOptions render_;
    image::OutputCurves curves_;
    image::Transcoder transcoder_;
    std::vector<Setting> settings_;
    Truth truth_;
};

/// The results that no other beats in both, seconds and error, fastest first; of Whittle alone, or of POV-Ray.
std::vector<const Result*> pareto_front(const std::vector<Result>& results, bool povray = false);

/// The fastest of Whittle, or of POV-Ray, with at most so many levels of error; null: none has.
const Result* cheapest(const std::vector<Result>& results, double levels, bool povray = false);

}  // namespace study
