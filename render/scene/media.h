#pragma once

#include "render/scene/base/dump_writer.h"
#include "render/scene/textures/texture.h"

#include <vector>

namespace scene {

/// What scatters, absorbs or emits light in a stretch of space (reference manual: Media; spec 6, 2).
struct Media {
    /// Kinds of scattering in the language's order: the phase function is constant, or leans by one of four laws.
    enum class Phase : std::uint8_t { Isotropic = 1, MieHazy, MieMurky, Rayleigh, HenyeyGreenstein };
    struct Scattering {
        Phase phase = Phase::Isotropic;
        glm::vec3 color{0};
        double eccentricity = 0.0;  ///< of HenyeyGreenstein, -1 to 1
        double extinction = 1.0;    ///< share of what is scattered that the ray loses
    };
    /// How a stretch is sampled: at random in each interval, evenly spaced, or evenly with adaptive division.
    enum class Method : std::uint8_t { Random = 1, Even, Adaptive };

    glm::vec3 absorption{0}, emission{0};  ///< per scene unit
    Scattering scattering;                 ///< black: none
    Method method = Method::Adaptive;
    int intervals = 1;
    int samples_least = 10, samples_most = 10;  ///< in an interval
    double confidence = 0.9, variance = 1.0 / 128.0;
    double ratio = 0.9;  ///< share of the intervals that lit stretches get
    int aa_level = 3;    ///< halvings of Adaptive
    double aa_threshold = 0.1;
    double jitter = 0.0;             ///< of samples, in their distance
    bool collect = true;             ///< photons
    std::vector<Pigment> densities;  ///< factors; each in the space of what holds the media
    SourceRef source;

    /// Defaults of a language version (spec 6, 2.1).
    static Media of_version(int version);
    /// A transformation written in the block, or in what holds it: moves the densities that are there.
    void transform(const csg::Transform& t);
    void dump(DumpWriter& out) const;
};

/// A declared `density`.
struct Density {
    Pigment pigment;
};

}  // namespace scene
