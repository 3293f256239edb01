#pragma once

#include "render/image/pixels/picture.h"
#include "render/scene/base/color.h"
#include "render/texture/points/points.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

/// A picture as a function of a point: image_map, image_pattern, bump_map and material_map (spec 4, section 12).
namespace texture {

/// Settings resolved, colours decoded as they are looked up: a picture stays as its file has it. Built once by plan/.
struct Image {
    enum class Projection : std::uint8_t {
        Planar,
        Spherical,
        Cylindrical,
        Torus,
        Angular
    } projection = Projection::Planar;
    enum class Interpolation : std::uint8_t {
        None,
        Bilinear,
        Bicubic,
        NormalizedDistance
    } interpolation = Interpolation::None;
    bool once = false;           ///< nothing outside the picture
    bool by_place = false;       ///< `use_index` of a picture with a palette
    bool premultiplied = false;  ///< colours of a pigment are divided by their alpha
    enum class Value : std::uint8_t { Grey, Red, Transmit } value = Value::Grey;  ///< what image_pattern shows
    bool opaque = true;                          ///< no texel lets light through, and the picture covers everything
    bool clear_in_file = false;                  ///< not opaque by its file and by `transmit` of its palette
    std::uint32_t width = 0, height = 0;         ///< texels, not 0
    glm::dvec2 repeat{1.0}, offset{0.0};         ///< in pictures
    float filter = 0;                            ///< of every texel without a palette
    std::vector<float> transmit;                 ///< added to that of every texel without a palette, in order
    float faded_filter = 0, faded_transmit = 0;  ///< the same in POV-Ray 3.8: what a texel lets be seen is cut by them

    std::shared_ptr<const image::Picture> picture;  ///< top row first
    std::vector<float> levels;                      ///< what each level of its samples shows; none: what it stands for
    image::Samples decoded;                         ///< in place of its samples, unless empty
    std::vector<scene::Color> palette;              ///< of a picture that has one

    const image::Samples& samples() const { return decoded.size() != 0 ? decoded : picture->samples; }
    std::size_t place(std::size_t texel) const { return picture->indices[texel]; }  ///< in the palette
};

/// Column and row of a point of pattern space, from the top left corner, in texels; false where the picture is not.
bool image_place(const Image& image, const glm::dvec3& p, glm::dvec2& place);

/// Whether some texel or colour of the palette lets light through, whatever the settings of the image_map.
bool image_is_clear(const Image& image);

/// What an image_map shows at a point of pattern space: straight colours, or nothing where the picture is not.
scene::Color image_shown(const Image& image, const glm::dvec3& p);

/// Of an interpolated place the place in the palette; without one 255 times red. Truncated.
int image_index(const Image& image, const glm::dvec2& place);

/// Value of image_pattern, 0 to 1 (spec 4, 12.7).
double image_value(const Image& image, const glm::dvec3& p);

/// `n` bent by the picture as heights; unchanged where the picture is not (spec 4, 15.5).
glm::dvec3 image_bump(const Image& image, double size, const glm::dvec3& n, const glm::dvec3& p);

/// The same of many points. Padded.
void images_shown(const Image& image, const Points& p, ColorPoints& out);
void image_values(const Image& image, const Points& p, Values& out);
void image_bumps(const Image& image, double size, const Points& p, Points& n);

}  // namespace texture
