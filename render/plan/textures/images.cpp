#include "render/plan/textures/images.h"

#include "render/image/levels/transfer_curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plan {
namespace {

using image::TransferCurve;

constexpr int kGammaVersion = 370, kFadesVersion = 380;

bool ends_with_any(const std::string& path, std::initializer_list<const char*> endings)
{
    std::string lower = path;
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::any_of(endings.begin(), endings.end(), [&](const char* ending) { return lower.ends_with(ending); });
}

/// What the file says of itself; nothing if it is silent.
std::optional<TransferCurve> tagged(const image::Picture& picture)
{
    if (picture.srgb) return TransferCurve::srgb();
    if (picture.file_gamma > 0.0f) return TransferCurve::power(picture.file_gamma);
    return std::nullopt;
}

/// From the file's levels to those of the scene (spec 4, 12.4).
image::Transcoder levels_of(const scene::Description& scene, const scene::ImageSource& source, bool colors)
{
    const bool legacy = source.version < kGammaVersion;
    const bool assumed = scene.global.assumed_gamma.has_value();
    if (source.made()) return {};
    if (source.gamma) return {colors ? working_curve(scene) : TransferCurve::linear(), source.gamma->curve()};
    if (!colors || (legacy && !assumed)) return {};
    if (ends_with_any(source.path, {".exr", ".hdr"})) return {working_curve(scene), TransferCurve::linear()};
    const auto tag = ends_with_any(source.path, {".png"}) ? tagged(*source.picture) : std::nullopt;
    if (tag) return {working_curve(scene), *tag};
    if (legacy || ends_with_any(source.path, {".ppm", ".pgm", ".tif", ".tiff", ".iff"})) return {};
    return {working_curve(scene), TransferCurve::srgb()};
}

/// POV-Ray keeps grey PNG levels as integers of 8 bits and cuts them off on the way (spec 4, 12.5).
float cut_grey(float v)
{
    const float grey = (0.297f * v + 0.589f * v) + 0.114f * v;
    return std::trunc(255.0f * grey) / 255.0f;
}

/// What the picture's samples show: a table of its levels where they are fewer than its samples.
void take_samples(const image::Transcoder& transcoder, bool png, texture::Image& out)
{
    const image::Picture& picture = *out.picture;
    const auto channels = static_cast<std::size_t>(picture.channels);
    const bool cut = png && channels == 1 && picture.bits <= 8, bytes = picture.samples.kept.index() == 1,
               floats = picture.samples.kept.index() == 0;
    const auto shown = [&](float v) { return cut ? cut_grey(transcoder.to_working(v)) : transcoder.to_working(v); };
    if (transcoder.keeps() && !cut && !bytes) return;  // a byte's table is faster than a division
    const std::size_t count = floats ? 0 : bytes ? 1u << 8 : 1u << 16;
    if (bytes || (count != 0 && count <= picture.samples.size())) {
        out.levels.resize(count);
        for (std::uint32_t level = 0; level < count; ++level) out.levels[level] = shown(picture.samples.value(level));
        return;
    }
    image::Samples::Floats decoded(picture.samples.size());
    for (std::size_t i = 0; i < decoded.size(); ++i) {
        const bool alpha = (channels == 2 || channels == 4) && i % channels == channels - 1;
        decoded[i] = alpha ? picture.samples[i] : shown(picture.samples[i]);
    }
    out.decoded = {std::move(decoded)};
}

void take_palette(const image::Picture& picture, const image::Transcoder& levels, texture::Image& out)
{
    for (std::size_t i = 0; i + 3 < picture.palette.size(); i += 4) {
        const float* p = &picture.palette[i];
        out.palette.push_back(
            {levels.to_working(p[0]), levels.to_working(p[1]), levels.to_working(p[2]), 0.0f, 1.0f - p[3]});
    }
}

/// Whether POV-Ray keeps an alpha with each texel: of a TIFF always.
bool keeps_alpha(const scene::ImageSource& source)
{
    return source.picture->channels % 2 == 0 || ends_with_any(source.path, {".tif", ".tiff"});
}

/// `filter` and `transmit`: added to texels, the last of both; written over the palette's (spec 4, 12.3). Since 3.8
/// texels fade that have an alpha, the last of both counts, and leaves others alone (spec 7b, 6).
void apply_transparency(const scene::ImageMap& written, bool fades, texture::Image& out)
{
    const bool faded = keeps_alpha(written.source);
    for (const scene::ImageMap::Clarity& clarity : written.clarities) {
        const auto set = [&](scene::Color& color) {
            (clarity.filter ? color.filter : color.transmit) = clarity.amount;
        };
        if (!clarity.place && out.palette.empty() && fades) {
            if (faded) (clarity.filter ? out.faded_filter : out.faded_transmit) = clarity.amount;
        } else if (!clarity.place && out.palette.empty()) {
            if (clarity.filter) out.filter = clarity.amount;
            else out.transmit.assign(1, clarity.amount);
        } else if (!clarity.place) {
            std::for_each(out.palette.begin(), out.palette.end(), set);
        } else if (*clarity.place >= 0 && static_cast<std::size_t>(*clarity.place) < out.palette.size()) {
            set(out.palette[static_cast<std::size_t>(*clarity.place)]);
        }
    }
}

/// Enumerators of the description and of the image stand in the same order.
void take_settings(const scene::ImageMap& written, texture::Image& out)
{
    using Use = scene::ImageMap::Use;
    using Value = texture::Image::Value;
    out.projection = static_cast<texture::Image::Projection>(written.projection);
    out.interpolation = static_cast<texture::Image::Interpolation>(written.interpolation);
    out.once = written.once;
    out.repeat = written.repeat;
    out.offset = written.offset;
    if (written.premultiplied) out.premultiplied = *written.premultiplied;
    out.by_place = written.use == Use::Index && !out.palette.empty();
    if (written.use == Use::Alpha) out.value = out.opaque ? Value::Red : Value::Transmit;
}

}  // namespace

TransferCurve working_curve(const scene::Description& scene)
{
    return scene.global.assumed_gamma ? scene.global.assumed_gamma->curve() : TransferCurve::linear();
}

texture::Image compile_image(const scene::Description& scene, const scene::ImageMap& written, bool colors)
{
    const scene::ImageSource& source = written.source;
    const image::Picture& picture = *source.picture;
    const image::Transcoder levels = levels_of(scene, source, colors);
    texture::Image out;
    out.picture = source.picture;
    out.width = static_cast<std::uint32_t>(picture.width);
    out.height = static_cast<std::uint32_t>(picture.height);
    if (!picture.palette.empty()) take_palette(picture, levels, out);
    else take_samples(levels, ends_with_any(source.path, {".png"}), out);
    const bool asked = colors || written.use == scene::ImageMap::Use::Alpha, clear = asked && image_is_clear(out);
    out.clear_in_file = written.once || clear;
    apply_transparency(written, scene.povray == scene::PovRay::V38 && source.version >= kFadesVersion, out);
    for (const scene::Color& color : out.palette) out.clear_in_file = out.clear_in_file || color.transmit != 0.0f;
    out.opaque = written.clarities.empty() ? !clear : !(asked && image_is_clear(out));
    out.premultiplied = picture.premultiplied;
    take_settings(written, out);
    out.opaque = out.opaque && !out.once && out.projection == texture::Image::Projection::Planar;
    return out;
}

}  // namespace plan
