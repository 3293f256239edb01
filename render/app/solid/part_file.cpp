#include "render/app/solid/part_file.h"

#include "render/app/report/json_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace app {

bool color_of(const scene::Object& object, std::array<double, 3>& out)
{
    if (object.texture != nullptr)
        if (const auto* layers = std::get_if<std::vector<scene::Layer>>(&object.texture->kind))
            for (const scene::Layer& layer : *layers)
                if (const auto* color = std::get_if<scene::Color>(&layer.pigment.kind)) {
                    for (std::size_t k = 0; k < 3; ++k) {
                        const double v = std::clamp(static_cast<double>(color->rgb()[static_cast<int>(k)]), 0.0, 1.0);
                        out[k] = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
                    }
                    return true;
                }
    if (const auto* csg = std::get_if<scene::Csg>(&object.shape))
        for (const scene::Object& operand : *csg->operands)
            if (color_of(operand, out)) return true;
    return false;
}

solid::RefineOptions refine_options(double tolerance, int cells, PartClock::time_point start, double seconds,
                                    const Cancellation& cancel)
{
    solid::RefineOptions out;
    out.tolerance = tolerance;
    out.cells = cells;
    out.cancel = &cancel.requested;
    out.deadline = start + std::chrono::duration_cast<PartClock::duration>(std::chrono::duration<double>(seconds));
    return out;
}

void tell_too_far(const std::string& part, const char* what, double worst, double tolerance,
                  const solid::RefineFacts& facts)
{
    fmt::print(stderr, "{}: warning: {} is off by {:.3g} somewhere, more than {:g}{}\n", part, what, worst, tolerance,
               facts.full   ? ": there was no room for finer triangles"
               : facts.late ? ": there was no time for finer triangles (--seconds)"
                            : "");
}

}  // namespace app
