#include "render/scene/textures/image_map.h"

#include <fmt/format.h>

/// Pictures and densities that patterns look into.
namespace scene {

void ImageSource::dump(DumpWriter& out) const
{
    if (made()) {
        out.words(kind, size.x, size.y);
        out.steps("body", function);
    } else {
        out.words(kind, path);
    }
    if (!gamma) return;
    if (gamma->kind == GammaCurve::Kind::Power) out.words("gamma", gamma->exponent);
    else out.line("gamma", fmt::format("\"{}\"", gamma->name()));
}

void ImageMap::dump(DumpWriter& out) const
{
    static constexpr std::string_view kUses[] = {"", "use_index", "use_color", "use_alpha"};
    source.dump(out);
    out.changed("map_type", kProjections[static_cast<std::size_t>(projection)], 0);
    if (once) out.word("once");
    if (bump_size) out.words("bump_size", *bump_size);
    out.changed("interpolate", kInterpolations[static_cast<std::size_t>(interpolation)], 0);
    for (const Clarity& c : clarities) {
        const std::string_view name = c.filter ? "filter" : "transmit";
        if (c.place) out.words(name, *c.place, c.amount);
        else out.words(name, c.amount);
    }
    if (premultiplied) out.words("premultiplied", *premultiplied ? 1 : 0);
    if (use != Use::Usual) out.word(kUses[static_cast<std::size_t>(use)]);
    out.changed("repeat", repeat, glm::dvec2(1.0));
    out.changed("offset", offset, glm::dvec2(0.0));
}

void DensityFile::dump(DumpWriter& out) const
{
    out.words("df3", path);
    out.changed("interpolate", interpolation, 0);
}

}  // namespace scene
