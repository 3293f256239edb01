#include "render/app/layers/cost_report.h"

#include "render/app/base/text.h"
#include "render/app/run/shell_commands.h"
#include "render/app/run/stage_options.h"
#include "render/study/cost/cost.h"
#include "render/study/cost/heat.h"

#include <fmt/format.h>

#include <filesystem>

namespace app {
namespace {

void write_heat(Run& run, const study::Heat& heat, const std::string& path)
{
    const std::string ending = std::filesystem::path(path).extension().string();
    image::FileSettings file;
    if (same_text(ending, ".exr") || same_text(ending, ".hdr")) {
        file.type = same_text(ending, ".exr") ? image::FileType::OpenExr : image::FileType::RadianceHdr;
        file.encoding.curves = {image::TransferCurve::linear(), image::TransferCurve::linear()};
        run.files.write(path, study::heat_values(heat), file);
    } else {
        run.files.write(path, study::heat_picture(heat), image::FileType::Png, image::TransferCurve::srgb());
    }
    run.reporter.note(fmt::format("heat: {}", path));
}

}  // namespace

void report_cost(Run& run, const scene::Description& description, const plan::CompiledScene& compiled)
{
    const Settings& settings = run.settings;
    if (!settings.explain_cost && settings.heat_file.empty()) return;
    trace::RenderOptions render;
    render.threads = threads_of(settings);
    render.isa = isa_of(settings);
    render.cancel = &run.cancel.requested;
    if (settings.explain_cost) {
        const study::Costs costs = study::measure_costs(description, plan_options(settings), render);
        if (run.cancel.requested) throw AbortedRun();
        fmt::print(stderr, "{}", study::text_of(costs));
    }
    if (settings.heat_file.empty()) return;
    const study::Heat heat = study::measure_heat(compiled, render);
    if (heat.ns.empty() || run.cancel.requested) throw AbortedRun();
    write_heat(run, heat, settings.heat_file);
}

}  // namespace app
