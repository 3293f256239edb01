#pragma once

#include "render/app/options/settings.h"
#include "render/scene/description.h"

#include <glm/glm.hpp>

#include <atomic>
#include <string>

namespace app {

struct PixelAnswer {
    glm::ivec3 shown{0};  ///< levels of the picture's file, of 255
    std::string text;
};

/// Explains a pixel of the picture that the settings and the description make.
/// \param cancel  ends its tracing
PixelAnswer pixel_answer(const Settings& settings, const scene::Description& description, int x, int y,
                         const std::atomic<bool>& cancel);

}  // namespace app
