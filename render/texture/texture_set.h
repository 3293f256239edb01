#pragma once

#include "function/program.h"
#include "render/image/levels/transfer_curve.h"
#include "render/scene/base/color.h"
#include "render/scene/textures/volume.h"
#include "render/texture/image.h"
#include "render/texture/pattern.h"

#include <array>
#include <limits>
#include <memory>
#include <vector>

namespace csg {
struct FreeformShape;
class InsideIndex;
}

/// All textures of a scene as flat arrays: built once by plan/, read by every thread.
namespace texture {

/// Functions of x, y, z that are a colour's components, in their order; kNone: 0 everywhere.
using ColorFunctions = std::array<std::uint32_t, 5>;

/// What a pigment, a normal or a texture with a pattern looks its value up in.
struct Pigment {
    enum class Kind : std::uint8_t { Solid, ColorMap, PigmentMap, Average, Uv, Image, Functions } kind = Kind::Solid;
    scene::Color color;          ///< Solid
    scene::Blending blending{};  ///< ColorMap, PigmentMap
    std::uint32_t pattern = kNone;
    std::uint32_t first = 0, count = 0;  ///< entries: keys[first..], and colors (ColorMap) or children beside them
};

struct Normal {
    enum class Map : std::uint8_t { None, Normals, Slopes, Average, Uv, Image } map = Map::None;
    std::uint32_t pattern = kNone;
    double amount = 0.5, accuracy = 0.02;  ///< single precision values
    bool no_bump_scale = false;
    std::uint32_t first = 0, count = 0;  ///< keys and children (Normals, Average, Uv) or slopes
};

/// What a finish has beyond POV-Ray's words (docs/extensions.md).
struct FinishExtension {
    float gloss_exponent = 0;  ///< of the lobe around the mirrored ray; 0: a sharp mirror
    int gloss_samples = 1;
    float polished = 0;  ///< reflectance head-on; 0: none
    bool cool_warm = false;
    glm::vec3 cool{0}, warm{0};
    double ink = 0, ink_cosine = 0;  ///< width of lines in radians, 0: none; of the angle of a crease

    bool own_light() const { return polished > 0 || cool_warm; }  ///< another formula for direct light
};

/// The author's finish with albedo forms resolved and every exponent as used.
struct Finish {
    glm::vec3 ambient{0.1f}, emission{0};  ///< ambient holds the scene's ambient_light too
    float diffuse = 0.6f, diffuse_back = 0, brilliance = 1, crand = 0;
    float gathered = 0.6f, gathered_back = 0;  ///< diffuse light that comes from no lamp: without `albedo`
    float phong = 0, phong_size = 40, specular = 0, specular_exponent = 20, metallic = 0;
    glm::vec3 reflection_min{0}, reflection_max{0};
    float reflection_falloff = 1, reflection_metallic = 0;
    float reflection_power = 1;  ///< the mirrored colour is raised to it
    bool fresnel = false, conserve_energy = false;
    bool schlick = false;             ///< of fresnel: Schlick's approximation
    bool own_light = false;           ///< something of it is not shaded in lanes: an extension, or the next two
    bool tint_by_half = false;        ///< metal tints `specular` by the halfway vector's angle (spec 7d, 7)
    bool use_alpha = false;           ///< opacity dims highlights and mirroring
    bool legacy_opacity = false;      ///< of use_alpha: as in the set
    float own_fresnel = 0;            ///< share of Fresnel's law in its own light and highlights
    std::uint32_t extension = kNone;  ///< index into TextureSet::extensions
    float irid = 0, irid_thickness = 0, irid_turbulence = 0;
    /// Light goes below the surface: `diffuse` is 0 then and this is what it was, before albedo. Translucency: mm.
    bool subsurface = false;
    float subsurface_diffuse = 0;
    glm::vec3 translucency{0};

    bool lit() const { return diffuse != 0 || diffuse_back != 0 || phong != 0 || specular != 0 || subsurface; }
    /// All light of lamps that it shows is dimmed by the layer's opacity.
    bool dull() const
    {
        return diffuse_back == 0 && phong == 0 && specular == 0 && crand == 0 && irid == 0 && !own_light && !subsurface;
    }
    bool reflects() const { return reflection_min != glm::vec3(0) || reflection_max != glm::vec3(0); }
};

struct Layer {
    std::uint32_t pigment = 0, normal = kNone, finish = 0;
};

/// Either layers (the last is the top) or a pattern over other textures.
struct Texture {
    enum class Kind : std::uint8_t { Layers, Map, Average, Uv, Material } kind = Kind::Layers;
    bool opaque = true;          ///< one layer lets no light through at any place
    bool stops_light = true;     ///< casts a black shadow (spec 3, 13.2): opaque, or taken for it by POV-Ray
    bool plain = false;          ///< one layer that can neither let light through nor reflect, and has no normal
    bool lit = true;             ///< some layer asks for light sources
    bool no_bump_scale = false;  ///< its pattern's transformations leave the length of normals within alone
    std::uint32_t pattern = kNone;
    std::uint32_t first = 0, count = 0;  ///< layers, or keys and children
};

/// Fields named by the structs above. `keys`, `colors`, `children` and `slopes` share one index space per map:
/// entry i of a map has keys[i] and whichever of the others its kind uses.
/// How far warps reach, component by component: of a black hole that does not repeat its centre and the square of a
/// distance beyond which it moves nothing, of any other warp an infinite one.
struct WarpReach {
    std::vector<double> x, y, z, far;

    void add(const Warp& warp)
    {
        const auto* hole = std::get_if<scene::BlackHoleWarp>(&warp);
        const bool bounded = hole != nullptr && hole->repeat == glm::dvec3(0);
        const glm::dvec3 center = bounded ? hole->center : glm::dvec3(0);
        x.push_back(center.x), y.push_back(center.y), z.push_back(center.z);
        far.push_back(bounded ? hole_reach(*hole) : std::numeric_limits<double>::infinity());
    }
    static double hole_reach(const scene::BlackHoleWarp& hole)
    {
        constexpr double kRoundings = 1.0 + 1e-12;
        return hole.radius * hole.radius * kRoundings;
    }
};

/// What a `potential` is the field of: a blob or an isosurface, and where it stands in pattern space.
struct Potential {
    std::shared_ptr<const csg::FreeformShape> shape;
    Affine into;             ///< pattern space -> the shape's
    double threshold = 0.0;  ///< taken off where Pattern::numbers[0] is not 0
    bool inverse = false;    ///< the object has its inside out: the sign turns
};

struct TextureSet {
    std::vector<Texture> textures;
    std::vector<Layer> layers;
    std::vector<Finish> finishes;
    std::vector<FinishExtension> extensions;
    std::vector<Pigment> pigments;
    std::vector<Normal> normals;
    std::vector<Pattern> patterns;
    std::vector<Warp> warps;
    WarpReach reach;  ///< of each
    std::vector<Image> images;
    std::vector<std::shared_ptr<const scene::Volume>> volumes;
    std::vector<std::shared_ptr<const csg::InsideIndex>> objects;
    std::vector<Potential> potentials;
    std::vector<function::FunctionPtr> functions;  ///< slots of patterns and pigments filled in
    std::vector<ColorFunctions> color_functions;
    std::vector<float> keys;
    std::vector<scene::Color> colors;
    std::vector<std::uint32_t> children;
    image::TransferCurve working;  ///< colours are levels of it
    std::vector<glm::dvec2> slopes;
    /// Source points and frequencies of `ripples` and `waves` (spec 4, 2.8); number_of_waves long.
    std::vector<glm::dvec3> wave_sources;
    std::vector<double> wave_frequencies;
    glm::vec3 irid_wavelength{0.70f, 0.52f, 0.48f};
    bool legacy_opacity = false;  ///< language version below 3.7 (spec 3, 7.2)
    int noise_generator = 2;      ///< the scene's: fog, irid, crackle's `solid`
};

}  // namespace texture
