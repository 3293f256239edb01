#pragma once

#include "render/image/files.h"
#include "render/plan/compiled_scene.h"
#include "render/picture/render.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace layers {

/// What a layer holds (docs/tools/layers.md has the channels of each).
enum class Kind { Depth, Normal, Position, Albedo, Object, Material, Uv, Time };

/// Of a list like "depth,normal"; "all" is each of them. Throws std::runtime_error for a word that is none.
std::vector<Kind> kinds_of(std::string_view list);

inline constexpr float kNothing = 1e10f;  ///< depth where the ray meets nothing

/// Names and attributes of the channels of the kinds asked for, without any values.
/// \param names of the scene's objects by ObjectInfo::statement
image::Channels layers_of(const std::vector<Kind>& kinds, const std::vector<std::string>& names);

/// Rows of a picture, which begin and end with a square of rays.
struct Rows {
    int first = 0, last = 0;
};

/// The channels of the kinds asked for, in those rows. All of it goes by the picture's own rays: the middle of each
/// pixel, and where the picture is antialiased 15 more of it.
/// Nothing where it was cancelled.
std::optional<image::Channels> make_layers(const plan::CompiledScene& scene, const std::vector<Kind>& kinds,
                                           const std::vector<std::string>& names, const trace::RenderOptions& options,
                                           bool antialiased, Rows rows);

/// Adds R, G, B and A in front of the channels.
void add_picture(image::Channels& to, const image::Image& picture, const image::TransferCurve& working);

}  // namespace layers
