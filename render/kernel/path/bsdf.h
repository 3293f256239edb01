#pragma once

#include "render/texture/finish.h"
#include "render/kernel/path/draws.h"

#include <array>

/// What a hit makes of light, as a sum of lobes: docs/path_tracing.md.
namespace trace::path {

/// One way in which a layer scatters light. Directions of light point away from the surface.
struct Lobe {
    enum class Kind : std::uint8_t {
        Diffuse,   ///< cosine to the power of `exponent` (brilliance), over pi
        Phong,     ///< the same of the angle with the mirrored ray
        Specular,  ///< the same of the angle of the halfway vector with the normal (Blinn)
        Mirror,    ///< all in one direction
        Through    ///< the same, behind the surface
    };
    Kind kind = Kind::Diffuse;
    glm::dvec3 normal{0};  ///< of the layer, unit; towards the side that the light comes from
    glm::vec3 color{0};    ///< of the light that it leaves
    double exponent = 1;
    glm::vec3 albedo{0};                      ///< share of the light that arrives along the ray, about
    const texture::Finish* finish = nullptr;  ///< metallic: tints highlights by `pigment`
    scene::Color pigment;

    bool delta() const { return kind >= Kind::Mirror; }
};

/// Of all lobes that are no mirrors, for light from one direction.
struct Response {
    glm::vec3 value{0};  ///< BSDF times the cosine
    double pdf = 0;      ///< of Bsdf::sample() finding this direction, by solid angle
};

/// A direction in which a path goes on.
struct Scattered {
    const Lobe* lobe = nullptr;  ///< null: it ends here
    glm::dvec3 direction{0};     ///< unit; of a mirror or what goes through: not set
    glm::vec3 weight{0};         ///< BSDF times the cosine over the chance of this direction
    double pdf = 0;              ///< by solid angle; 0: a delta lobe
};

class Bsdf {
public:
    static constexpr std::size_t kMost = 48;

    /// \param facing  the surface's normal, towards the ray
    /// \param direction  of the ray
    void begin(const glm::dvec3& facing, const glm::dvec3& direction)
    {
        count_ = 0;
        facing_ = facing;
        direction_ = direction;
    }
    void add(const Lobe& lobe)
    {
        if (count_ < kMost) lobes_[count_++] = lobe;
    }
    /// Lobes are scaled where they would return more light than there is. Then chances are found: by albedo.
    void finish();

    /// Light of all lobes together that is not of mirrors; about.
    glm::vec3 albedo() const;
    bool scatters() const { return spread_ > 0.0; }  ///< some lobe is no mirror
    Response respond(const glm::dvec3& l) const;
    glm::vec3 respond_diffuse(const glm::dvec3& l) const;  ///< Response::value without highlights
    Scattered sample(Draws& draws) const;

private:
    double chance(std::size_t i) const { return chances_[i]; }
    glm::dvec3 direction_of(const Lobe& lobe, Draws& draws) const;
    Response respond(const Lobe& lobe, const glm::dvec3& l) const;

    std::array<Lobe, kMost> lobes_;
    std::array<double, kMost> chances_{};
    std::size_t count_ = 0;
    double spread_ = 0;  ///< sum of the chances of lobes that are no mirrors
    glm::dvec3 facing_{0}, direction_{0};
};

}  // namespace trace::path
