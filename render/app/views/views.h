#pragma once

#include "parser/parse.h"
#include "render/app/options/settings.h"
#include "render/plan/compiled_scene.h"

#include <optional>
#include <string>
#include <vector>

namespace app {

/// One picture of a scene with another camera.
struct SceneView {
    std::string name;  ///< that its file gets: "left", "01"
    std::string text;  ///< a camera statement: with it in the place of the scene's own the picture is the same
};

/// All views in one file.
struct SheetForm {
    int columns = 1, rows = 1;
    bool from_below = false;  ///< the first at the bottom left, the last at the top right, as light field displays want
    std::string ending;       ///< of its name, where none was asked for: "_qs8x6a0.75"
};

struct SceneViews {
    std::vector<SceneView> views;
    std::optional<SheetForm> sheet;  ///< none: a file for each
};

/// What --views asks for. Words turn the scene's own camera about the point in the middle of its picture.
/// \param camera  of the scene's text
/// \param compiled  with that camera
/// Throws OptionError for words, scene::Error for files and cameras that cannot be.
SceneViews views_of(const Settings& settings, const scene::Camera& camera, const plan::CompiledScene& compiled);

/// The camera of a view, as the grammar reads it in a scene of this version.
scene::Camera camera_of(const SceneView& view, const Settings& settings, const scene::Description& description);

/// Whether a value of --views is words, and no file.
bool is_view_words(const std::string& value);

/// What --views does not go with. Throws OptionError.
void refuse_views(const Settings& settings);

/// The name of a view's file, of the name that the picture would have alone.
std::string view_path(const std::string& picture, const SceneView& view);

}  // namespace app
