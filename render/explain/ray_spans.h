#pragma once

#include "csg/base/types.h"
#include "render/scene/description.h"

#include <memory>
#include <unordered_map>
#include <vector>

namespace explain {

/// A place where a ray goes into or out of a solid.
struct End {
    double t = 0;
    const scene::Object* leaf = nullptr;  ///< whose surface is crossed; null at infinity
};

struct Piece {
    End in, out;
};

/// The pieces of a ray inside one top-level object, in order.
struct ObjectSpans {
    const scene::Object* object = nullptr;
    std::vector<Piece> pieces;
};

/// Spans of the objects of a description as the author combined them: by the definition of union, intersection,
/// difference and merge on sorted pieces, without what the tracer leaves out or joins to be fast. Leaves are asked one
/// by one, through the geometry that pictures are made with.
class RaySpans {
public:
    explicit RaySpans(const scene::Description& description);
    ~RaySpans();
    RaySpans(const RaySpans&) = delete;
    RaySpans& operator=(const RaySpans&) = delete;

    /// Of the objects whose box the ray meets at or beyond its start, at most `most` of them, nearest first.
    std::vector<ObjectSpans> along(const csg::Ray& ray, std::size_t most);

private:
    struct Leaf;
    std::vector<Piece> inside(const scene::Object& object, const csg::Transform& parent, const csg::Ray& ray);
    std::vector<Piece> shape_inside(const scene::Object& object, const csg::Transform& parent, const csg::Ray& ray);
    std::vector<Piece> leaf_inside(const scene::Object& object, const csg::Transform& parent, const csg::Ray& ray);

    const scene::Description& description_;
    std::vector<csg::Aabb> boxes_;  ///< by object
    std::unordered_map<const scene::Object*, std::vector<std::unique_ptr<Leaf>>> leaves_;
};

}  // namespace explain
