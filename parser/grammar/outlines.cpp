#include "parser/grammar/shape_makers.h"
#include "parser/stream/text.h"
#include "render/font/font.h"

#include <algorithm>
#include <stdexcept>

/// Solids between outlines, from the statements that were read of them (reference manual: text, prism).
namespace parser {
namespace {

using scene::StatementItem;

/// POV-Ray's own faces are files of the package (spec 5b, 11).
std::string font_path(SceneBuilder& build, const scene::Statement& statement)
{
    if (const StatementItem* file = item_of(statement, "ttf")) return std::get<std::string>(file->operands[0]);
    static constexpr const char* kFaces[] = {"povlogo.ttf", "timrom.ttf", "cyrvetic.ttf", "crystal.ttf"};
    const double number = number_of(item_of(statement, "internal")->operands[0]);
    const char* const name = kFaces[number >= 1.0 && number < 4.0 ? static_cast<int>(number) : 0];
    const std::string path = build.stream().find_file(name, {});
    if (path.empty()) build.stream().fail(statement.source, std::string("cannot find the font file '") + name + "'");
    return path;
}

using Points = std::vector<glm::dvec2>;
using Pieces = std::vector<csg::OutlinePiece>;

csg::OutlinePiece polynomial(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d)
{
    return {a, b, c, d, d, a + b + c + d};
}

constexpr double kSamePoint = 1e-10;
bool same(const glm::dvec2& a, const glm::dvec2& b) { return glm::distance(a, b) < kSamePoint; }

/// Loops of straight pieces, each closed by its start (spec 5b, 6.2).
Pieces straight(const Points& p)
{
    Pieces pieces;
    for (std::size_t first = 0; first < p.size();) {
        std::size_t last = first + 1;
        for (; last < p.size() && !same(p[first], p[last]); ++last) pieces.push_back(csg::OutlinePiece::line(p[last - 1], p[last]));
        if (last > first + 1) pieces.push_back(csg::OutlinePiece::line(p[last - 1], p[first]));
        first = last + 1;
    }
    return pieces;
}

/// Quadratic and cubic loops: a control point before, for cubic ones another behind (spec 5b, 6.1).
Pieces curved(const Points& p, bool cubic)
{
    Pieces pieces;
    const std::size_t behind = cubic ? 1 : 0;
    for (std::size_t first = 1; first + 1 < p.size();) {
        const std::size_t begin = pieces.size();
        std::size_t i = first;
        for (; i + 1 + behind < p.size(); ++i) {
            const glm::dvec2 &p0 = p[i - 1], &p1 = p[i], &p2 = p[i + 1];
            if (cubic) {
                const glm::dvec2& p3 = p[i + 2];
                pieces.push_back(polynomial(-0.5 * p0 + 1.5 * p1 - 1.5 * p2 + 0.5 * p3, p0 - 2.5 * p1 + 2.0 * p2 - 0.5 * p3, 0.5 * (p2 - p0), p1));
            } else {
                pieces.push_back(polynomial(glm::dvec2(0.0), 0.5 * p0 - p1 + 0.5 * p2, 0.5 * (p2 - p0), p1));
            }
            pieces.back().end = p2;
            if (same(p2, p[first])) {
                pieces.back().end = pieces[begin].start;
                break;
            }
        }
        first = i + 2 + behind + 1;
    }
    return pieces;
}

/// Groups of four; each runs from its last point to its first (spec 5b, 6.1). Empty where a loop is not closed.
Pieces bezier(const Points& p)
{
    Pieces pieces;
    std::size_t loop = 0;
    for (std::size_t i = 0; i + 3 < p.size(); i += 4) {
        const glm::dvec2 &p0 = p[i], &p1 = p[i + 1], &p2 = p[i + 2], &p3 = p[i + 3];
        pieces.push_back(polynomial(p0 - 3.0 * p1 + 3.0 * p2 - p3, 3.0 * p1 - 6.0 * p2 + 3.0 * p3, 3.0 * p2 - 3.0 * p3, p3));
        pieces.back().end = p0;
        const bool joined = i > loop && same(p[i - 1], p0);
        if (i > loop && !joined) return {};
        if (joined) pieces[pieces.size() - 2].start = pieces.back().end;
        if (!same(p3, p[loop])) continue;
        pieces.back().start = pieces[loop / 4].end;
        loop = i + 4;
    }
    return loop == p.size() ? pieces : Pieces();
}

}  // namespace

bool make_text(SceneBuilder& build, const scene::Statement& statement, scene::Object& object)
{
    const auto& operands = item_of(statement, "")->operands;
    const double thickness = number_of(operands[1]);
    const glm::dvec3 offset = std::get<glm::dvec3>(operands[2]);
    const bool unicode = build.stream().language().charset != Charset::Ascii;
    const auto file = font_path(build, statement);
    std::vector<font::Glyph> glyphs;
    try {
        glyphs = font::lay_out(file, units_of(std::get<std::string>(operands[0])), {offset.x, offset.y}, unicode);
    } catch (const std::runtime_error& error) {
        build.stream().fail(statement.source, error.what());
    }
    auto characters = std::make_shared<std::vector<scene::Object>>();
    for (const font::Glyph& glyph : glyphs) {
        scene::Object character;
        character.source = statement.source;
        character.shape = scene::Extrusion{glyph.outline, std::min(0.0, thickness), std::max(0.0, thickness), false, false, false};
        character.transform = csg::Transform::translate({glyph.origin, 0.0});
        characters->push_back(std::move(character));
    }
    scene::Csg all;
    all.operands = std::move(characters);
    object.shape = all;
    // POV-Ray turns every text by this much, visible in its normals and extents (spec 5b, 11).
    object.transform = csg::Transform::rotate_degrees(glm::dvec3(0.001));
    return true;
}

/// False: a cone of outlines, which is not drawn yet.
bool make_prism(SceneBuilder& build, const scene::Statement& statement, scene::Object& object)
{
    bool conic = false;
    for (const StatementItem& one : statement.items) conic = one.name == "conic_sweep" || (conic && one.name != "linear_sweep");
    if (conic) return false;
    Points points;
    for (const auto& p : item_of(statement, "points")->operands) points.push_back(std::get<glm::dvec2>(p));
    const bool by_bezier = item_of(statement, "bezier_spline") != nullptr;
    Pieces pieces = item_of(statement, "linear_spline") ? straight(points)
                    : by_bezier                      ? bezier(points)
                                                     : curved(points, item_of(statement, "cubic_spline") != nullptr);
    if (by_bezier && pieces.empty()) build.stream().warn(statement.source, "an outline of this prism is not closed: it is not drawn");
    const auto& heights = item_of(statement, "height")->operands;
    const double a = number_of(heights[0]), b = number_of(heights[1]);
    const auto outline = std::make_shared<csg::OutlineShape>(std::move(pieces));
    object.shape = scene::Extrusion{outline, std::min(a, b), std::max(a, b), item_of(statement, "open") != nullptr, true, by_bezier};
    // Its points are (x, z), its heights y.
    csg::Transform& turn = object.transform;
    turn.linear = turn.inverse_linear = glm::dmat3({1, 0, 0}, {0, 0, 1}, {0, 1, 0});
    return true;
}

}  // namespace parser
