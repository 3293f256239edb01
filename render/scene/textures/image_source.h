#pragma once

#include "function/program.h"
#include "render/image/pixels/picture.h"
#include "render/image/levels/transfer_curve.h"
#include "render/scene/base/dump_writer.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace scene {

/// `gamma` of a picture as written: a number, srgb, bt709 or bt2020.
struct FileGamma {
    enum class Kind : std::uint8_t { Power, Srgb, Bt709, Bt2020 } kind = Kind::Power;
    double exponent = 1.0;  ///< Power only

    static constexpr std::string_view kNames[] = {"", "srgb", "bt709", "bt2020"};
    image::TransferCurve curve() const
    {
        switch (kind) {
        case Kind::Srgb: return image::TransferCurve::srgb();
        case Kind::Bt709: return image::TransferCurve::bt709();
        case Kind::Bt2020: return image::TransferCurve::bt2020();
        case Kind::Power: break;
        }
        return image::TransferCurve::power(static_cast<float>(exponent));
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
