#pragma once

#include "render/scene/base/color.h"
#include "render/scene/base/dump_writer.h"
#include "render/scene/base/source_ref.h"

#include <optional>
#include <string>

/// Settings of light that is not direct: radiosity, photons, light below surfaces (reference manual: Global Settings;
/// spec 6).
namespace scene {

/// `radiosity` of global_settings (spec 6, 4.1).
struct RadiositySettings {
    double pretrace_start = 0.08, pretrace_end = 0.04;  ///< block sizes, shares of the picture
    double brightness = 1.0, gray_threshold = 0.0;      ///< threshold: 0 to 1, share of grey in gathered light
    int count = 35;                                     ///< rays of a sample
    int pool = 0;                                      ///< directions to choose from; 0: 1600, or count if that is more
    double error_bound = 1.8, low_error_factor = 0.5;  ///< factor: of error_bound in the pretrace
    int nearest_count = 5, adaptive_count = 0;  ///< samples to mix; adaptive: pretrace goes on until there are so many
    int recursion_limit = 2;                    ///< bounces, 1 to 20
    double minimum_reuse = 0.015,
           maximum_reuse = 0.2;  ///< a sample's reach, shares of the picture; minimum below maximum
    double adc_bailout = 0.01;
    double max_sample = -1.0;  ///< brightest gathered colour; below 0: no limit
    bool normal = false, media = false, subsurface = false, always_sample = false;
    SourceRef source;

    int pool_size() const { return pool > 0 ? pool : count > 1600 ? count : 1600; }
    void dump(DumpWriter& out) const;
};

/// `photons` of global_settings (spec 6, 3.1).
struct PhotonSettings {
    double spacing = 1.0;                      ///< scene units between photons on a target
    double count = 0.0;                        ///< photons to aim at, sets the spacing; 0: by spacing
    int gather_least = 20, gather_most = 100;  ///< photons of a point; most 0: none at all
    /// Gathering radius on surfaces and in media, scene units; not above 0: found out. Multipliers of it.
    double radius = 0.0, radius_factor = 1.0, media_radius = 0.0, media_radius_factor = 1.0;
    int media_steps = 0;  ///< photons left in media on each interval; 0: none
    double media_factor = 1.0;
    double jitter = 0.4;
    double autostop = 0.5;  ///< share of a target's outer ring without hits that ends shooting
    double expand_increase = 0.2, expand_least = 35.0;  ///< expand_thresholds
    std::optional<int> max_trace_level;                 ///< nothing: the scene's
    std::optional<double> adc_bailout;                  ///< nothing: the scene's
    std::string load_file, save_file;                   ///< of the map; empty: none
    SourceRef source;

    /// Whether photons are shot or read: POV-Ray leaves them out without a word where there is nothing to shoot by.
    bool active() const { return gather_most > 0 && (!load_file.empty() || spacing > 0.0 || count > 0.0); }

    void dump(DumpWriter& out) const;
};

/// `subsurface` of global_settings (spec 6, 5.1); without it finishes with subsurface are ordinary.
struct SubsurfaceSettings {
    int diffuse_samples = 50, single_samples = 50;
    bool radiosity = false;
    SourceRef source;

    void dump(DumpWriter& out) const;
};

/// `photons` of an object or a light.
struct PhotonFlags {
    bool of_light = false;
    std::optional<double> target;                ///< an object's density of photons; nothing or 0: no target
    std::optional<bool> reflection, refraction;  ///< nothing: as the other side, light or object, says
    bool collect = true, pass_through = false;   ///< objects
    bool area_light = false;                     ///< lights: shot from all of its area
    SourceRef source;

    void dump(DumpWriter& out) const;
};

/// `subsurface` of a finish.
struct Subsurface {
    glm::vec3 translucency{0};  ///< mm, the way that light goes on average
    glm::vec3 anisotropy{0};    ///< read, of no effect in POV-Ray
    SourceRef source;

    void dump(DumpWriter& out) const;
};

}  // namespace scene
