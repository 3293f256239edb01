#pragma once

#include "render/kernel/tile/geometry.h"
#include "render/plan/compiled_scene.h"
#include "render/texture/shown.h"

#include <vector>

namespace trace {

/// Whether the raw normal of a hit faces along its ray.
inline bool from_inside(const HitDetails& at, const glm::dvec3& direction)
{
    return glm::dot(at.normal, direction) > 0.0;
}

/// The textures that a hit shows side by side, by their shares: those of its shape's parts (a blob's components), of
/// the corners of a mesh's face, or the only one of the side that is seen. None: black.
class SideTextures {
public:
    /// kept: room for the shares of parts
    SideTextures(const plan::CompiledScene& scene, const csg::World& world, const Hit& hit, const HitDetails& details,
                 bool inside, std::vector<csg::Share>& kept)
        : scene_(scene), surface_(scene.surfaces[hit.surface]), texture_(surface_.texture_of(inside)),
          weights_(details.weights), parts_(kept)
    {
        if (texture_ == plan::kNone) return;
        size_ = surface_.blends() && texture_ == surface_.texture ? 3 : 1;
        if (surface_.part_count == 0) return;
        parts_.clear();
        world.shares(hit, details.point, parts_);
        size_ = parts_.size();
    }

    std::size_t size() const { return size_; }
    /// There may be more than one.
    bool mixed() const { return surface_.part_count != 0 || size_ > 1; }
    std::uint32_t texture(std::size_t k) const
    {
        if (surface_.part_count != 0) return scene_.part_textures[surface_.first_part + parts_[k].part];
        return k == 0 ? texture_ : surface_.corner_textures[k - 1];
    }
    /// Of the part or the corner.
    std::uint32_t number(std::size_t k) const
    {
        return surface_.part_count != 0 ? parts_[k].part : static_cast<std::uint32_t>(k);
    }
    float share(std::size_t k) const
    {
        if (surface_.part_count != 0) return parts_[k].weight;
        return size_ == 1 ? 1.0f : weights_[static_cast<int>(k)];
    }

    /// f(layers, p, share) for all layers that the hit shows; enclosing: of each, while f is called.
    template <class F>
    void each_layers(const glm::dvec3& p, const texture::Surroundings& around, texture::Enclosing& enclosing,
                     F&& f) const
    {
        for (std::size_t k = 0; k < size_; ++k) {
            const float here = share(k);
            if (!(here > 0.0f)) continue;
            enclosing.leave_all();
            texture::each_layers(scene_.textures, texture(k), p, around, enclosing, here, f);
        }
    }

private:
    const plan::CompiledScene& scene_;
    const plan::Surface& surface_;
    std::uint32_t texture_;
    glm::vec3 weights_;
    std::vector<csg::Share>& parts_;
    std::size_t size_ = 0;
};

}  // namespace trace
