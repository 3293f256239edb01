// What tests of the path tracer have in common: small pictures of many samples.
#pragma once

#include "render/picture/sampling/sampled_render.h"
#include "tests/parser/grammar_support.h"

#include <algorithm>
#include <string>

namespace path_tests {

inline constexpr int kSide = 16;
inline const std::string kHead = "#version 3.7; global_settings { assumed_gamma 1 }\n";
inline const trace::ShownLevel kLinear = [](double light) { return 255.0 * std::clamp(light, 0.0, 1.0); };

struct Paths {
    trace::SampledPicture picture{kSide, kSide};
    trace::RenderStatistics statistics;

    double mean(std::size_t channel = 0) const
    {
        double sum = 0.0;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) sum += picture.at(x, y).mean(channel);
        return sum / (kSide * kSide);
    }
};

inline Paths traced(const std::string& text, std::uint32_t samples, bool paths = true, int threads = 0)
{
    plan::Options options;
    options.width = options.height = kSide;
    options.free_sampling = true;
    options.paths = paths;
    trace::RenderOptions render;
    render.threads = threads;
    trace::SamplingGoal goal;
    goal.samples = samples;
    Paths out;
    out.statistics = trace::render_sampled(plan::compile(parser::parse_text(kHead + text, "t.pov", {}).scene, options),
                                           render, goal, kLinear, out.picture);
    return out;
}

inline const std::string kCamera = "camera { orthographic location -4*z right 2.5*x up 2.5*y direction z }\n";

}  // namespace path_tests
