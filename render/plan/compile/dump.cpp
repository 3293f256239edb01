#include "render/plan/compiled_scene.h"

#include <fmt/format.h>

#include <algorithm>

namespace plan {
namespace {

constexpr const char* kSolidNames[] = {"sphere",   "ellipsoid", "box",       "oriented box", "plane",
                                       "cylinder", "cone",      "torus",     "quadric",      "disc",
                                       "triangle", "mesh",      "extrusion", "polynomial",   "freeform"};
static_assert(std::size(kSolidNames) == csg::kSolidKinds);

constexpr const char* kOpNames[] = {"leaf", "union", "merge", "intersection", "clip"};

std::string box(const csg::Aabb& b)
{
    return fmt::format("<{:g} {:g} {:g}>..<{:g} {:g} {:g}>", b.lower.x, b.lower.y, b.lower.z, b.upper.x, b.upper.y,
                       b.upper.z);
}

std::string leaf(const csg::SolidStore& store, csg::PartId part, bool inverted)
{
    const csg::SurfaceId surface = store.surface(part);
    const std::string look = surface == csg::kNoSurface ? "no surface" : fmt::format("surface {}", surface);
    return fmt::format("{}{} {}, {}", inverted ? "outside of " : "",
                       kSolidNames[static_cast<std::size_t>(csg::kind_of(part))], csg::index_of(part), look);
}

/// What the sum of products makes of the object (docs/flat_csg.md).
std::string flat(const csg::SumOfProducts& form)
{
    if (!form.usable()) return "";
    const std::size_t cuts = static_cast<std::size_t>(
        std::count_if(form.cuts.begin(), form.cuts.end(), [](const csg::ProductCut& cut) { return cut.count != 0; }));
    if (form.merged) return fmt::format(", merge of {} solids", cuts);
    if (form.simple() && form.terms[0].plain()) return ", convex";
    return fmt::format(", flat: {} term{}, {} cut{}", form.terms.size(), form.terms.size() == 1 ? "" : "s", cuts,
                       cuts == 1 ? "" : "s");
}

void program(const csg::SolidStore& store, const csg::Program& p, std::string& text)
{
    text += fmt::format("program{}, {}\n", flat(p.products), box(p.bounds));
    std::vector<std::uint32_t> open;  // ends of the operators that hold the node
    for (std::uint32_t i = 0; i < p.nodes.size(); ++i) {
        while (!open.empty() && open.back() <= i) open.pop_back();
        const csg::Node& node = p.nodes[i];
        text += std::string(4 + 2 * open.size(), ' ');
        if (node.op == csg::Op::Leaf) {
            text += leaf(store, node.solid, node.inverted) + "\n";
        } else {
            text += fmt::format("{}\n", kOpNames[static_cast<std::size_t>(node.op)]);
            open.push_back(node.end);
        }
    }
}

}  // namespace

std::string dump(const CompiledScene& scene)
{
    const csg::WorldData& world = scene.geometry;
    std::string text = fmt::format("items {}, unbounded {}, hierarchy: {} nodes, {} levels\n", world.items.size(),
                                   world.unbounded.size(), world.bvh.nodes.size(), world.bvh.depth);
    for (const csg::WorldItem& item : world.items) {
        text += fmt::format("  object {}: ", item.object);
        if (item.instance != csg::Hit::kNoInstance) text += fmt::format("instance {}\n", item.instance);
        else if (item.solid != csg::kNoPart) text += leaf(world.store, item.solid, item.inverted) + "\n";
        else program(world.store, world.programs[item.program], text);
    }
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        const Surface& s = scene.surfaces[i];
        text += fmt::format("surface {}: object {}, texture {}, interior {}{}{}{}{}\n", i, s.object, s.texture,
                            s.interior, s.opaque ? ", opaque" : "", s.no_shadow ? ", no shadow" : "",
                            s.no_image ? ", no image" : "", s.no_reflection ? ", no reflection" : "");
    }
    text += fmt::format("interiors {}, lights {}, textures {}\n", scene.interiors.size(), scene.lights.lights.size(),
                        scene.textures.textures.size());
    return text;
}

}  // namespace plan
