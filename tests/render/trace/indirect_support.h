#pragma once

#include "render/kernel/gather/indirect_light.h"
#include "render/picture/passes/passes.h"
#include "render/picture/render.h"
#include "tests/parser/grammar_support.h"

#include <string>

/// Small pictures of texts with the passes that they ask for.
namespace indirect_test {

struct Made {
    image::Image picture;
    std::shared_ptr<const trace::IndirectLight> light;
};

inline Made made(const std::string& text, int width, int height, int threads = 1, trace::Isa isa = trace::Isa::Auto)
{
    plan::Options options;
    options.width = width;
    options.height = height;
    const plan::CompiledScene scene = plan::compile(grammar_test::parsed("#version 3.7;\n" + text), options);
    trace::RenderOptions render;
    render.threads = threads;
    render.isa = isa;
    Made out;
    out.light = trace::run_passes(scene, render);
    render.indirect = out.light.get();
    trace::render(scene, render, out.picture);
    return out;
}

/// The colour of one pixel without a camera's perspective: what is seen straight down from `eye`.
inline glm::vec3 seen(const std::string& text, const std::string& eye, const std::string& direction, int threads = 1)
{
    const Made one =
        made("camera { orthographic location " + eye + " direction " + direction + " right x*1e-6 up z*1e-6 }\n" + text,
             1, 1, threads);
    const float* pixel = one.picture.at(0, 0);
    return {pixel[0], pixel[1], pixel[2]};
}

}  // namespace indirect_test
