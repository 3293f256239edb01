#include "render/image/codecs/io_module.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace image {

class OpenPicture {
public:
    explicit OpenPicture(std::unique_ptr<OIIO::ImageOutput> output) : out(std::move(output)) {}
    const std::unique_ptr<OIIO::ImageOutput> out;
};

}  // namespace image

namespace {

thread_local std::string last_message;

const char* failed(std::string message)
{
    last_message = message.empty() ? "unknown failure" : std::move(message);
    return last_message.c_str();
}

OIIO::ImageSpec spec_of(const image::WriteRequest& request)
{
    OIIO::ImageSpec spec(request.width, request.height, request.channels, OIIO::TypeDesc::HALF);
    if (request.channel_names != nullptr) {
        spec.set_format(OIIO::TypeDesc::FLOAT);
        spec.channelnames.assign(request.channel_names, request.channel_names + request.channels);
        const auto alpha = std::find(spec.channelnames.begin(), spec.channelnames.end(), "A");
        spec.alpha_channel = alpha == spec.channelnames.end() ? -1
                                                              : static_cast<int>(alpha - spec.channelnames.begin());
    }
    for (const char* const* text = request.attributes; text != nullptr && *text != nullptr; text += 2)
        spec.attribute(text[0], text[1]);
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("compression", "zip");
    spec.attribute("Software", request.software);
    spec.attribute("DateTime", "");  // else files carry the time of day, and equal pictures are not equal files
    return spec;
}

const char* open_picture(const image::WriteRequest& request, image::OpenPicture*& picture)
{
    std::unique_ptr<OIIO::ImageOutput> out = OIIO::ImageOutput::create("openexr");
    if (!out) return failed(OIIO::geterror());
    auto opening = std::make_unique<image::OpenPicture>(std::move(out));
    if (!opening->out->open(request.path, spec_of(request))) return failed(opening->out->geterror());
    picture = opening.release();
    return nullptr;
}

const char* put_rows(image::OpenPicture& picture, int first, int count, const float* rows)
{
    const bool written = picture.out->write_scanlines(first, first + count, 0, OIIO::TypeDesc::FLOAT, rows);
    return written ? nullptr : failed(picture.out->geterror());
}

const char* close_picture(image::OpenPicture* picture)
{
    const std::unique_ptr<image::OpenPicture> ending(picture);
    return picture->out->close() ? nullptr : failed(picture->out->geterror());
}

/// A header may promise any size, and room is made before the first row is read.
bool sizes_fit(const OIIO::ImageSpec& spec, const char* path)
{
    constexpr std::uintmax_t kMostPerByte = 32768,
                             kSmall = 65536;  // a white page of two colours packs best: a bit or two a row
    std::error_code error;
    const std::uintmax_t length = std::filesystem::file_size(path, error);
    return error || spec.image_bytes() <= kSmall + kMostPerByte * length;
}

const char* read_picture(const char* path, image::ReadResult& result)
{
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);  // do not multiply colours by alpha
    const std::unique_ptr<OIIO::ImageInput> in = OIIO::ImageInput::open(path, &hints);
    if (!in) return failed(OIIO::geterror());
    const OIIO::ImageSpec& spec = in->spec();
    if (!sizes_fit(spec, path)) return failed("its sizes do not fit its length");
    const auto count = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) *
                       static_cast<std::size_t>(spec.nchannels);
    auto samples = std::make_unique<float[]>(count);
    if (!in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, samples.get())) return failed(in->geterror());
    const std::string space = spec.get_string_attribute("oiio:ColorSpace");
    result = {spec.width,        spec.height,
              spec.nchannels,    spec.format.is_floating_point() ? 32 : static_cast<int>(8 * spec.format.size()),
              samples.release(), spec.get_float_attribute("oiio:Gamma", 0.0f),
              space == "sRGB",   spec.alpha_channel >= 0 && spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0};
    return nullptr;
}

void release_picture(image::ReadResult& result)
{
    delete[] result.samples;
    result.samples = nullptr;
}

/// No exception leaves the module.
template <class Work>
const char* guarded(Work work)
{
    try {
        return work();
    } catch (const std::exception& error) {
        return failed(error.what());
    }
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const image::IoModule* whittle_image_io()
{
    static const image::IoModule table{
        [](const image::WriteRequest& request, image::OpenPicture*& picture) {
            return guarded([&] { return open_picture(request, picture); });
        },
        [](image::OpenPicture& picture, int first, int count, const float* rows) {
            return guarded([&] { return put_rows(picture, first, count, rows); });
        },
        [](image::OpenPicture* picture) { return guarded([&] { return close_picture(picture); }); },
        [](image::OpenPicture* picture) { delete picture; },
        [](const char* path, image::ReadResult& result) { return guarded([&] { return read_picture(path, result); }); },
        release_picture};
    return &table;
}
