#pragma once

#include "render/plan/compiled_scene.h"
#include "render/picture/render.h"

#include <string>
#include <vector>

namespace study {

/// What one part of a scene costs: the time with it less the time without it, or what it would cost.
struct Cost {
    enum class Kind { Statement, Light, Texture, LeftOut } kind;
    std::string what;
    double ns;  ///< a ray of the camera; below 0: without it the picture takes longer
};

struct Costs {
    double ns = 0.0;            ///< all of the picture: processor time a ray of the camera
    double noise = 0.0;         ///< how far two measurements of the same are apart, ns
    double rays = 0.0;          ///< of all kinds, a ray of the camera
    std::size_t sampled = 0;    ///< rays of the camera
    std::vector<Cost> costs;    ///< by kind, the most costly first; those below the noise are left out
    std::size_t too_small = 0;  ///< parts that were measured and lie below the noise
};

/// A sampled run: tiles scattered over the picture, with each part in turn and without it. Statements are left out of
/// the description by halves, and only halves that cost something are looked into. One thread.
Costs measure_costs(const scene::Description& scene, const plan::Options& options, const trace::RenderOptions& render);

/// For --explain=cost, a line each.
std::string text_of(const Costs& costs);

}  // namespace study
