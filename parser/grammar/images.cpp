#include "parser/grammar/statement.h"
#include "parser/stream/function.h"

#include <fmt/format.h>

/// Blocks that name a picture or a volume: the file must exist, its content is not looked at here.
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

}  // namespace

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
                                      {Kind::BumpSize, "f"}};
    const auto guard = build.stream().nest();
    StatementReader s(build);
    s.open();
    read_image_source(s, true);
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
    return s.take();
}

scene::StatementPtr read_material_map(SceneBuilder& build)
{
    static constexpr Form kForms[] = {{Kind::MapType, "f"}, {Kind::Interpolate, "f"}, {Kind::Once, ""}, {Kind::Gamma, "f"}, {Kind::UseIndex, ""},
                                      {Kind::UseColor, ""}};
    const auto guard = build.stream().nest();
    StatementReader s(build);
    s.open();
    read_image_source(s, true);
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
    s.add("df3", {path});
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
