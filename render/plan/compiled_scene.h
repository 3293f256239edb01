#pragma once

#include "csg/base/tolerance.h"
#include "csg/world/world.h"
#include "csg/items/world_data.h"
#include "render/light/light_set.h"
#include "render/plan/lean.h"
#include "render/plan/interior.h"
#include "render/plan/media.h"
#include "render/plan/mesh_camera.h"
#include "render/plan/photons.h"
#include "render/plan/subsurface.h"
#include "render/plan/surface.h"
#include "render/plan/quality.h"
#include "render/plan/traits.h"
#include "render/scene/description.h"
#include "render/texture/sky.h"
#include "render/texture/texture_set.h"

#include <optional>
#include <string>
#include <vector>

/// From the description of a scene to what the tracer reads: flat arrays, and a list of what was kept or left out.
namespace plan {

/// How samples are added where the picture is not smooth (spec 2, 8).
struct Antialiasing {
    int method = 0;           ///< 0 off, 1, 2 or 3
    double threshold = 0.3;   ///< [0, 1]
    int depth = 3;            ///< [1, 9]
    double jitter = 1.0;      ///< [0, 1]; 0 is off
    double gamma = 2.5;       ///< Antialias_Gamma
    double confidence = 0.9;  ///< [0, 1): of method 3, that a pixel's error is within the threshold
    std::uint32_t seed = 0;   ///< of method 3: Stochastic_Seed
};

/// What the command line says about the picture.
struct Options {
    int width = 320, height = 240;
    Quality quality;     ///< +Q
    bool alpha = false;  ///< +UA: the background is transparent
    Antialiasing antialiasing;
    int start_row = 0, start_column = 0;  ///< from 0
    int end_row = -1, end_column = -1;    ///< from 0, inclusive; -1: the last
    int block_size = 32;                  ///< +BS; antialiasing depends on it as in POV-Ray
    bool split_unions = false;            ///< +SU: bounds of unions of finite parts are dropped
    bool last_bits = false;               ///< points of hits are rounded as 3.7 does; as 3.8 always, drawn as that
    bool query = false;                   ///< one object, asked by trace() or inside(): without POV-Ray's hierarchy
    bool faithful = false;                ///< POV-Ray's constants where better ones are usual (docs/faithful.md)
    bool grain_stream =
        false;  ///< crand as POV-Ray on one thread: pixels depend on those before, so for one thread alone
    bool free_sampling =
        false;           ///< camera samples are many: each asks few places of area lights and lenses, anywhere on them
    bool paths = false;  ///< for the path tracer: what takes the place of light between surfaces is left out
    LeanSteps lean;      ///< --no-lean takes none of them
    bool scalar_light =
        false;  ///< every surface goes through the lights by itself, as most do in vector lanes: tests compare the two
};

/// One decision of the compiler, for --explain: "left out 12 operands: their bounds never meet the rest".
struct Decision {
    std::string what;
    std::string why;
    std::string place;                  ///< "path:line:column"; empty: of no place
    std::optional<LeanStep> step = {};  ///< that left something out, where one did
};

/// A top-level object after splitting unions, in order of declaration.
struct ObjectInfo {
    std::uint32_t interior = kNone;  ///< index into CompiledScene::interiors
    scene::SourceRef source;
    std::uint32_t statement = 0;                       ///< that it is of: index into Description::objects
    csg::Aabb holds_starts = csg::Aabb::everything();  ///< only here does it hold the start of a camera ray
};

/// A part of an object that may hold the start of a camera ray, and what it is filled with.
struct StartHolder {
    std::uint32_t item;  ///< of the geometry
    std::uint32_t interior;
    csg::Aabb only;  ///< ObjectInfo::holds_starts
};

/// Whether the closed box holds the point.
inline bool within(const csg::Aabb& box, const glm::dvec3& point)
{
    return glm::all(glm::lessThanEqual(box.lower, point)) && glm::all(glm::lessThanEqual(point, box.upper));
}

/// Scene-wide numbers that shading reads.
struct Settings {
    int max_trace_level = 5;
    double adc_bailout = 1.0 / 255.0;
    glm::vec3 ambient_light{1};
    Quality quality;
    bool alpha = false;
    scene::AssumedGamma assumed_gamma;
};

/// Light that surfaces hand on to each other: what rays need that gather it (spec 6, section 4).
struct Radiosity {
    scene::RadiositySettings settings;
    float importance = 1;    ///< of rays that meet nothing
    light::LightSet lights;  ///< as such rays see them: area lights are points
};

/// Everything a render needs; immutable, shared by all threads.
struct CompiledScene {
    csg::Tolerance tolerance;
    csg::WorldData geometry;                   ///< ask through world()
    std::vector<Surface> surfaces;             ///< by csg::SurfaceId
    std::vector<std::uint32_t> part_textures;  ///< see Surface::first_part
    std::vector<ObjectInfo> objects;           ///< by Surface::object
    texture::TextureSet textures;
    std::vector<Interior> interiors;  ///< by Surface::interior; identity decides refraction
    light::LightSet lights;
    std::shared_ptr<const Radiosity> radiosity;  ///< null: off
    texture::Sky sky;
    std::vector<texture::Fog> fogs;
    std::vector<texture::Rainbow> rainbows;
    MediaSet media;        ///< of interiors and of the whole scene
    MediaList atmosphere;  ///< what fills the whole scene
    scene::Camera camera;
    std::shared_ptr<const MeshCamera> mesh_camera;  ///< null for other cameras
    std::uint32_t camera_normal = kNone;            ///< index into textures.normals
    /// Indices into textures.functions: a place's location, then its direction; kNone: the camera's vector.
    std::array<std::uint32_t, 6> camera_functions{kNone, kNone, kNone, kNone, kNone, kNone};
    std::uint32_t bokeh = kNone;                ///< index into textures.pigments: the shape of points out of focus
    std::shared_ptr<const PhotonPlan> photons;  ///< null: none are shot or read
    std::shared_ptr<const SubsurfacePlan> subsurface;  ///< null: finishes with `subsurface` are ordinary ones
    Settings settings;
    Options options;
    std::vector<std::uint32_t> camera_interiors;  ///< indices of interiors that hold the eye (spec 2, 4.11)
    std::vector<StartHolder>
        start_holders;   ///< what each ray of a camera whose rays start at different places may be inside of
    SceneTraits traits;  ///< of all of these
    std::vector<Decision> decisions;

    csg::World world() const { return csg::World(geometry); }
};

/// Compiles a description, large ones on so many threads; the same whatever their number. Throws std::runtime_error for
/// a scene that cannot be compiled.
CompiledScene compile(const scene::Description& description, const Options& options, int threads = 1);
/// The same; the objects are dropped as soon as they are planned, before the hierarchy wants their memory.
CompiledScene compile(scene::Description&& description, const Options& options, int threads = 1);

/// --explain: the decisions, one a line.
std::string explain(const CompiledScene& scene);

/// --dump=plan: objects, programs, surfaces, bounds and the hierarchy's figures as text.
std::string dump(const CompiledScene& scene);

}  // namespace plan
