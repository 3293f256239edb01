#include "parser/grammar/density_file.h"
#include "parser/grammar/function_samples.h"
#include "parser/grammar/statement.h"
#include "parser/stream/function.h"
#include "render/image/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

/// Blocks that name a picture or a volume; its content is read with them.
namespace parser {
namespace {

struct ImageKind { Kind keyword; std::vector<std::string> extensions; };

const std::vector<ImageKind>& image_kinds()
{
    static const std::vector<ImageKind> kinds = {
        {Kind::Gif, {".gif", ".GIF"}}, {Kind::Tga, {".tga", ".TGA"}}, {Kind::Png, {".png", ".PNG"}}, {Kind::Ppm, {".ppm", ".PPM"}},
        {Kind::Pgm, {".pgm", ".PGM"}}, {Kind::Jpeg, {".jpg", ".JPG", ".jpeg", ".JPEG"}}, {Kind::Tiff, {".tif", ".TIF", ".tiff", ".TIFF"}},
        {Kind::Iff, {".iff", ".IFF"}}, {Kind::Exr, {".exr", ".EXR"}}, {Kind::Hdr, {".hdr", ".HDR"}},
        {Kind::Sys, {".bmp", ".BMP"}}, {Kind::Pot, {".pot", ".POT"}}};
    return kinds;
}

bool has_image_extension(const std::string& name)
{
    for (const ImageKind& kind : image_kinds())
        for (const std::string& extension : kind.extensions)
            if (name.ends_with(extension)) return true;
    return false;
}

void add_file(StatementReader& s, std::string_view kind, const std::vector<std::string>& extensions)
{
    const scene::SourceRef at = s.in().here();
    const std::string name = path_expr(s.in());
    if (extensions.empty() && !has_image_extension(name))
        s.in().fail(at, fmt::format("the kind of the image '{}' cannot be told from its name", name));
    const std::string path = s.in().find_file(name, extensions);
    if (path.empty()) s.in().fail(at, fmt::format("cannot find the image file '{}'", name));
    s.in().data_files().push_back(path);
    s.add(kind, {path});
}

constexpr double kMostTexels = 1 << 28;

/// A function's values as a picture of 16 bits.
std::shared_ptr<const image::Picture> picture_of(StatementReader& s, const function::FunctionPtr& called, double columns, double rows)
{
    if (!(columns >= 1.0 && rows >= 1.0 && columns * rows <= kMostTexels)) s.fail("a picture made by a function has at least 1 and at most 2^28 pixels");
    auto picture = std::make_shared<image::Picture>();
    picture->width = static_cast<int>(columns);
    picture->height = static_cast<int>(rows);
    picture->bits = 16;
    picture->channels = static_cast<int>(sampled_channels(*called));
    const auto levels = sampled_levels(s.build(), called, static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows));
    picture->samples.resize(picture->count() * sampled_channels(*called));  // stays 0 where the function asks what is not drawn yet; that was told
    if (levels) std::transform(levels->begin(), levels->end(), picture->samples.begin(), [](std::uint16_t level) { return static_cast<float>(level) / 65535.0f; });
    return picture;
}

/// The picture itself, as the source's last operand.
void load(StatementReader& s)
{
    scene::StatementItem& source = s.statement().items.front();
    if (source.name == "function") {
        const auto& called = std::get<function::FunctionPtr>(item_of(s.statement(), "body")->operands[0]);
        const double columns = std::trunc(number_of(source.operands[0]) + 0.5), rows = std::trunc(number_of(source.operands[1]) + 0.5);
        source.operands.emplace_back(picture_of(s, called, columns, rows));
    } else {
        source.operands.emplace_back(s.build().picture(std::get<std::string>(source.operands[0]), s.in().last()));
    }
}

std::shared_ptr<const scene::Volume> volume_of(StatementReader& s, const std::string& path, const scene::SourceRef& at)
{
    std::ifstream file(path, std::ios::binary);
    auto volume = decode_density_file({std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()});
    if (!volume) s.in().fail(at, fmt::format("'{}' is no density file: its length does not fit its sizes", path));
    return volume;
}

/// What only an image_map insists on (spec 4, 12.1).
void check_mapping(StatementReader& s)
{
    const auto one_of = [&](const char* name, std::initializer_list<double> allowed, const char* listed) {
        const scene::StatementItem* item = item_of(s.statement(), name);
        if (item == nullptr) return;
        const double given = std::trunc(number_of(item->operands[0]));
        if (std::find(allowed.begin(), allowed.end(), given) == allowed.end()) s.fail(fmt::format("{} of an image_map is {}", name, listed));
    };
    one_of("map_type", {0.0, 1.0, 2.0, 5.0}, "0, 1, 2 or 5");
    one_of("interpolate", {2.0, 3.0, 4.0}, "2, 3 or 4");
}

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

void read_image_source(StatementReader& s, bool bare_name_allowed)
{
    for (const ImageKind& kind : image_kinds())
        if (s.accept(kind.keyword)) return add_file(s, spelling(kind.keyword), kind.extensions);
    if (s.accept(Kind::Function)) {
        s.read("function", "ff");
        s.in().expect(Kind::LeftBrace, "'{' and the function's body");
        s.add("body", {read_function_body(s.in(), {})});
        return;
    }
    if (bare_name_allowed && at_string(s.in())) return add_file(s, "file", {});
    s.in().fail_expected("an image: its kind and its file's name, or 'function'");
}

scene::StatementPtr read_image_block(SceneBuilder& build, bool colors)
{
    static constexpr Form kForms[] = {{Kind::MapType, "f"}, {Kind::Interpolate, "f"}, {Kind::Once, ""}, {Kind::Gamma, "f"},
                                      {Kind::Premultiplied, "o"}, {Kind::UseIndex, ""}, {Kind::UseColor, ""}, {Kind::UseAlpha, ""},
                                      {Kind::BumpSize, "f"}, {Kind::Repeat, "p"}, {Kind::Offset, "p"}};
    const auto guard = build.stream().nest();
    StatementReader s(build);
    s.open();
    read_image_source(s, true);
    load(s);
    const bool made = s.statement().items.front().name == "function";
    for (;;) {
        const Kind kind = s.in().peek().kind;
        if (s.accept(Kind::Gamma)) {
            if (s.accept(Kind::Srgb)) s.add("gamma", {std::string("srgb")});
            else s.read("gamma", "f");
        } else if (colors && (s.accept(Kind::Filter) || s.accept(Kind::Transmit))) {
            const bool all = s.accept(Kind::All);
            if (!all && made) s.fail("a picture made by a function has no palette: 'all' is missing");
            s.add(spelling(kind), s.operands(all ? "f" : "ff"));
        } else if (!s.read_one(kForms)) {
            break;
        }
    }
    s.close();
    if (colors) check_mapping(s);
    return s.take();
}

scene::StatementPtr read_material_map(SceneBuilder& build)
{
    static constexpr Form kForms[] = {{Kind::MapType, "f"}, {Kind::Interpolate, "f"}, {Kind::Once, ""}, {Kind::Gamma, "f"}, {Kind::UseIndex, ""},
                                      {Kind::UseColor, ""}, {Kind::Repeat, "p"}, {Kind::Offset, "p"}};
    const auto guard = build.stream().nest();
    StatementReader s(build);
    s.open();
    read_image_source(s, true);
    load(s);
    s.read_all(kForms);
    if (s.in().peek().kind != Kind::Texture) s.in().fail_expected("'texture' and the material of the first colour");
    while (s.accept(Kind::Texture)) s.add("texture", {read_texture(build)});
    s.close();
    return s.take();
}

scene::StatementPtr read_density_file(SceneBuilder& build)
{
    StatementReader s(build);
    s.in().expect(Kind::Df3, "'df3' and the file's name");
    const scene::SourceRef at = s.in().here();
    const std::string name = path_expr(s.in());
    const std::string path = s.in().find_file(name, {".df3", ".DF3"});
    if (path.empty()) s.in().fail(at, fmt::format("cannot find the density file '{}'", name));
    s.in().data_files().push_back(path);
    s.add("df3", {path, volume_of(s, path, at)});
    static constexpr Form kForms[] = {{Kind::Interpolate, "f"}};
    s.read_one(kForms);
    return s.take();
}

scene::StatementPtr read_object_pattern(SceneBuilder& build)
{
    StatementReader s(build);
    s.open();
    auto object = read_object(build);
    if (!object) build.fail_unknown("an object");
    s.add("", {std::make_shared<const scene::Object>(std::move(*object))});
    return s.take();
}

}  // namespace parser
