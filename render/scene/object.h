#pragma once

#include "csg/solids/shared/outline_shape.h"
#include "csg/solids/shared/polynomial_shape.h"
#include "csg/base/types.h"
#include "render/scene/base/sealed.h"
#include "render/scene/base/shared.h"
#include "render/scene/textures/texture.h"

#include <array>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace csg {
struct FreeformShape;
}

/// Objects as the author wrote them: a tree, each node with the transformation into its parent's space.
namespace scene {

/// POV-Ray turns the boxes of some kinds of object with every statement and takes the box around each time: half its
/// edges become those of the first box times this, wider with each turn. 1 if it was never transformed.
struct BoxGrowth {
    glm::dmat3 edges{1.0};

    void add(const BoxGrowth& later) { edges = later.edges * edges; }
    static BoxGrowth of(const csg::Transform& t)
    {
        return {{glm::abs(t.linear[0]), glm::abs(t.linear[1]), glm::abs(t.linear[2])}};
    }
};

struct Sphere {
    glm::dvec3 center{0};
    double radius = 1;
};
struct Box {
    glm::dvec3 lower{0}, upper{1};
};  ///< corners sorted
/// Unit normal; inside: dot(normal, p) <= offset. moved_clips: clips were there when it was transformed; POV-Ray's box
/// of it is then that of the first clip (spec 5a, 7).
struct Plane {
    glm::dvec3 normal{0, 1, 0};
    double offset = 0;
    bool moved_clips = false;
};
struct Cylinder {
    glm::dvec3 base{0}, cap{0, 1, 0};
    double radius = 1;
    bool open = false;
};
struct Cone {
    glm::dvec3 base{0};
    double base_radius = 1;
    glm::dvec3 cap{0, 1, 0};
    double cap_radius = 0;
    bool open = false;
};
/// Axis y.
struct Torus {
    /// What the part is that a torus whose minor radius is the larger crosses itself in. Usual: as POV-Ray 3.7 draws
    /// it, whose normals of the inner sheet are not those of a union.
    enum class Spindle : std::uint8_t { Usual, Union, Merge, Difference, Intersection };
    double major = 1, minor = 0.25;
    Spindle spindle = Spindle::Usual;
};
/// A x^2 + B y^2 + C z^2 + D xy + E xz + F yz + G x + H y + I z + J <= 0: square <A,B,C>, mixed <D,E,F>, linear
/// <G,H,I>.
struct Quadric {
    glm::dvec3 square{0}, mixed{0}, linear{0};
    double constant = 0;
    /// How it came to where it is: POV-Ray's box of it depends on that.
    Shared<struct QuadricPast> past;
};  ///< rare and large: kept apart
/// A polynomial of x, y and z that is not positive.
struct Polynomial {
    std::shared_ptr<const csg::PolynomialShape> shape;
};
/// What is kept in a shape of its own kind (csg/freeform/freeform.h); the object's `written` tells how it was given.
struct Freeform {
    std::shared_ptr<const csg::FreeformShape> shape;
    /// Of the shape's parts, mixed by their shares (csg::Share), in the shape's space; null: the object's. Null or
    /// empty: it has one texture.
    std::shared_ptr<const std::vector<TexturePtr>> part_textures = nullptr;
};
struct Disc {
    glm::dvec3 center{0}, normal{0, 0, 1};
    double radius = 1, hole = 0;
};
struct Triangle {
    std::array<glm::dvec3, 3> vertex;
};
struct SmoothTriangle {
    std::array<glm::dvec3, 3> vertex, normal;  ///< of the corners
};

/// Triangles that share vertices, normals and textures; shared by every instance.
struct MeshData {
    struct Face {
        std::array<std::uint32_t, 3> vertex;
        std::array<std::uint32_t, 3> normal;  ///< equal to {kNone,...} on a flat face
        std::array<std::uint32_t, 3> uv;
        std::array<std::uint32_t, 3> texture;  ///< index into textures or kNone
    };
    static constexpr std::uint32_t kNone = 0xffffffffu;
    std::vector<glm::dvec3> vertices, normals;
    std::vector<glm::dvec2> uvs;
    std::vector<Face> faces;
    std::vector<TexturePtr> textures;
    bool has_inside_vector = false;
    glm::dvec3 inside_vector{0};
};
struct Mesh {
    std::shared_ptr<const MeshData> data;
};
/// A plane region swept along z from low to high: one character of a text, a linear prism (turned so that its z is y).
struct Extrusion {
    std::shared_ptr<const csg::OutlineShape> outline;
    double low = 0, high = 1;
    bool open = false, ends_up = false;  ///< as in csg::Extrusion
    bool bezier = false;                 ///< its extent holds the control points too
};

struct Object;
struct PhotonFlags;
struct WrittenSolid;

enum class CsgOp { Union, Intersection, Difference, Merge };
struct Csg {
    CsgOp op = CsgOp::Union;
    /// Operands in order. Shared between copies of a declared object: never changed in place once shared.
    std::shared_ptr<const std::vector<Object>> operands;
    bool split_union = true;
    bool cutaway_textures = false;
    /// A light_group: its operands are lit by the lights that are its operands too, and by those outside of all groups
    /// if global_lights is set. What stands in a group within goes by the lights of that (spec 3, 12.10).
    bool light_group = false, global_lights = false;
    bool has_inside = true;  ///< every operand has one: found out once, when it is made
    Shared<BoxGrowth> growth;
};

/// Kinds of light (spec 3, 12). Lights may stand inside a union; plan/ collects them.
struct Light {
    enum class Kind { Point, Spot, Cylinder } kind = Kind::Point;
    glm::dvec3 location{0};
    glm::vec3 color{1};
    glm::dvec3 point_at{0};
    double radius_deg = 30, falloff_deg = 45, tightness = 0;  ///< degrees for a spot; lengths for `cylinder`
    bool parallel = false, shadowless = false;
    bool directional = false;  ///< with parallel: `point_at` is where it shines to, from anywhere
    double fade_distance = 0, fade_power = 0;
    bool fades_from_start = false;  ///< made under #version 3.8: without a fade_distance the power counts alone
    bool area = false, circular = false, orient = false, jitter = false, area_illumination = false;
    glm::dvec3 axis1{0}, axis2{0};
    int size1 = 1, size2 = 1, adaptive = 0;
    bool media_interaction = true, media_attenuation = false;
    std::shared_ptr<const Object> looks_like, projected_through;
};

struct ShapeKinds {
    using variant = std::variant<Sphere, Box, Plane, Cylinder, Cone, Torus, Shared<Quadric>, Disc, Triangle,
                                 Shared<SmoothTriangle>, Mesh, Extrusion, Polynomial, Freeform, Csg, Shared<Light>>;
};
using Shape = Sealed<ShapeKinds>;

struct Flags {
    bool no_shadow : 1 = false;
    bool no_image : 1 = false;
    bool no_reflection : 1 = false;
    bool no_radiosity : 1 = false;
    bool double_illuminate : 1 = false;
    bool uv_mapping : 1 = false;
    bool unclipped_box : 1 = false;  ///< clips and bounds have no part in its extent (spec 5a, 7)
    bool textured_late : 1 = false;  ///< the texture, or a layer of it, was given after the object had moved
    std::optional<bool> hollow;
};

/// What most objects do not have: kept apart, so that a small object is small.
struct ObjectDetails {
    TexturePtr interior_texture;
    std::shared_ptr<const Interior> interior;
    std::vector<Object> clipped_by, bounded_by;
    bool bounded_by_clip = false;  ///< bounded_by { clipped_by } and the like: one set, both uses
    /// Keyword of a kind that the renderer cannot draw yet; empty for all others. Such an object stands whole, with its
    /// parameters in `written`, in Description::unsupported_objects and never in Description::objects or among the
    /// operands of a Csg.
    std::string unsupported;
    /// Parameters of a solid in scene::AnySolid; null for shapes that hold their own.
    std::shared_ptr<const WrittenSolid> written;
    std::shared_ptr<const PhotonFlags> photons;  ///< null if not written
    std::optional<double> radiosity_importance;  ///< above 0 to 1. Nothing: the parent's, at last that of #default
    /// Of a declared object with Flags::textured_late: its transformation when the top layer was given.
    std::shared_ptr<const csg::Transform> textured_at;
};

/// One object. `transform` maps the shape into the parent's space; textures, clips and bounds stand in the
/// parent's space already (a transformation written after them was applied to them too: call transform_by).
/// There may be millions: what copies have in common, they share until one of them is changed.
struct Object {
    Shape shape;
    Shared<csg::Transform> transform;
    TexturePtr texture;  ///< null: inherits from the parent, else the default texture
    Shared<ObjectDetails> details;
    SourceRef source;
    /// Of the default texture in force when the outermost statement that holds this object was added to the scene
    /// (spec 3, 15.1), the place in Description::default_textures; set on top-level objects only. What is untextured
    /// after inheritance from parents gets it.
    std::uint32_t default_texture = kNoDefault;
    Flags flags;
    bool inverse : 1 = false;
    bool forgets_inverse : 1 = false;  ///< wherever it is moved: a julia fractal of 3.7, or what holds one

    static constexpr std::uint32_t kNoDefault = 0xffffffffu;

    bool drawn() const { return details->unsupported.empty(); }
    /// A transformation written in the object's block at this point: moves shape, clips, bounds and textures present.
    void transform_by(const csg::Transform& t) { transform_by(t, BoxGrowth::of(t)); }
    /// The same of several, `t` together; `growth`: of boxes turned by one after the other.
    void transform_by(const csg::Transform& t, const BoxGrowth& growth);
};
static_assert(sizeof(Object) <= 128);
extern template struct Sealed<ShapeKinds>;

struct FirstClips {
    std::vector<Object> clips;
    csg::Transform transform;  ///< of the quadric
    BoxGrowth growth;
};

struct QuadricPast {
    /// Its clips as they stood before it was transformed with them, and its transformation until then: POV-Ray worked
    /// out its box then (spec 5a, 7.1). Null: it was not.
    std::shared_ptr<const FirstClips> first_clips;
    BoxGrowth growth;
};

inline bool is_light(const Object& object) { return std::holds_alternative<Shared<Light>>(object.shape); }
/// Null: it is none.
inline const Quadric* quadric_of(const Object& object)
{
    const auto* shared = std::get_if<Shared<Quadric>>(&object.shape);
    return shared ? &**shared : nullptr;
}

}  // namespace scene
