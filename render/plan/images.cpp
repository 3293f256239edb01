#include "render/plan/images.h"

#include "render/image/transfer_curve.h"
#include "render/scene/picture_gamma.h"

#include <algorithm>
#include <cmath>

namespace plan {
namespace {

using image::TransferCurve;

constexpr int kGammaVersion = 370;

bool ends_with_any(const std::string& path, std::initializer_list<const char*> endings)
{
    std::string lower = path;
    std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::any_of(endings.begin(), endings.end(), [&](const char* ending) { return lower.ends_with(ending); });
}

TransferCurve working_curve(const scene::Description& scene)
{
    const scene::AssumedGamma& gamma = scene.global.assumed_gamma;
    if (gamma.kind == scene::AssumedGamma::Kind::Srgb) return TransferCurve::srgb();
    return gamma.kind == scene::AssumedGamma::Kind::Power ? TransferCurve::power(static_cast<float>(gamma.exponent)) : TransferCurve::linear();
}

/// What the file says of itself; nothing if it is silent.
std::optional<TransferCurve> tagged(const image::Picture& picture)
{
    if (picture.srgb) return TransferCurve::srgb();
    if (picture.file_gamma > 0.0f) return TransferCurve::power(picture.file_gamma);
    return std::nullopt;
}

/// From the file's levels to those of the scene (spec 4, 12.4).
image::Transcoder levels_of(const scene::Description& scene, const scene::Statement& statement, const image::Picture& picture, bool colors)
{
    const auto gamma = scene::written_gamma(statement);
    const bool legacy = scene.effective_version < kGammaVersion;
    const bool assumed = scene.global.assumed_gamma.kind != scene::AssumedGamma::Kind::Unset;
    const std::string* path = std::get_if<std::string>(&statement.items.front().operands[0]);
    if (path == nullptr) return {};
    if (gamma) return {colors ? working_curve(scene) : TransferCurve::linear(), *gamma};
    if (!colors || (legacy && !assumed)) return {};
    if (ends_with_any(*path, {".exr", ".hdr"})) return {working_curve(scene), TransferCurve::linear()};
    const auto tag = ends_with_any(*path, {".png"}) ? tagged(picture) : std::nullopt;
    if (tag) return {working_curve(scene), *tag};
    if (legacy || ends_with_any(*path, {".ppm", ".pgm", ".tif", ".tiff", ".iff"})) return {};
    return {working_curve(scene), TransferCurve::srgb()};
}

/// POV-Ray keeps grey PNG levels as integers of 8 bits and cuts them off on the way (spec 4, 12.5).
float cut_grey(float v)
{
    const float grey = (0.297f * v + 0.589f * v) + 0.114f * v;
    return std::trunc(255.0f * grey) / 255.0f;
}

void take_texels(const image::Picture& picture, const image::Transcoder& levels, bool png, texture::Image& out)
{
    const auto channels = static_cast<std::size_t>(picture.channels);
    const bool grey = channels < 3, alpha = channels == 2 || channels == 4, cut = png && channels == 1 && picture.bits <= 8;
    out.texels.reserve(picture.count());
    for (std::size_t i = 0; i < picture.count(); ++i) {
        const float* p = &picture.samples[i * channels];
        glm::vec4 texel{levels.to_working(p[0]), 0, 0, alpha ? 1.0f - p[channels - 1] : 0.0f};
        if (cut) texel.x = cut_grey(texel.x);
        texel.y = grey ? texel.x : levels.to_working(p[1]);
        texel.z = grey ? texel.x : levels.to_working(p[2]);
        out.texels.push_back(texel);
    }
}

void take_palette(const image::Picture& picture, const image::Transcoder& levels, texture::Image& out)
{
    out.places = picture.indices;
    for (std::size_t i = 0; i + 3 < picture.palette.size(); i += 4) {
        const float* p = &picture.palette[i];
        out.palette.push_back({levels.to_working(p[0]), levels.to_working(p[1]), levels.to_working(p[2]), 0.0f, 1.0f - p[3]});
    }
}

/// `filter` and `transmit`: added to texels, written over the palette's (spec 4, 12.3).
void take_clarity(const scene::Statement& statement, texture::Image& out)
{
    for (const scene::StatementItem& item : statement.items) {
        const bool filter = item.name == "filter";
        if (!filter && item.name != "transmit") continue;
        const auto value = static_cast<float>(number_of(item.operands.back()));
        const auto set = [&](scene::Color& color) { (filter ? color.filter : color.transmit) = value; };
        if (item.operands.size() == 1 && out.palette.empty()) {
            if (filter) out.filter += value;
            for (glm::vec4& texel : out.texels) texel.w += filter ? 0.0f : value;
        } else if (item.operands.size() == 1) {
            std::for_each(out.palette.begin(), out.palette.end(), set);
        } else {
            const double place = std::trunc(number_of(item.operands[0]) + 0.01);
            if (place >= 0.0 && place < static_cast<double>(out.palette.size())) set(out.palette[static_cast<std::size_t>(place)]);
        }
    }
}

void take_settings(const scene::Statement& statement, texture::Image& out)
{
    using Projection = texture::Image::Projection;
    using Interpolation = texture::Image::Interpolation;
    const auto number = [&](const char* name) { return item_of(statement, name) ? static_cast<int>(number_of(item_of(statement, name)->operands[0])) : 0; };
    switch (number("map_type")) {
    case 1: out.projection = Projection::Spherical; break;
    case 2: out.projection = Projection::Cylindrical; break;
    case 5: out.projection = Projection::Torus; break;
    default: break;
    }
    switch (number("interpolate")) {
    case 2: out.interpolation = Interpolation::Bilinear; break;
    case 3: out.interpolation = Interpolation::Bicubic; break;
    case 4: out.interpolation = Interpolation::NormalizedDistance; break;
    default: break;
    }
    out.once = item_of(statement, "once") != nullptr;
    for (const scene::StatementItem& item : statement.items)
        if (item.name == "premultiplied") out.premultiplied = number_of(item.operands[0]) != 0.0;
    const auto pair = [&](const char* name, glm::dvec2& to) {
        if (const scene::StatementItem* item = item_of(statement, name)) to = std::get<glm::dvec2>(item->operands[0]);
    };
    pair("repeat", out.repeat);
    pair("offset", out.offset);
    for (const scene::StatementItem& item : statement.items) {  // the last of them counts
        if (item.name == "use_index") out.by_place = !out.palette.empty();
        if (item.name == "use_color" || item.name == "use_alpha") out.by_place = false;
        if (item.name == "use_alpha") out.value = out.opaque ? texture::Image::Value::Red : texture::Image::Value::Transmit;
        if (item.name == "use_color" || item.name == "use_index") out.value = texture::Image::Value::Grey;
    }
}

bool lets_light_through(const texture::Image& image)
{
    const auto clear = [](const scene::Color& c) { return c.filter != 0.0f || c.transmit != 0.0f; };
    return image.filter != 0.0f || std::any_of(image.palette.begin(), image.palette.end(), clear) ||
           std::any_of(image.texels.begin(), image.texels.end(), [](const glm::vec4& t) { return t.w != 0.0f; });
}

}  // namespace

texture::Image compile_image(const scene::Description& scene, const scene::Statement& statement, bool colors)
{
    const scene::StatementItem& source = statement.items.front();
    const image::Picture& picture = *std::get<std::shared_ptr<const image::Picture>>(source.operands.back());
    const image::Transcoder levels = levels_of(scene, statement, picture, colors);
    texture::Image out;
    out.width = static_cast<std::uint32_t>(picture.width);
    out.height = static_cast<std::uint32_t>(picture.height);
    const std::string* path = std::get_if<std::string>(&source.operands[0]);
    if (!picture.palette.empty()) take_palette(picture, levels, out);
    else take_texels(picture, levels, path != nullptr && ends_with_any(*path, {".png"}), out);
    take_clarity(statement, out);
    out.opaque = !lets_light_through(out);
    // EXR stores colours times alpha. A TIFF's straight colours are multiplied and divided again by POV-Ray: left alone.
    const bool tiff = path != nullptr && ends_with_any(*path, {".tif", ".tiff"});
    out.premultiplied = path != nullptr && ends_with_any(*path, {".exr"});
    take_settings(statement, out);
    out.premultiplied = out.premultiplied && !tiff;
    out.opaque = out.opaque && !out.once && out.projection == texture::Image::Projection::Planar;
    return out;
}

}  // namespace plan
