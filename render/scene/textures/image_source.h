#pragma once

#include "function/program.h"
#include "render/image/pixels/picture.h"
#include "render/image/levels/transfer_curve.h"
#include "render/scene/base/dump_writer.h"

#include <memory>
#include <optional>
#include <string>

namespace scene {

/// `gamma` of a picture as written: a number or srgb.
struct FileGamma {
    bool srgb = false;
    double exponent = 1.0;
    image::TransferCurve curve() const
    {
        return srgb ? image::TransferCurve::srgb() : image::TransferCurve::power(static_cast<float>(exponent));
    }
};

/// Where a picture comes from: a file, or a function over the unit square.
struct ImageSource {
    std::string_view kind;  ///< keyword of the file's kind; "file": its name tells it; "function"
    std::string path;       ///< empty: a function
    function::FunctionPtr function;
    glm::dvec2 size{0.0};  ///< of the function's picture in pixels, as written
    std::shared_ptr<const image::Picture>
        picture;  ///< null where the user reads the file its own way, as height fields do
    std::optional<FileGamma> gamma;

    bool made() const { return path.empty(); }
    void dump(DumpWriter& out) const;
};

}  // namespace scene
