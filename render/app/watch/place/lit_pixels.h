#pragma once

#include "language/names/document.h"
#include "render/app/options/settings.h"
#include "render/scene/description.h"

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

namespace app {

/// What each pixel of a picture sees first: which statement of the scene, and where.
class SeenPixels {
public:
    /// \param cancel  leaves it without any; outlives the call alone
    SeenPixels(const Settings& settings, const scene::Description& scene, const std::atomic<bool>& cancel);

    int width() const { return width_; }
    int height() const { return height_; }
    /// Index into Description::objects; nothing: the ray meets nothing.
    std::optional<std::size_t> statement(int x, int y) const;
    glm::dvec3 point(int x, int y) const;

private:
    int width_, height_;
    std::vector<float> statements_, points_;  ///< statement + 1; three a pixel
};

/// Pixels that see something, row by row, in squares of `step`.
struct LitPixels {
    int step = 1, width = 0, height = 0;
    std::vector<int> runs;  ///< lengths: so many not, so many, so many not ...
    language::Range statement;
    bool whole = false;  ///< a solid has so many parts that all of it was taken
};

/// Those that see what the innermost of some statements makes that makes a solid; nothing where none does.
/// \param file  index into Description::files
/// \param statements  bytes of it, the innermost first
std::optional<LitPixels> lit_pixels(const SeenPixels& seen, const scene::Description& scene, std::size_t file,
                                    const std::vector<language::Range>& statements);

/// The part of a solid that a pixel sees: the innermost statement of its own.
std::optional<scene::Place> place_seen(const SeenPixels& seen, const scene::Description& scene, int x, int y);

}  // namespace app
