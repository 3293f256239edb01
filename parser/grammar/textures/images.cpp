#include "parser/grammar/textures/density_file.h"
#include "parser/grammar/core/function_samples.h"
#include "parser/grammar/textures/images.h"
#include "parser/stream/functions/function.h"
#include "render/image/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

/// Blocks that name a picture or a volume; its content is read with them.
namespace parser {
namespace {

struct ImageKind {
    Kind keyword;
    std::vector<std::string> extensions;
};

const std::vector<ImageKind>& image_kinds()
{
    static const std::vector<ImageKind> kinds = {{Kind::Gif, {".gif", ".GIF"}},
                                                 {Kind::Tga, {".tga", ".TGA"}},
                                                 {Kind::Png, {".png", ".PNG"}},
                                                 {Kind::Ppm, {".ppm", ".PPM"}},
                                                 {Kind::Pgm, {".pgm", ".PGM"}},
                                                 {Kind::Jpeg, {".jpg", ".JPG", ".jpeg", ".JPEG"}},
                                                 {Kind::Tiff, {".tif", ".TIF", ".tiff", ".TIFF"}},
                                                 {Kind::Iff, {".iff", ".IFF"}},
                                                 {Kind::Exr, {".exr", ".EXR"}},
                                                 {Kind::Hdr, {".hdr", ".HDR"}},
                                                 {Kind::Bmp, {".bmp", ".BMP"}},
                                                 {Kind::Sys, {".bmp", ".BMP"}},
                                                 {Kind::Pot, {".pot", ".POT"}}};
    return kinds;
}

bool has_image_extension(const std::string& name)
{
    for (const ImageKind& kind : image_kinds())
        for (const std::string& extension : kind.extensions)
            if (name.ends_with(extension)) return true;
    return false;
}

/// The file of an image's statement; it must exist.
std::string read_file_name(BlockReader& s, const std::vector<std::string>& extensions)
{
    const scene::SourceRef at = s.in().here();
    const std::string name = path_expr(s.in());
    if (extensions.empty() && !has_image_extension(name))
        s.in().fail(at, fmt::format("the kind of the image '{}' cannot be told from its name", name));
    std::string path = s.in().find_file(name, extensions);
    if (path.empty()) s.in().fail(at, fmt::format("cannot find the image file '{}'", name));
    s.in().data_files().push_back(path);
    return path;
}

constexpr double kMostTexels = 1 << 28;

/// A function's values as a picture of 16 bits.
std::shared_ptr<const image::Picture> picture_of(BlockReader& s, const scene::ImageSource& source)
{
    const double columns = std::trunc(source.size.x + 0.5), rows = std::trunc(source.size.y + 0.5);
    if (!(columns >= 1.0 && rows >= 1.0 && columns * rows <= kMostTexels))
        s.fail("a picture made by a function has at least 1 and at most 2^28 pixels");
    const function::FunctionPtr& called = source.function;
    auto picture = std::make_shared<image::Picture>();
    picture->width = static_cast<int>(columns);
    picture->height = static_cast<int>(rows);
    picture->bits = 16;
    picture->channels = static_cast<int>(sampled_channels(*called));
    const auto levels =
        sampled_levels(s.build(), called, static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows));
    picture->samples.resize(
        picture->count() *
        sampled_channels(*called));  // stays 0 where the function asks what is not drawn yet; that was told
    if (levels)
        std::transform(levels->begin(), levels->end(), picture->samples.begin(),
                       [](std::uint16_t level) { return static_cast<float>(level) / 65535.0f; });
    return picture;
}

/// The source of a pattern's picture, its content included.
scene::ImageSource read_picture(BlockReader& s)
{
    // Up to version 2 an image was laid out along the axes of a vector, as in image_map { <1, -1, 0> gif "a.gif" }; it
    // is without effect (spec 4, 12.10).
    if (at_expression(s.in()) && !at_string(s.in())) vector_expr(s.in());
    scene::ImageSource source = read_image_source(s);
    source.picture = source.made() ? picture_of(s, source) : s.build().picture(source.path, s.in().last());
    return source;
}

std::shared_ptr<const scene::Volume> volume_of(BlockReader& s, const std::string& path, const scene::SourceRef& at)
{
    std::ifstream file(path, std::ios::binary);
    auto volume = decode_density_file({std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()});
    if (!volume) s.in().fail(at, fmt::format("'{}' is no density file: its length does not fit its sizes", path));
    return volume;
}

/// Sets an enumerator by its number in the language; false: it has none.
template <class Enum, std::size_t count>
bool set_by_number(Enum& to, const int (&numbers)[count], int number)
{
    const auto found = std::find(std::begin(numbers), std::end(numbers), number);
    if (found == std::end(numbers)) return false;
    to = static_cast<Enum>(found - std::begin(numbers));
    return true;
}

/// map_type and interpolate, and whether an image_map takes what was written; the other users do not mind (spec
/// 4, 12.1).
struct MappingReader {
    scene::ImageMap& image;
    bool projection_fits = true, interpolation_fits = true;

    bool read(BlockReader& s)
    {
        if (s.accept(Kind::MapType)) {
            projection_fits =
                set_by_number(image.projection, scene::ImageMap::kProjections, whole_number(float_expr(s.in()))) &&
                projection_fits;
        } else if (s.accept(Kind::Interpolate)) {
            const int number = whole_number(float_expr(s.in()));
            interpolation_fits = set_by_number(image.interpolation, scene::ImageMap::kInterpolations, number) &&
                                 number != 0 && interpolation_fits;
        } else {
            return false;
        }
        return true;
    }
    void check(BlockReader& s) const
    {
        if (!projection_fits) s.fail("map_type of an image_map is 0, 1, 2 or 5");
        if (!interpolation_fits) s.fail("interpolate of an image_map is 2, 3 or 4");
    }
};

bool read_use(BlockReader& s, scene::ImageMap& image, bool alpha)
{
    using Use = scene::ImageMap::Use;
    if (s.accept(Kind::UseIndex)) image.use = Use::Index;
    else if (s.accept(Kind::UseColor)) image.use = Use::Color;
    else if (alpha && s.accept(Kind::UseAlpha)) image.use = Use::Alpha;
    else return false;
    return true;
}

/// filter and transmit, of all pixels or of a place in the palette.
bool read_clarity(BlockReader& s, scene::ImageMap& image)
{
    scene::ImageMap::Clarity clarity;
    if (s.accept(Kind::Filter)) clarity.filter = true;
    else if (!s.accept(Kind::Transmit)) return false;
    if (!s.accept(Kind::All)) {
        if (image.source.made()) s.fail("a picture made by a function has no palette: 'all' is missing");
        constexpr double kSlack = 0.01;  // POV-Ray's, before it cuts off
        clarity.place = whole_number(float_expr(s.in()) + kSlack);
        s.in().accept_comma();
    }
    clarity.amount = static_cast<float>(float_expr(s.in()));
    image.clarities.push_back(clarity);
    return true;
}

constexpr auto kPlacement = std::tuple(word(Kind::Once, &scene::ImageMap::once),
                                       field(Kind::Repeat, &scene::ImageMap::repeat),
                                       field(Kind::Offset, &scene::ImageMap::offset));
constexpr auto kSettings = std::tuple(field(Kind::Premultiplied, &scene::ImageMap::premultiplied),
                                      field(Kind::BumpSize, &scene::ImageMap::bump_size));

}  // namespace

std::shared_ptr<const image::Picture> SceneBuilder::picture(const std::string& path, const scene::SourceRef& at)
{
    auto& known = pictures_[path];
    try {
        if (!known) known = std::make_shared<const image::Picture>(image::Files().read(path));
    } catch (const image::FileError& error) {
        stream().fail(at, error.what());
    }
    return known;
}

scene::ImageSource read_image_source(BlockReader& s)
{
    scene::ImageSource source;
    for (const ImageKind& kind : image_kinds()) {
        if (!s.accept(kind.keyword)) continue;
        source.kind = spelling(kind.keyword);
        source.path = read_file_name(s, kind.extensions);
        return source;
    }
    if (s.accept(Kind::Function)) {
        source.kind = spelling(Kind::Function);
        read_values(s.in(), source.size.x, source.size.y);
        s.in().expect(Kind::LeftBrace, "'{' and the function's body");
        source.function = read_function_body(s.in(), {});
    } else if (at_string(s.in())) {
        source.kind = "file";
        source.path = read_file_name(s, {});
    } else {
        s.in().fail_expected("an image: its kind and its file's name, or 'function'");
    }
    return source;
}

bool read_gamma(BlockReader& s, std::optional<scene::FileGamma>& gamma)
{
    if (!s.accept(Kind::Gamma)) return false;
    gamma.emplace();
    gamma->srgb = s.accept(Kind::Srgb);
    if (!gamma->srgb) gamma->exponent = float_expr(s.in());
    return true;
}

std::shared_ptr<const scene::ImageMap> read_image_block(SceneBuilder& build, bool colors)
{
    const auto guard = build.stream().nest();
    BlockReader s(build);
    auto image = std::make_shared<scene::ImageMap>();
    image->at = s.source();
    MappingReader mapping{*image};
    s.open();
    image->source = read_picture(s);
    while (read_gamma(s, image->source.gamma) || (colors && read_clarity(s, *image)) || mapping.read(s) ||
           read_use(s, *image, true) || read_one(s, *image, kPlacement) || read_one(s, *image, kSettings)) {}
    s.close();
    if (colors) mapping.check(s);
    return image;
}

std::shared_ptr<const scene::ImageMap> read_material_map(SceneBuilder& build, TextureMap& materials)
{
    const auto guard = build.stream().nest();
    BlockReader s(build);
    auto image = std::make_shared<scene::ImageMap>();
    image->at = s.source();
    MappingReader mapping{*image};
    s.open();
    image->source = read_picture(s);
    while (read_gamma(s, image->source.gamma) || mapping.read(s) || read_use(s, *image, false) ||
           read_one(s, *image, kPlacement)) {}
    if (s.next_kind() != Kind::Texture) s.in().fail_expected("'texture' and the material of the first colour");
    while (s.accept(Kind::Texture)) materials.push_back({static_cast<double>(materials.size()), read_texture(build)});
    s.close();
    return image;
}

std::shared_ptr<const scene::DensityFile> read_density_file(SceneBuilder& build)
{
    BlockReader s(build);
    auto density = std::make_shared<scene::DensityFile>();
    density->at = s.source();
    s.in().expect(Kind::Df3, "'df3' and the file's name");
    const scene::SourceRef at = s.in().here();
    const std::string name = path_expr(s.in());
    density->path = s.in().find_file(name, {".df3", ".DF3"});
    if (density->path.empty()) s.in().fail(at, fmt::format("cannot find the density file '{}'", name));
    s.in().data_files().push_back(density->path);
    density->volume = volume_of(s, density->path, at);
    read_one(s, *density, std::tuple(field(Kind::Interpolate, &scene::DensityFile::interpolation)));
    return density;
}

std::shared_ptr<const scene::Object> read_object_pattern(SceneBuilder& build)
{
    BlockReader s(build);
    s.open();
    auto object = read_object(build);
    if (!object) build.fail_unknown("an object");
    return std::make_shared<const scene::Object>(std::move(*object));
}

}  // namespace parser
