#pragma once

#include "csg/freeform/freeform.h"
#include "render/plan/compiled_scene.h"

#include <unordered_map>

namespace plan {

/// Gives the functions that solids are made of what they ask of the scene: noise, patterns, pigments. What asks them
/// before the first ray does so then. Under Options::faithful isosurfaces trust their max_gradient.
class FieldLinker {
public:
    /// `notes` receives what cannot be evaluated; a solid that needs it is empty.
    FieldLinker(const scene::Description& scene, const Options& options, std::vector<scene::Unsupported>& notes)
        : scene_(scene), quality_(options.quality), faithful_(options.faithful), notes_(notes)
    {}

    /// The shape itself if nothing of it changes. Copies of one shape stay one.
    std::shared_ptr<const csg::FreeformShape> linked(const std::shared_ptr<const csg::FreeformShape>& shape);

private:
    std::shared_ptr<const csg::Field> linked(const std::shared_ptr<const csg::Field>& field);

    const scene::Description& scene_;
    Quality quality_;
    bool faithful_;
    std::vector<scene::Unsupported>& notes_;
    std::unordered_map<std::shared_ptr<const csg::FreeformShape>, std::shared_ptr<const csg::FreeformShape>> known_;
};

}  // namespace plan
