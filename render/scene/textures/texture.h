#pragma once

#include "csg/base/types.h"
#include "function/program.h"
#include "render/scene/base/color.h"
#include "render/scene/base/sealed.h"
#include "render/scene/base/shared.h"
#include "render/scene/base/source_ref.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// Textures as the author wrote them, defaults filled in (reference manual 3.6; spec 4).
namespace scene {

/// Raw: a value of any size stays as it is, without frequency and phase; `potential` has it unless a wave is written.
enum class WaveForm { Ramp, Sine, Triangle, Scallop, Cubic, Poly, Raw };

/// The turbulence of a pattern ("classic", applied last) or of `warp { turbulence }`.
struct Turbulence {
    glm::dvec3 amount{0.0};
    int octaves = 6;
    double lambda = 2.0, omega = 0.5;
};

struct RepeatWarp {
    glm::dvec3 width{0}, offset{0}, flip{0};
};
struct BlackHoleWarp {
    glm::dvec3 center{0};
    double radius = 1, strength = 1, falloff = 2;
    bool inverse = false;
    glm::dvec3 repeat{0}, turbulence{0};
};
struct MappingWarp {
    enum class Kind { Planar, Cylindrical, Spherical, Toroidal, Cubic } kind = Kind::Planar;
    glm::dvec3 orientation{0, 0, 1};
    double distance = 0;  ///< planar only
    double dist_exp = 0, major_radius = 1;
};

/// One step of a pattern's coordinate change.
struct WarpStepKinds {
    using variant = std::variant<csg::Transform, Turbulence, RepeatWarp, BlackHoleWarp, MappingWarp>;
};
extern template struct Sealed<WarpStepKinds>;
using WarpStep = Sealed<WarpStepKinds>;

struct ColorFunctions;
struct DensityFile;
struct ImageMap;
struct Media;
struct Object;
struct Subsurface;
struct Pigment;

/// What a pattern looks its values up in: image_map, image_pattern, bump_map, material_map; density_file; object and
/// potential; user_defined.
struct PatternDataKinds {
    using variant = std::variant<std::monostate, std::shared_ptr<const ImageMap>, std::shared_ptr<const DensityFile>,
                                 std::shared_ptr<const Object>, std::shared_ptr<const ColorFunctions>>;
};
extern template struct Sealed<PatternDataKinds>;
using PatternData = Sealed<PatternDataKinds>;

/// One entry of a catalogue: `name` is POV-Ray's keyword ("checker", "gradient", "granite", ...).
/// Parameters have fixed meanings per pattern, see docs/patterns.md.
struct Pattern {
    std::string name;
    glm::dvec3 vector{0};         ///< gradient's axis, brick size, julia's complex number, slope's direction, ...
    std::vector<double> numbers;  ///< mortar, control values, exponents, ...
    std::shared_ptr<const Pigment> pigment;  ///< pigment_pattern only
    function::FunctionPtr function;          ///< `function` only: of x, y, z
    PatternData data;
    int noise_generator = 0;  ///< 0: the scene's
    double frequency = 1, phase = 0;
    WaveForm wave = WaveForm::Ramp;
    double poly_exponent = 1;
    std::vector<WarpStep> warps;           ///< as written: a point goes through the last one first
    std::optional<Turbulence> turbulence;  ///< classic turbulence: after all warps
    SourceRef source;

    /// A transformation written after what is there: composes with a transformation at the end, else becomes the end.
    void transform(const csg::Transform& t);
};

template <class T>
struct MapEntry {
    double key = 0;
    T value;
};

using PigmentPtr = std::shared_ptr<const Pigment>;

/// How two neighbours of a map mix: `blend_mode` and `blend_gamma` (spec 7b, 9).
struct Blending {
    enum class Mode : std::uint8_t {
        Working,    ///< levels of the scene's assumed_gamma
        Linear,     ///< light
        Power,      ///< levels of blend_gamma
        Brightness  ///< light, as bright as levels of blend_gamma are
    } mode = Mode::Working;
    float gamma = 2.5f;  ///< above 0
    friend bool operator==(const Blending&, const Blending&) = default;
};

template <class T>
struct BlendMap : std::vector<MapEntry<T>> {
    using std::vector<MapEntry<T>>::vector;
    Blending blending;
};

/// color_map, pigment_map, list of colours or pigments (checker, ...: keys 0, 1, 2, ...).
using ColorMap = BlendMap<Color>;
using PigmentMap = BlendMap<PigmentPtr>;

struct PatternedPigment {
    Pattern pattern;  ///< name "average" and "uv_mapping" included
    std::variant<ColorMap, PigmentMap>
        map;  ///< defaults filled in, empty where the pattern has colours itself: image_map, user_defined
};

struct Pigment {
    std::variant<Color, Shared<PatternedPigment>> kind = Color{};
    std::optional<Color> quick_color;
    /// Of a plain colour: warps, a map and the like, without a name, that a pattern written in its place takes over.
    Shared<PatternedPigment> space;
    SourceRef source;

    /// Deep: a pigment_map's entries stay in the map's space. A plain colour keeps no note of it (move_space).
    void transform(const csg::Transform& t);
    /// A transformation of a plain colour, where the text may put a pattern in its place yet.
    void move_space(const csg::Transform& t);
};

struct Normal;
using NormalPtr = std::shared_ptr<const Normal>;
struct Normal {
    Pattern pattern;
    double amount = 0.5;  ///< bump size
    double accuracy = 0.02;
    bool no_bump_scale = false;
    std::variant<std::monostate, std::vector<MapEntry<NormalPtr>>, std::vector<MapEntry<glm::dvec2>>>
        map;  ///< normal_map, slope_map
    SourceRef source;
    void transform(const csg::Transform& t);
};

struct Reflection {
    glm::vec3 min{0}, max{0};
    bool fresnel = false;
    float falloff = 1, exponent = 1, metallic = 0;
    bool schlick = false;    ///< with fresnel: Schlick's approximation of it (docs/extensions.md, as those below)
    float gloss = 0;         ///< roughness of the mirror, as of `specular`; 0: a sharp one
    int gloss_samples = 16;  ///< rays
};

/// Defaults: spec 3, 7.1.
struct Finish {
    glm::vec3 ambient{0.1f}, emission{0};
    float diffuse = 0.6f, diffuse_back = 0, brilliance = 1, crand = 0;
    float phong = 0, phong_size = 40, specular = 0, roughness = 0.05f, metallic = 0;
    bool diffuse_albedo = false, phong_albedo = false, specular_albedo = false;
    Reflection reflection;
    bool conserve_energy = false;
    float fresnel = 0;       ///< share of Fresnel's law in its own light and highlights, 0 to 1 (spec 7b, 1)
    bool use_alpha = false;  ///< opacity dims highlights and mirroring too
    float irid = 0, irid_thickness = 0, irid_turbulence = 0;
    float polished = 0;      ///< reflectance head-on of Shirley's polished surface; 0: none
    bool cool_warm = false;  ///< Gooch: tones instead of light and shadow
    glm::vec3 cool{0}, warm{0};
    float ink = 0;                                 ///< width of lines in degrees of view; 0: none
    float ink_crease_deg = 30;                     ///< a line is drawn where normals differ by more
    bool use_radiosity = true;                     ///< reserved for later
    std::shared_ptr<const Subsurface> subsurface;  ///< null: none
    /// Legacy finish keywords, moved to the interior of the object (spec 3, 8.7); unset if negative.
    float legacy_ior = -1, legacy_caustics = -1;
    float legacy_refraction = 1;  ///< `refraction`: always moved to the interior
    SourceRef source;
};

struct Layer {
    Pigment pigment;
    NormalPtr normal;  ///< null: none
    Shared<Finish> finish;
};

struct Texture;
using TexturePtr = std::shared_ptr<const Texture>;

/// texture_map, tiles, or a list pattern of textures.
struct PatternedTexture {
    Pattern pattern;
    std::vector<MapEntry<TexturePtr>> map;
    bool no_bump_scale = false;  ///< its transformations leave the length of normals alone
};

/// Layers in the order written: the last is the top. Exactly one of the two kinds.
struct Texture {
    std::variant<std::vector<Layer>, Shared<PatternedTexture>> kind;
    SourceRef source;
    void transform(const csg::Transform& t);
    /// The same while the text may still write patterns in the place of plain colours.
    void transform_in_text(const csg::Transform& t);
    /// Whether nothing in it depends on the place: transform() changes nothing.
    bool alike_everywhere() const;
};

/// What fills an object (reference manual 3.5.8). Identity matters for refraction: compare pointers.
struct Interior {
    float ior = 0;  ///< 0: not given; then 1, and nothing disperses
    float dispersion = 1;
    int dispersion_samples = 7;
    float caustics = 0, fade_distance = 0, fade_power = 0;
    glm::vec3 fade_color{0};
    bool hollow = false;
    float refraction = 1;                             ///< legacy factor on transmitted light (spec 3, 8.7)
    std::vector<std::shared_ptr<const Media>> media;  ///< in the space that the object stands in
    SourceRef source;

    /// Moves its media.
    void transform(const csg::Transform& t);
};

}  // namespace scene
