#pragma once

#include "function/program.h"
#include "render/image/pixels/picture.h"
#include "render/scene/base/dump_writer.h"
#include "render/scene/textures/gamma_curve.h"

#include <memory>
#include <optional>
#include <string>

namespace scene {

/// Where a picture comes from: a file, or a function over the unit square.
struct ImageSource {
    std::string_view kind;  ///< keyword of the file's kind; "file": its name tells it; "function"
    std::string path;       ///< empty: a function
    function::FunctionPtr function;
    glm::dvec2 size{0.0};  ///< of the function's picture in pixels, as written
    std::shared_ptr<const image::Picture>
        picture;  ///< null where the user reads the file its own way, as height fields do
    std::optional<GammaCurve> gamma;
    int version = 362;  ///< the language's where it was named, in hundredths: whose rules its levels and alpha follow

    bool made() const { return path.empty(); }
    void dump(DumpWriter& out) const;
};

}  // namespace scene
