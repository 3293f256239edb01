#pragma once

#include "render/plan/compiled_scene.h"
#include "render/plan/geometry/transform_key.h"
#include "render/plan/textures/fields.h"
#include "render/plan/textures/interiors.h"
#include "render/plan/textures/textures.h"
#include "render/plan/textures/uv_use.h"

#include <map>
#include <tuple>
#include <unordered_map>

namespace plan {

using scene::is_light;

/// Whether a mesh has an inside.
bool mesh_is_solid(const scene::MeshData& mesh);

/// Whether an untextured operand of a difference or intersection with cutaway_textures shows what is cut (spec
/// 5a, 8.3).
bool takes_cut_texture(const scene::Object& operand, bool subtracted);

/// Flattens the tree of objects: world transformations, unions split at top level, what a node inherits from its
/// parents (spec 3, 14 and 15; spec 5a, 8.3 and 11.1), one Surface per combination in use, CSG trees for what stays
/// together.
class GeometryCompiler {
public:
    GeometryCompiler(const scene::Description& description, const Options& options, TextureCompiler& textures,
                     MediaCompiler& media, CompiledScene& out, std::vector<scene::Unsupported>& notes);

    /// Before the first: so many statements will come.
    void expect(std::size_t statements);
    /// A statement of the scene. Lights inside are collected too.
    void add(const scene::Object& object);
    /// After the last object: opacity of surfaces, then the hierarchy.
    void finish(int threads);

private:
    /// What comes down from the parents. Textures are in world space already.
    struct Inherited {
        csg::Transform to_world;  ///< of the space that the node's transformation maps into
        scene::BoxGrowth parent_growth,
            growth;  ///< of boxes turned into the world from the space of the node's parent, from its own
        PlacedTexture texture, interior_texture;
        std::shared_ptr<const scene::Interior> interior;
        std::uint32_t interior_copy = 0;  ///< interior_copy()
        std::optional<bool> hollow;
        bool no_shadow = false, no_image = false, no_reflection = false, double_illuminate = false, uv_mapping = false;
        bool no_radiosity = false;
        bool opaque_outside = false;      ///< Surface::opaque_outside
        std::optional<float> importance;  ///< Surface::importance; nothing: 1
        std::uint32_t light_group = 0;    ///< Surface::light_group
        bool global_lights = true;
        PhotonSurface photons;
        double photon_density = 0;  ///< above 0: photons are shot at it
    };

    Inherited below(const scene::Object& object, const Inherited& above);
    /// The same of an operand of what stays whole, whose own `no_shadow` has no effect (spec 3, 14).
    Inherited within(const scene::Object& operand, const Inherited& whole);
    /// An old finish keyword of a CSG object changes the interior before those of its parts do (spec 3, 8.7).
    void take_finish(const scene::Object& object, const Inherited& own);
    void add_top(const scene::Object& object, const Inherited& above);
    void add_operands(const scene::Csg& csg, const Inherited& own);
    void add_guard(const scene::Object& object, const Inherited& own);
    csg::BoundingGuard clip_guard(const scene::Object& object, const Inherited& own);
    /// Of the space that the object stands in, where `own` is its own.
    static csg::Transform parent_of(const scene::Object& object, const Inherited& own);
    static csg::Aabb placed_extent(const scene::Object& object, const Inherited& own);
    bool drops_bounds(const scene::Object& object, bool inside_csg) const;
    bool bounding_active() const;
    /// Whether POV-Ray's hierarchy never finds the object: a sphere whose radius is negative has its box inside out,
    /// unless it was made an ellipsoid (spec 5a, 5.1).
    bool lost_in_hierarchy(const scene::Object& object, const Inherited& own) const;
    /// Tells of the item that was added last what it holds without its own clips. `whole`: the item.
    void add_unclipped(csg::Tree whole);
    /// Keeps the item that was added last from holding a start of camera rays outside of POV-Ray's box of it.
    void limit_starts(const scene::Object& object, const Inherited& own);
    void must_meet(const scene::Object& object, const csg::Transform& parent, const scene::BoxGrowth& growth,
                   csg::BoundingGuard& guard);
    bool held(const scene::Object& object, const csg::Program& drawn, const csg::Program& bound);
    csg::Tree bounded(csg::Tree made, const scene::Object& operand, const Inherited& own);
    void add_alone(const scene::Object& object, Inherited own);
    /// An item that these kinds of rays see.
    void add_tree(csg::Tree whole, const scene::Object& object, const Inherited& own, std::uint8_t kinds);
    std::uint32_t add_object(const scene::Object& object, const Inherited& own);
    bool add_instance(const scene::Object& object, const Inherited& own);
    csg::Tree tree(const scene::Object& object, const Inherited& own);
    csg::Solid solid(const scene::Object& object, const Inherited& own);
    csg::Tree csg_tree(const scene::Csg& csg, const Inherited& own);
    csg::Tree cut_parts(const scene::Csg& csg, const scene::Csg& parts, const scene::Object& whole,
                        const Inherited& own, const Inherited& of_whole);
    PlacedTexture cut_texture(const scene::Object& object, const Inherited& own);
    csg::Tree clip_tree(const scene::Object& clip, const csg::Transform& to_world);
    void collect_lights(const scene::Object& object, const Inherited& above);
    /// The number of a light_group that stands there, from 1.
    std::uint32_t light_group(const scene::Object& object, const csg::Transform& to_world);
    void add_light(const scene::Object& object, const scene::Light& light, const Inherited& above);
    void drop_unseen_lights();
    void tell_decisions();

    /// `corners`: what the second and the third corner of a mesh's faces show, if another texture. `parts`: compiled
    /// textures of a shape's parts.
    csg::SurfaceId surface(const Inherited& own, const std::array<PlacedTexture, 2>& corners = {},
                           const std::vector<std::uint32_t>& parts = {});
    /// Of an object's own shape; the parts of a freeform shape may differ.
    csg::SurfaceId shape_surface(const scene::Object& object, const Inherited& own);

    /// A mesh that several objects may show, and the textures of its faces' corners (null: the object's) by slot.
    struct SharedMesh {
        std::shared_ptr<const scene::MeshData> source;
        std::shared_ptr<const csg::MeshShape> shape;
        std::vector<std::array<scene::TexturePtr, 3>> slots;
    };
    const SharedMesh& shared_mesh(const std::shared_ptr<const scene::MeshData>& mesh);
    csg::PartId mesh_part(const scene::Mesh& mesh, const Inherited& own, bool textures_stay);
    bool opaque_outside(const std::vector<std::array<PlacedTexture, 3>>& slots, const Inherited& own);
    csg::SurfaceId mesh_surface(const std::array<PlacedTexture, 3>& corners, const Inherited& own);
    std::uint32_t interior(const Inherited& own, const PlacedTexture& texture);
    PlacedTexture moved(const scene::TexturePtr& texture, const csg::Transform& to_world);
    /// As one that is written where it stands.
    scene::TexturePtr written_there(const PlacedTexture& placed);
    std::shared_ptr<const scene::Interior> moved(const std::shared_ptr<const scene::Interior>& interior,
                                                 const csg::Transform& to_world);
    /// Which copy of an interior is that of an object that stands there: each copy of an object has one of its own
    /// (spec 3, 15.6).
    std::uint32_t interior_copy(const scene::Interior& interior, const csg::Transform& to_world);
    std::uint8_t visible(const Inherited& own) const;
    void hand_down_photons(const scene::Object& object, Inherited& own);
    void aim_photons(const scene::Object& object, Inherited& own);
    std::uint32_t photon_surface(const Inherited& own);

    /// A surface of a shared object, in that object's space.
    struct SharedSurface {
        Inherited own;
        std::array<PlacedTexture, 2> corners;
    };
    /// All that tells two of them apart.
    using SharedKey = std::tuple<std::array<PlacedTexture, 4>, const scene::Interior*, std::uint32_t,
                                 std::optional<bool>, std::optional<float>, std::uint32_t>;
    /// An object that many statements show.
    struct Shared {
        std::size_t shown = 0;                                       ///< so often so far
        std::size_t solids = 0;                                      ///< of it, known from the second time on
        std::shared_ptr<const std::vector<scene::Object>> operands;  ///< keeps the address that it is known by
        std::shared_ptr<const csg::WorldData> world;                 ///< null: not made yet
        std::vector<SharedSurface> surfaces;                         ///< by the world's SurfaceId
        std::map<SharedKey, csg::SurfaceId> known;                   ///< of them
        std::uint32_t first_interior_copy = 0, interior_copies = 0;  ///< of its parts; each instance has as many
        std::size_t old_finishes = 0;                                ///< of its surfaces
        bool fails = false;                                          ///< it cannot be shared
    };
    void make_shared_world(const scene::Object& object, Shared& shared);
    csg::SurfaceId shared_surface(const Inherited& own, const std::array<PlacedTexture, 2>& corners, bool has_parts);

    const scene::Description& description_;
    const Options& options_;
    TextureCompiler& textures_;
    CompiledScene& out_;
    InteriorCompiler interiors_;
    FieldLinker fields_;
    UvUse uv_use_;

    csg::Pruning pruning_{options_.lean.takes(LeanStep::Operands)};
    csg::WorldData* world_ = &out_.geometry;  ///< where solids and items go
    Shared* sharing_ = nullptr;               ///< the shared object at hand, whose surfaces are only noted
    std::map<std::pair<const void*, int>, Shared> shared_;  ///< by operands and operation
    std::uint32_t statement_ = 0;                           ///< at hand, by number
    PlacedTexture default_texture_;                         ///< of the statement at hand
    std::uint32_t object_ = 0;                              ///< Surface::object at hand
    bool clipping_ = false;                                 ///< inside a clip: nothing is drawn, no surface is made
    /// Of the unions that the object at hand was an operand of; nested: POV-Ray keeps them whole, so it stands at no
    /// top level.
    struct OuterBounds {
        csg::BoundingGuard guard;
        csg::Aabb box;  ///< POV-Ray's, of the outermost that it keeps whole
        bool nested = false;
    };
    OuterBounds outer_bounds_;
    std::map<std::pair<const void*, std::size_t>, bool> held_;  ///< by operands and size of the bound
    bool bounds_inside_ = false;  ///< some operand of the CSG object at hand reaches beyond its own bounds
    csg::Aabb starts_;            ///< camera_starts()
    std::optional<std::uint32_t> automatic_interior_;  ///< of all that the text gives none in the statement at hand
    ByPlace<std::uint32_t> light_groups_;              ///< of the statement at hand; 0: none yet
    std::uint32_t light_group_count_ = 0;
    using SurfaceKey = std::array<std::uint32_t, 11>;
    std::map<SurfaceKey, csg::SurfaceId> known_surfaces_;
    std::map<std::vector<std::uint32_t>, std::uint32_t> known_parts_;  ///< to Surface::first_part
    ByPlace<std::monostate> places_;                                   ///< PlacedTexture::by
    std::map<PlacedTexture, scene::TexturePtr> written_;
    ByPlace<std::shared_ptr<const scene::Interior>> moved_interiors_;
    ByPlace<std::optional<std::uint32_t>> interior_copies_;  ///< of the statement at hand
    std::uint32_t interior_copy_count_ = 0;
    std::unordered_map<const scene::MeshData*, SharedMesh> meshes_;
    std::shared_ptr<PhotonPlan> photons_;  ///< null: the scene has none
    std::uint64_t split_unions_ = 0, lost_spheres_ = 0, empty_programs_ = 0, black_lights_ = 0, bounds_ = 0,
                  guards_ = 0;
};

}  // namespace plan
