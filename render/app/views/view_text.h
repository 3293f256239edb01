#pragma once

#include "render/app/options/settings.h"
#include "render/app/views/views.h"
#include "render/scene/description.h"

#include <string>

namespace app {

/// The camera as a statement that gives the same vectors, to the last bit. Throws OptionError for what a statement of
/// vectors cannot say: the rays of a mesh or of functions, a normal, a bokeh.
std::string camera_statement(const scene::Camera& camera);

std::string vector_in_text(const glm::dvec3& v);

/// Views from a file of cameras. Throws scene::Error.
SceneViews views_in_file(const std::string& path, const Settings& settings);

}  // namespace app
