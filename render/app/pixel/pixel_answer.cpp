#include "render/app/pixel/pixel_answer.h"

#include "render/app/run/run.h"
#include "render/app/run/stage_options.h"
#include "render/explain/pixel.h"

namespace app {

PixelAnswer pixel_answer(const Settings& settings, const scene::Description& description, int x, int y,
                         const std::atomic<bool>& cancel)
{
    plan::CompiledScene compiled = plan::compile(description, plan_options(settings));
    trace::RenderOptions options;
    options.threads = threads_of(settings);
    options.isa = isa_of(settings);
    options.cancel = &cancel;
    const explain::Pixel pixel = explain::explain_pixel(compiled, options, x, y);
    const image::OutputCurves curves = file_settings(settings, description).encoding.curves;
    const image::Transcoder transcode(curves.working, curves.file);
    PixelAnswer out;
    for (int c = 0; c < 3; ++c) out.shown[c] = image::quantised(transcode.to_file(pixel.rendered[c]), 8);
    out.text = explain::pixel_text(pixel, description, compiled, out.shown);
    return out;
}

}  // namespace app
