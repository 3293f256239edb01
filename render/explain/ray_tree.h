#pragma once

#include "csg/base/hit.h"
#include "csg/tree/program.h"
#include "render/explain/ray_spans.h"
#include "render/kernel/tile/ray_state.h"
#include "render/light/illuminate.h"
#include "render/plan/compiled_scene.h"
#include "render/texture/shown.h"

#include <memory>
#include <string>
#include <vector>

/// Why a ray has its colour. Colours are linear light as it is added up, before the picture's gamma.
namespace explain {

/// What a light gives to one layer.
struct LightShare {
    std::size_t number = 0;  ///< in CompiledScene::lights
    glm::dvec3 location{0};
    glm::vec3 arriving{0};  ///< its colour here, past what stands between
    glm::vec3 diffuse{0}, highlight{0};
    std::string why;  ///< it gives nothing, or less than it has; empty: all of it arrives
};

/// One layer of a texture at a hit.
struct LayerShare {
    scene::Color pigment;
    glm::dvec3 normal{0};  ///< of the layer, as it bends the surface's
    float own = 1;         ///< share of it that is its own colour
    glm::vec3 above{1};    ///< what the layers above it let through
    glm::vec3 glow{0};     ///< ambient light and emission
    std::vector<LightShare> lights;
    glm::vec3 sum{0};  ///< of all that, past the layers above
};

struct RayNode;

/// A ray that goes on from a hit.
struct SecondaryRay {
    std::string how;  ///< "reflected", "refracted", "passes on", "reflected within"
    glm::vec3 factor{1};
    std::unique_ptr<RayNode> ray;  ///< null: it was cut off
    std::string cut;               ///< why
};

/// One of the textures that a hit shows: the whole of it, or its share of a map, an average, a blob's or a mesh's mix.
struct TextureShare {
    float weight = 1;
    std::string of;  ///< what it is a share of; empty: all
    std::vector<LayerShare> layers;
    std::vector<SecondaryRay> onward;
};

struct RayNode {
    std::string kind = "camera";
    csg::Ray ray;
    int level = 0;
    std::vector<ObjectSpans> spans;
    bool hit = false;
    double t = 0;
    glm::dvec3 point{0}, normal{0};        ///< of the surface, toward the viewer
    const scene::Object* solid = nullptr;  ///< that was met, where its spans tell; null: unknown
    scene::SourceRef object;               ///< the top-level object
    bool from_inside = false;
    std::vector<TextureShare> textures;
    std::string sees;  ///< where nothing is hit: the sky's words
    glm::vec3 color{0};
};

/// Explains rays of one scene. \param description that the scene was compiled from, alive meanwhile
class RayTree {
public:
    RayTree(const scene::Description& description, const plan::CompiledScene& scene)
        : description_(description), scene_(scene), world_(scene.world()), spans_(description)
    {}

    std::unique_ptr<RayNode> explain(const csg::Ray& camera_ray);
    /// What the scene has that is not part of the sums.
    std::vector<std::string> left_out() const;

private:
    struct Way;
    struct Met;
    std::unique_ptr<RayNode> follow(const Way& way);
    void see_sky(RayNode& node, bool mirrored) const;
    void shade(RayNode& node, const Way& way, const csg::Hit& hit);
    void add_texture(const Met& met, std::uint32_t index, const glm::dvec3& p, float weight, const std::string& of,
                     texture::Enclosing around);
    void add_layers(const Met& met, const texture::Texture& texture, const glm::dvec3& p, float weight,
                    const std::string& of, const texture::Enclosing& around);
    LightShare light_share(const Met& met, std::size_t number, const texture::Finish& finish,
                           const scene::Color& pigment, const glm::dvec3& normal, float own);
    glm::vec3 past_shadows(const Met& met, const light::Light& light, std::string& why);
    glm::vec3 unshadowed(const csg::Ray& ray, double from, double to, trace::InteriorList inside, std::string& why);
    SecondaryRay go_on(const Way& way, int used, const char* how, const glm::vec3& factor);
    void mirror(const Met& met, const texture::Finish& finish, const scene::Color& pigment, const glm::dvec3& normal,
                float residual, TextureShare& into);
    glm::vec3 mirrored_share(const Met& met, const texture::Finish& finish, const scene::Color& pigment,
                             const glm::dvec3& normal) const;
    void let_through(const Met& met, const glm::vec3& filter, const glm::dvec3& normal, TextureShare& into);
    std::string named(std::uint32_t object) const;

    const scene::Description& description_;
    const plan::CompiledScene& scene_;
    const csg::World world_;
    RaySpans spans_;
    csg::Scratch scratch_;
    std::size_t rays_ = 0;
};

}  // namespace explain
