#include "render/app/mcp/tools.h"

// The tools with the schemas of their arguments. What they say is read by models: it tells when a tool is of use.
namespace app::mcp {
namespace {

const std::string kSceneProperties =
    R"("scene": {"type": "string", "description": "text of a POV-Ray scene; either this or file"},
       "file": {"type": "string", "description": "a .pov file below the server's folder"},
       "declare": {"type": "object", "description": "numbers or texts that the scene finds declared, by name"},
       "clock": {"type": "number", "description": "the scene's clock; usual: 0"},
       "seconds": {"type": "number", "description": "time after which it is stopped; at most the server's limit"})";
const std::string kSizeProperties =
    R"("width": {"type": "integer", "description": "of the picture; usual: 320"},
       "height": {"type": "integer", "description": "of the picture; usual: 240"})";
const std::string kObjectProperty =
    R"("object": {"type": "string", "description": "a declared name; usual: all objects of the scene"})";

// clang-format off
const std::vector<Tool> kTools = {
    {"check", "Check a scene",
     "Reads a scene without rendering it and tells errors and warnings with file, line, column, source line, cause, and a "
     "suggestion where a word was misspelt. Fast: use it before every render.",
     kSceneProperties, "[]", check_tool},
    {"render", "Render a picture",
     "Renders a scene as a PNG picture. Begin small (320x240, no antialias). The picture is kept under the name that is told, "
     "for compare. Stopped for its time, it gives what was done.",
     kSceneProperties + ", " + kSizeProperties + R"(, "antialias": {"type": "boolean", "description": "smooth edges; usual: false"})",
     "[]", render_tool},
    {"pixel", "Explain a pixel",
     "Why a pixel has its colour: the tree of its rays, what they meet at which line of the text, pigment, normal, what each "
     "light gives. Use it where a part of the picture is black, missing or of a wrong colour.",
     kSceneProperties + ", " + kSizeProperties + R"(, "x": {"type": "integer", "description": "column, from 0 at the left"},
       "y": {"type": "integer", "description": "row, from 0 at the top"})",
     R"(["x", "y"])", pixel_tool},
    {"info", "Measure objects",
     "Extent, volume, surface, centre of mass and inertia of each object, with error bounds, one JSON object a line.",
     kSceneProperties + ", " + kObjectProperty +
     R"(, "precision": {"type": "number", "description": "share that volume and surface may be off by; usual: 2e-4"})",
     "[]", info_tool},
    {"section", "Cut by a plane",
     "What the plane in which x, y or z has a value cuts of the objects, as an SVG drawing in scene units, with area and length.",
     kSceneProperties + ", " + kObjectProperty +
     R"(, "axis": {"type": "string", "enum": ["x", "y", "z"]}, "value": {"type": "number"},
       "tolerance": {"type": "number", "description": "scene units that it may be off by; usual: 0.01"})",
     R"(["axis", "value"])", section_tool},
    {"mesh", "Make a triangle mesh",
     "Each object as a closed triangle mesh for printing, with checks and its deviation from the exact object.",
     kSceneProperties + ", " + kObjectProperty +
     R"(, "format": {"type": "string", "enum": ["stl", "obj", "ply", "3mf", "glb"], "description": "usual: stl"},
       "tolerance": {"type": "number", "description": "scene units that it may be off by; usual: 0.01"})",
     "[]", mesh_tool},
    {"compare", "Compare two pictures",
     "How far two pictures of one size are apart: agreeing pixels, root mean square, SSIM, FLIP, the worst pixel.",
     R"("a": {"type": "string", "description": "a name that render told, or a picture below the server's folder"},
       "b": {"type": "string", "description": "the same"},
       "tolerance": {"type": "number", "description": "difference of a channel that agrees, of 255; usual: 3"})",
     R"(["a", "b"])", compare_tool},
    {"explain_keyword", "Explain a word of the language",
     "What a keyword of the scene language does, in which blocks it may stand, and which words its own block takes.",
     R"("word": {"type": "string", "description": "a keyword, as in finish; with block also empty, for the words that it takes"},
       "block": {"type": "string", "description": "a keyword with a block: whether the word may stand in it"})",
     R"(["word"])", explain_keyword_tool},
};
// clang-format on

}  // namespace

const std::vector<Tool>& tools() { return kTools; }

}  // namespace app::mcp
