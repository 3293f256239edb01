#pragma once

#include "render/scene/effects.h"
#include "render/scene/base/line_table.h"
#include "render/scene/media.h"
#include "render/scene/base/message.h"
#include "render/scene/base/povray.h"
#include "render/scene/mesh_camera.h"
#include "render/scene/object_list.h"
#include "render/scene/rainbow.h"
#include "render/scene/textures/gamma_curve.h"
#include "render/scene/user_camera.h"

#include <optional>
#include <string>
#include <vector>

namespace scene {

/// The shape of points out of focus; null: as without it.
struct Bokeh {
    std::shared_ptr<const Pigment> pigment;
    SourceRef source;
};

struct Camera {
    enum class Kind {
        Perspective,
        Orthographic,
        Fisheye,
        UltraWideAngle,
        Omnimax,
        Panoramic,
        Cylinder,
        Spherical,
        Mesh,
        UserDefined
    };
    Kind kind = Kind::Perspective;
    int cylinder_type = 1;
    glm::dvec3 location{0}, direction{0, 0, 1}, right{4.0 / 3.0, 0, 0}, up{0, 1, 0}, sky{0, 1, 0};
    double angle_deg = 0;   ///< as written, 0 if not; direction already holds its effect for perspective
    double angle2_deg = 0;  ///< spherical: vertical
    /// Focal blur; off while aperture is 0.
    double aperture = 0, focal_distance = 0, confidence = 0.9, variance = 1.0 / 128.0;
    int blur_samples = 0, blur_fewest = 0;  ///< at most and at least, a sample of the picture
    std::shared_ptr<const MeshCamera> mesh;
    std::shared_ptr<const UserCamera> functions;
    std::optional<Normal> normal;  ///< bends the rays
    std::optional<Bokeh> bokeh;
    PovRay povray = PovRay::V37;  ///< whose rays; a plan takes it from Description::povray (spec 7d, 6)
    SourceRef source;
};

struct SkySphere {
    std::vector<Pigment> layers;
    glm::vec3 emission{1};
    csg::Transform moved;  ///< so far: of the whole sphere, so pigments that come after it are moved too
    SourceRef source;
};

struct Fog {
    int type = 1;
    double distance = 0, offset = 0, altitude = 0;
    Color color;
    Turbulence turbulence;
    double turb_depth = 0.5;
    glm::dvec3 up{0, 1, 0};
    SourceRef source;
};

/// Nothing: the text does not give it (spec 2, 10.1).
using AssumedGamma = std::optional<GammaCurve>;

struct GlobalSettings {
    AssumedGamma assumed_gamma;
    double adc_bailout = 1.0 / 255.0;
    glm::vec3 ambient_light{1};
    int max_trace_level = 5;
    int number_of_waves = 10;
    int noise_generator = 2;
    glm::vec3 irid_wavelength{0.70f, 0.52f, 0.48f};
    std::optional<RadiositySettings> radiosity;
    // Asked for by their blocks.
    std::optional<PhotonSettings> photons;
    std::optional<SubsurfaceSettings> subsurface;
    double mm_per_unit = 10;
};

/// A thing the text asks for that the renderer does not do yet: told once, never dropped in silence.
struct Unsupported {
    std::string what;
    SourceRef source;
};

/// The whole scene: everything the parser knows, immutable afterwards.
struct Description {
    std::vector<std::string> files;  ///< SourceRef::file
    std::vector<LineTable> lines;    ///< by file
    int version = 370;               ///< language version * 100 at the end of the text
    /// The version that gamma, background, layers and sky follow: `version` if the text or the command line set one,
    /// else 362 (spec 1, 15.1).
    int effective_version = 362;
    PovRay povray = PovRay::V37;      ///< V38: the main scene's #version is 3.71 or more, or --povray=3.8
    double default_importance = 1.0;  ///< `radiosity` of #default: of objects that say nothing, and of the sky
    Camera camera;
    ObjectList objects;                        ///< in order; lights among them
    TexturePtr default_texture;                ///< in force at the end
    std::vector<TexturePtr> default_textures;  ///< Object::default_texture
    Color background{0, 0, 0, 0, 1};
    bool background_given = false;
    bool background_before_37 = false;  ///< the version in force where it stands
    std::optional<SkySphere> sky_sphere;
    std::vector<Fog> fogs;
    GlobalSettings global;
    std::vector<Unsupported> unsupported;
    std::vector<Object> unsupported_objects;  ///< objects of kinds that are not drawn yet, wherever they stood
    std::vector<Media> media;                 ///< of the whole scene
    std::vector<Rainbow> rainbows;

    const TexturePtr& default_of(const Object& object) const
    {
        return object.default_texture < default_textures.size() ? default_textures[object.default_texture]
                                                                : default_texture;
    }
    LineAndColumn line_of(const SourceRef& source) const
    {
        return source.somewhere() && source.file < lines.size() ? lines[source.file].place(source.offset)
                                                                : LineAndColumn{};
    }
    /// Without a path for what stands nowhere.
    Place place(const SourceRef& source) const
    {
        const LineAndColumn at = line_of(source);
        if (at.line == 0 || source.file >= files.size()) return {};
        return {files[source.file], at};
    }
};

/// The description as text, one fact a line, defaults included: --dump=scene. The same description gives the same text.
std::string dump(const Description& description);

}  // namespace scene
