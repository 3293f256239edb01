#include "python/binding/picture.h"

#include "render/app/base/text.h"
#include "render/app/run/stage_options.h"
#include "render/image/codecs/write/row_sink.h"

#include <filesystem>

namespace python {

const float* Picture::light()
{
    const image::TransferCurve& working = file.encoding.curves.working;
    if (working == image::TransferCurve::linear()) return image.pixels.data();
    if (light_.empty()) {
        light_.assign(image.pixels.begin(), image.pixels.end());
        for (std::size_t i = 0; i < light_.size(); ++i)
            if (i % 4 != 3) light_[i] = working.decode(light_[i]);
    }
    return light_.data();
}

void Picture::quantise()
{
    if (!raster_.samples.empty()) return;
    raster_ = image::quantise(image, file.encoding);
    if (!deep()) {
        bytes_.reserve(raster_.samples.size());
        for (const std::uint16_t level : raster_.samples)
            bytes_.push_back(static_cast<std::uint8_t>(image::widened(level, raster_.bits) >> 8));
    }
}

int Picture::channels()
{
    quantise();
    return raster_.channels;
}

const std::uint8_t* Picture::bytes()
{
    quantise();
    return bytes_.data();
}

const std::uint16_t* Picture::levels()
{
    quantise();
    return raster_.samples.data();
}

void Picture::save(const std::string& path) const
{
    using image::FileType;
    const std::string ending = std::filesystem::path(path).extension().string();
    for (const FileType type : {FileType::Png, FileType::Ppm, FileType::Targa, FileType::Jpeg, FileType::Bmp,
                                FileType::OpenExr, FileType::RadianceHdr}) {
        if (!app::same_text(ending, image::extension(type)) || type == settings.file_type) continue;
        app::Settings other = settings;
        other.file_type = type;
        return image::Files().write(path, image, app::file_settings(other, facts));
    }
    image::Files().write(path, image, file);
}

scene::Description file_facts(const scene::Description& description)
{
    scene::Description facts;
    facts.global.assumed_gamma = description.global.assumed_gamma;
    facts.effective_version = description.effective_version;
    facts.povray = description.povray;
    return facts;
}

}  // namespace python
