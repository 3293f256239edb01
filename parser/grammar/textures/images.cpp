#include "csg/freeform/freeform.h"
#include "parser/grammar/textures/density_file.h"
#include "parser/grammar/core/function_samples.h"
#include "parser/grammar/textures/images.h"
#include "parser/stream/files/file_bytes.h"
#include "parser/stream/functions/function.h"
#include "render/image/files.h"
#include "render/image/pixels/passing_failure.h"
#include "render/scene/base/passing_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

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

/// A file that must exist; its place and path.
std::pair<scene::SourceRef, std::string> read_file_name(TokenStream& in, const std::vector<std::string>& extensions,
                                                        const char* what)
{
    const scene::SourceRef at = in.here();
    const std::string name = path_expr(in);
    if (extensions.empty() && !has_image_extension(name))
        in.fail(at, fmt::format("the kind of the image '{}' cannot be told from its name", name));
    std::string path = in.find_file(name, extensions);
    if (path.empty()) in.fail(at, fmt::format("cannot find the {} file '{}'", what, name));
    in.read_files().data(path);
    return {at, path};
}

constexpr double kMostTexels = 1 << 28;

/// A function's values as a picture of 16 bits.
std::shared_ptr<const image::Picture> picture_of(SceneBuilder& build, const scene::ImageSource& source)
{
    const double columns = std::trunc(source.size.x + 0.5), rows = std::trunc(source.size.y + 0.5);
    if (!(columns >= 1.0 && rows >= 1.0 && columns * rows <= kMostTexels))
        build.stream().fail(build.stream().last(),
                            "a picture made by a function has at least 1 and at most 2^28 pixels");
    const function::FunctionPtr& called = source.function;
    auto picture = std::make_shared<image::Picture>();
    picture->width = static_cast<int>(columns);
    picture->height = static_cast<int>(rows);
    picture->bits = 16;
    picture->channels = static_cast<int>(sampled_channels(*called));
    auto levels = sampled_levels(build, called, static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows));
    // 0 where the function asks what is not drawn yet; that was told
    if (!levels) levels.emplace(picture->count() * sampled_channels(*called));
    picture->samples = {std::move(*levels), 65535};
    return picture;
}

std::shared_ptr<const scene::Volume> volume_of(TokenStream& in, const std::string& path, const scene::SourceRef& at)
{
    auto volume = decode_density_file(bytes_of_file(in, at, path));
    if (!volume) in.fail(at, fmt::format("'{}' is no density file: its length does not fit its sizes", path));
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

using scene::ImageMap;

struct ImageState : StructState<ImageMap> {
    using StructState::StructState;
    scene::ImageSource& part(scene::ImageSource*) { return made.source; }
    TextureMap materials;
    /// Whether an image_map takes what was written; the other users do not mind (spec 4, 12.1).
    bool projection_fits = true, interpolation_fits = true;
};
/// The source of a pattern's picture, its content included.
struct picture : taker<picture>, always {
    static bool take(TokenStream& in, ImageState& s)
    {
        // Up to version 2 an image was laid out along the axes of a vector, as in image_map { <1, -1, 0> gif "a.gif" };
        // it is without effect (spec 4, 12.10).
        if (at_expression(in) && !at_string(in)) vector_expr(in);
        scene::ImageSource& source = s.made.source = read_image_source(s.build);
        source.picture = source.made() ? picture_of(s.build, source) : s.build.picture(source.path, in.last());
        return true;
    }
    static Form form() { return image_source_form(); }
};
struct map_type : item<Kind::MapType, a_number> {
    static void act(ImageState& s)
    {
        constexpr int kAngular = 7;  // a number without meaning before POV-Ray 3.8
        const int number = s.pop_int();
        const bool known = number != kAngular || s.stream().povray() == scene::PovRay::V38;
        s.projection_fits = known && set_by_number(s.made.projection, ImageMap::kProjections, number) &&
                            s.projection_fits;
    }
};
struct interpolate : item<Kind::Interpolate, a_number> {
    static void act(ImageState& s)
    {
        const int number = s.pop_int();
        s.interpolation_fits = set_by_number(s.made.interpolation, ImageMap::kInterpolations, number) && number != 0 &&
                               s.interpolation_fits;
    }
};
/// filter and transmit, of all pixels or of a place in the palette.
template <Kind kind>
struct clarity : item<kind, by_action<pegtl::sor<token<Kind::All>, a_number>, opt_comma, a_number>> {
    static void act(ImageState& s)
    {
        ImageMap::Clarity clarity;
        clarity.filter = kind == Kind::Filter;
        if (!s.stream().accept(Kind::All)) {
            if (s.made.source.made()) s.fail("a picture made by a function has no palette: 'all' is missing");
            constexpr double kSlack = 0.01;  // POV-Ray's, before it cuts off
            clarity.place = whole_number(number(s.stream()) + kSlack);
            s.stream().accept_comma();
        }
        read_value(s.stream(), clarity.amount);
        s.made.clarities.push_back(clarity);
    }
};
struct image_material : item<Kind::Texture, reads<texture_block>> {
    static void act(ImageState& s)
    {
        s.materials.push_back({static_cast<double>(s.materials.size()), read_texture(s.build)});
    }
};
using Use = ImageMap::Use;
using PictureItems =
    table<ImageState, image_gamma, map_type, interpolate, chosen<Kind::UseIndex, &ImageMap::use, Use::Index>,
          chosen<Kind::UseColor, &ImageMap::use, Use::Color>, word<Kind::Once, &ImageMap::once>,
          member<Kind::Repeat, &ImageMap::repeat>, member<Kind::Offset, &ImageMap::offset>>;
using ValueItems =
    either<PictureItems,
           table<ImageState, chosen<Kind::UseAlpha, &ImageMap::use, Use::Alpha>,
                 member<Kind::Premultiplied, &ImageMap::premultiplied>, member<Kind::BumpSize, &ImageMap::bump_size>>>;
using ColorItems = either<ValueItems, table<ImageState, clarity<Kind::Filter>, clarity<Kind::Transmit>>>;
/// The textures come last.
struct MaterialItems {
    using Materials = table<ImageState, image_material>;
    static bool match(SceneBuilder& build, ImageState& s)
    {
        if (s.materials.empty() && PictureItems::match(build, s)) return true;
        if (!s.materials.empty() || build.stream().peek().kind == Kind::Texture) return Materials::match(build, s);
        build.stream().fail_expected("'texture' and the material of the first colour");
    }
    static std::vector<Kind> words() { return {}; }
    static Form form() { return either<PictureItems, Materials>::form(); }
};
using ImageMapBlock = block<Kind::ImageMap, ColorItems, picture>;
using ImageBlock = block<Kind::ImagePattern, ValueItems, picture>;
using MaterialBlock = block<Kind::MaterialMap, MaterialItems, picture>;

template <class Block>
std::shared_ptr<const ImageMap> read_image(SceneBuilder& build, ImageState& s)
{
    s.made.at = build.stream().last();
    Block::read(build, s, spelling(build.stream().taken_last().kind));
    return std::make_shared<const ImageMap>(std::move(s.made));
}

}  // namespace

std::shared_ptr<const image::Picture> SceneBuilder::picture(const std::string& path, const scene::SourceRef& at)
{
    auto& known = pictures_[path];
    try {
        if (!known) known = std::make_shared<const image::Picture>(image::Files().read(path));
    } catch (const image::PassingFailure& error) {
        scene::fail_for_now([&] { stream().fail(at, error.what()); });
    } catch (const image::FileError& error) {
        stream().fail(at, error.what());
    }
    return known;
}

Form image_source_form()
{
    std::vector<Form> all{form_of<a_text>()};
    for (const ImageKind& kind : image_kinds())
        all.push_back(Form::sequence({Form::token(kind.keyword), form_of<a_text>()}));
    all.push_back(Form::sequence(
        {Form::token(Kind::Function), form_of<seq<a_number, opt_comma, a_number>>(), Form::named(function_block)}));
    return Form::choice(std::move(all));
}

scene::ImageSource read_image_source(SceneBuilder& build)
{
    TokenStream& in = build.stream();
    scene::ImageSource source;
    source.version = in.language().effective_version();
    for (const ImageKind& kind : image_kinds()) {
        if (!in.accept(kind.keyword)) continue;
        source.kind = spelling(kind.keyword);
        source.path = read_file_name(in, kind.extensions, "image").second;
        return source;
    }
    if (in.accept(Kind::Function)) {
        source.kind = spelling(Kind::Function);
        read_values(in, source.size.x, source.size.y);
        in.expect(Kind::LeftBrace, "'{' and the function's body");
        source.function = read_function_body(in, {});
    } else if (at_string(in)) {
        source.kind = "file";
        source.path = read_file_name(in, {}, "image").second;
    } else {
        in.fail_expected("an image: its kind and its file's name, or 'function'");
    }
    return source;
}

Production image_map_block() { return {"image_map_block", ImageMapBlock::form()}; }
Production image_block() { return {"image_block", ImageBlock::form()}; }
Production material_map_block() { return {"material_map_block", MaterialBlock::form()}; }

std::shared_ptr<const ImageMap> read_image_block(SceneBuilder& build, bool colors)
{
    ImageState s(build);
    if (!colors) return read_image<ImageBlock>(build, s);
    const auto image = read_image<ImageMapBlock>(build, s);
    if (!s.projection_fits) s.fail("map_type of an image_map is 0, 1, 2 or 5; of POV-Ray 3.8 also 7");
    if (!s.interpolation_fits) s.fail("interpolate of an image_map is 2, 3 or 4");
    return image;
}

std::shared_ptr<const ImageMap> read_material_map(SceneBuilder& build, TextureMap& materials)
{
    ImageState s(build);
    auto image = read_image<MaterialBlock>(build, s);
    materials = std::move(s.materials);
    return image;
}

std::shared_ptr<const scene::DensityFile> read_density_file(SceneBuilder& build)
{
    TokenStream& in = build.stream();
    auto density = std::make_shared<scene::DensityFile>();
    density->at = in.last();
    in.expect(Kind::Df3, "'df3' and the file's name");
    const auto [at, path] = read_file_name(in, {".df3", ".DF3"}, "density");
    density->path = path;
    density->volume = volume_of(in, path, at);
    if (in.accept(Kind::Interpolate)) read_value(in, density->interpolation);
    return density;
}

std::shared_ptr<const scene::Object> read_object_pattern(SceneBuilder& build)
{
    build.open_block("object");
    auto object = read_object(build);
    if (!object) build.fail_unknown("an object");
    return std::make_shared<const scene::Object>(std::move(*object));
}

std::shared_ptr<const scene::Object> read_potential(SceneBuilder& build)
{
    const auto opened = build.open_block("potential");
    const scene::SourceRef at = build.stream().here();
    auto object = read_object(build);
    const auto* shape = object ? std::get_if<scene::Freeform>(&object->shape) : nullptr;
    const bool field = shape && (std::holds_alternative<csg::Blob>(shape->shape->kind) ||
                                 std::holds_alternative<csg::Isosurface>(shape->shape->kind));
    if (!field) build.stream().fail(at, "'potential' takes a blob or an isosurface");
    build.close_block("potential", opened);
    return std::make_shared<const scene::Object>(std::move(*object));
}

}  // namespace parser
