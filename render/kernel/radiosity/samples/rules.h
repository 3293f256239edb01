#pragma once

#include "numbers/functions/functions.h"
#include "render/scene/effects.h"

#include <algorithm>
#include <cmath>

namespace trace::radiosity {

/// What holds for samples of one bounce: 0 for points that the camera sees (spec 6, 4.1).
struct BounceRules {
    int rays = 35;        ///< of a sample
    double required = 5;  ///< quarters of weight that make a lookup good enough
    double error_factor = 1;
    double least_reach = 0, most_reach = 0;  ///< of a sample, as shares of its distance from the camera
    float weight = 1;                        ///< that rays of a sample begin with
    int level = 1;                           ///< trace levels that count as used for them
    double ball = 1;                         ///< a sample is filed for so many times its reach

    static BounceRules of(const scene::RadiositySettings& settings, int bounce)
    {
        constexpr int kFewest = 5;
        constexpr double kShare = 1e-10;  // above adc_bailout
        const double doubled = std::ldexp(1.0, bounce);
        BounceRules rules;
        rules.rays = std::min(std::max(kFewest, bounce < 31 ? settings.count >> bounce : 0), settings.pool_size());
        rules.required = bounce == 0 ? settings.nearest_count : bounce == 1 ? std::min(2, settings.nearest_count) : 1;
        rules.error_factor = doubled;
        rules.least_reach = settings.minimum_reuse * doubled;
        rules.most_reach = settings.maximum_reuse * doubled;
        rules.weight = static_cast<float>(
            std::max(numbers::pow(0.5 * settings.brightness, bounce + 1), settings.adc_bailout + kShare));
        rules.level = static_cast<int>(1.5 * (bounce + 1));
        rules.ball = settings.error_bound * doubled / (bounce == 0 ? 1.0 : 8.0);
        return rules;
    }
};

}  // namespace trace::radiosity
