#include "render/app/mcp/guide.h"

#include "language/places/place_words.h"
#include "parser/grammar.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace app::mcp {
namespace {

using parser::Kind;

constexpr const char* kGuide = R"(# Scenes for Whittle, in short

Text in POV-Ray's scene language. Left-handed: x right, y up, z into the picture. Statements have no end sign; blocks are braces.

    #version 3.7;
    global_settings { assumed_gamma 1 }
    camera { location <0, 2, -6> look_at <0, 0.5, 0> angle 40 right x*image_width/image_height }
    light_source { <-5, 8, -6>, rgb 1 }
    background { rgb <0.8, 0.9, 1> }
    #declare Red = texture { pigment { rgb <0.8, 0.1, 0.1> } finish { specular 0.4 } };
    plane { y, 0 pigment { checker rgb 0.9, rgb 0.5 } }
    difference {
      box { <-1, 0, -1>, <1, 2, 1> }
      cylinder { <0, -0.1, 0>, <0, 2.1, 0>, 0.5 }     // reaches beyond both faces: no film is left over the hole
      texture { Red }
    }

## Solids
sphere { centre, r }  box { corner, corner }  cylinder { end, end, r }  cone { end, r, end, r }  torus { major, minor }
plane { normal, distance }  prism, lathe, sor, blob, isosurface { function { } contained_by { } }, height_field, mesh2, text, ...
union, intersection, difference, merge { objects }; `inverse`; `translate`, `rotate` (degrees, x then y then z), `scale`, `matrix`.

## Looks
pigment { rgb | pattern color_map { [0 rgb 0] [1 rgb 1] } }  normal { pattern amount }  finish { ambient diffuse specular phong
reflection { } }  interior { ior 1.5 } with a pigment that transmits (rgbt, rgbf) makes glass.

## Directives
#declare Name = value;   #local   #macro Name(A, B) ... #end   #if #else #end   #while (cond) #end   #for (I, 0, 9) #end
Files and messages: #include "colors.inc"    #debug "text\n"   rand(seed(1))   vlength(v) vnormalize(v) vcross(a, b) vdot(a, b)

## What goes wrong most often
- `#declare` of a number ends with `;`. A declared object stands in the scene as `object { Name }`.
- Faces that coincide in a difference leave films: let the part that is taken away reach a little beyond.
- The camera stands inside of a solid, or the light does: the picture is black.
- rgb values are linear light with assumed_gamma 1; `srgb` takes values as seen on a screen.

## How to work
check after each change; render small; pixel where something looks wrong; info and section for sizes; compare before and after.
)";

struct Resource {
    std::string_view uri, name, meaning, type;
};
constexpr std::array kResources = {
    Resource{"whittle://guide", "guide", "The scene language in short, and what goes wrong most often",
             "text/markdown"},
    Resource{"whittle://keywords", "keywords", "Every keyword with what it does, a line each", "text/markdown"},
    Resource{"whittle://grammar", "grammar", "The scene language in EBNF, told from the rules that read it",
             "text/plain"},
};

/// All keywords with a line.
std::vector<Kind> keywords()
{
    std::vector<Kind> all;
    for (auto number = static_cast<std::uint16_t>(parser::kFirstKeyword);; ++number) {
        const Kind kind = static_cast<Kind>(number);
        if (parser::spelling(kind).empty() || parser::keyword_of(parser::spelling(kind)) != kind) break;
        all.push_back(kind);
    }
    return all;
}

std::string keyword_list()
{
    std::string text = "# Keywords\n\n";
    for (const Kind kind : keywords())
        if (const auto line = language::keyword_line(kind); !line.empty())
            text += fmt::format("- `{}`: {}\n", parser::spelling(kind), line);
    return text;
}

bool has(const std::vector<std::string>& words, const std::string& word)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

std::string listed(std::vector<std::string> words)
{
    std::sort(words.begin(), words.end());
    return fmt::format("{}", fmt::join(words, ", "));
}

Kind known_keyword(const std::string& word, const char* name)
{
    const Kind kind = parser::keyword_of(word);
    if (!parser::is_keyword(kind)) throw ToolFailure(fmt::format("{} '{}' is no keyword of the language", name, word));
    return kind;
}

}  // namespace

json resource_list()
{
    json list = json::array();
    for (const Resource& one : kResources)
        list.push_back({{"uri", one.uri}, {"name", one.name}, {"description", one.meaning}, {"mimeType", one.type}});
    return {{"resources", std::move(list)}};
}

json resource_contents(const std::string& uri)
{
    const auto* const found =
        std::find_if(kResources.begin(), kResources.end(), [&](const Resource& r) { return r.uri == uri; });
    if (found == kResources.end()) return nullptr;
    std::string text = found->name == "guide"      ? std::string(kGuide)
                       : found->name == "keywords" ? keyword_list()
                                                   : parser::ebnf(parser::grammar());
    return {{"contents", json::array({{{"uri", uri}, {"mimeType", found->type}, {"text", std::move(text)}}})}};
}

const char* instructions()
{
    return "Whittle renders scenes in POV-Ray's language and measures their exact solids. Read whittle://guide once. "
           "Call check "
           "after each change of a scene's text, then render small; pixel tells why a pixel has its colour.";
}

json explain_keyword_tool(Workshop&, const json& arguments)
{
    const std::string& word = rpc::string_member(arguments, "word");
    const std::string block = arguments.contains("block") ? rpc::string_member(arguments, "block") : std::string();
    if (word.empty() && block.empty()) throw Refusal(ErrorCode::InvalidParams, "'word' is empty");
    std::string text;
    if (!word.empty()) {
        const Kind kind = known_keyword(word, "the word");
        const auto line = language::keyword_line(kind);
        text += fmt::format("`{}`: {}\n", word, line.empty() ? "nothing is written down about it" : line);
        std::vector<std::string> places;
        if (has(language::scene_words(), word)) places.emplace_back("outside of all blocks");
        for (const Kind outer : keywords())
            if (has(language::block_words(outer, Kind::EndOfText), word)) places.emplace_back(parser::spelling(outer));
        if (!places.empty()) text += fmt::format("It may stand in: {}\n", listed(std::move(places)));
        if (const auto inner = language::block_words(kind, Kind::EndOfText); !inner.empty())
            text += fmt::format("Its block takes: {}\n", listed(inner));
    }
    if (!block.empty()) {
        const auto inner = language::block_words(known_keyword(block, "the block"), Kind::EndOfText);
        if (inner.empty()) text += fmt::format("`{}` has no block of words.\n", block);
        else if (word.empty()) text += fmt::format("`{}` takes: {}\n", block, listed(inner));
        else text += fmt::format("In `{}` it may {}stand.\n", block, has(inner, word) ? "" : "not ");
    }
    return text_result(text);
}

}  // namespace app::mcp
