#pragma once

#include "render/app/options/settings.h"
#include "render/image/files.h"
#include "render/scene/base/message.h"
#include "render/scene/description.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace python {

/// A picture in memory, with all that a file of it needs.
struct Picture {
    image::Image image;  ///< as the tracer left it
    app::Settings settings;
    scene::Description facts;  ///< of the scene no more than what files depend on
    image::FileSettings file;
    std::vector<scene::Message> messages;
    std::optional<image::Channels> layers;
    double seconds = 0.0;  ///< of tracing
    std::string isa;

    /// Light and levels, made when they are first asked for.
    const float* light();  ///< linear light and transmit, 4 * width * height
    int channels();        ///< of the levels
    const std::uint8_t* bytes();
    const std::uint16_t* levels();  ///< where a file has more than 8 bits
    bool deep() const { return file.encoding.bits > 8; }

    /// As the command line writes it; the type is that of the name, or where that tells none, of the options.
    void save(const std::string& path) const;

private:
    void quantise();
    std::vector<float> light_;  ///< empty: that of `image` is linear
    image::Raster raster_;
    std::vector<std::uint8_t> bytes_;
};

/// What files depend on of a description.
scene::Description file_facts(const scene::Description& description);

}  // namespace python
