#include "render/image/codecs/io_module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace image {

class OpenPicture {
public:
    OpenPicture(std::unique_ptr<OIIO::ImageOutput> output, OIIO::TypeDesc type) : out(std::move(output)), rows(type) {}
    OIIO::Filesystem::IOVecOutput kept;  ///< of JPEG, whose library ends the process where a disk is full
    std::string path;                    ///< that it goes to; empty: `out` has the file
    const std::unique_ptr<OIIO::ImageOutput> out;
    const OIIO::TypeDesc rows;  ///< of what put() is given
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
    const bool linear_light = request.linear_light;
    const OIIO::TypeDesc stored = linear_light         ? OIIO::TypeDesc::HALF
                                  : request.eight_bits ? OIIO::TypeDesc::UINT8
                                                       : OIIO::TypeDesc::UINT16;
    OIIO::ImageSpec spec(request.width, request.height, request.channels, stored);
    const std::string format = request.format;
    if (request.channel_names != nullptr) {
        spec.set_format(OIIO::TypeDesc::FLOAT);
        spec.channelnames.assign(request.channel_names, request.channel_names + request.channels);
        const auto alpha = std::find(spec.channelnames.begin(), spec.channelnames.end(), "A");
        spec.alpha_channel = alpha == spec.channelnames.end() ? -1
                                                              : static_cast<int>(alpha - spec.channelnames.begin());
    }
    for (const char* const* text = request.attributes; text != nullptr && *text != nullptr; text += 2)
        spec.attribute(text[0], text[1]);
    if (format == "hdr") spec.set_format(OIIO::TypeDesc::FLOAT);
    if (request.channels == 2) {
        spec.channelnames = {"Y", "A"};
        spec.alpha_channel = 1;
    }
    if (!linear_light) spec.attribute("oiio:UnassociatedAlpha", 1);  // the colours are straight: store them unchanged
    if (linear_light) {
        spec.attribute("oiio:ColorSpace", "Linear");
    } else if (request.srgb) {
        spec.attribute("oiio:ColorSpace", "sRGB");
    } else {
        spec.attribute("oiio:ColorSpace", "GammaCorrected");
        spec.attribute("oiio:Gamma", request.gamma);
    }
    if (format == "targa") spec.attribute("compression", request.run_length ? "rle" : "none");
    if (format == "jpeg") {
        spec.attribute("compression", "jpeg:" + std::to_string(request.jpeg_quality));
        spec.attribute("jpeg:subsampling", "4:4:4");
    }
    if (format == "openexr") spec.attribute("compression", "zip");
    spec.attribute("Software", request.software);
    spec.attribute("DateTime", "");  // else OpenEXR files carry the time of day, and equal pictures are not equal files
    return spec;
}

const char* open_picture(const image::WriteRequest& request, image::OpenPicture*& picture)
{
    std::unique_ptr<OIIO::ImageOutput> out = OIIO::ImageOutput::create(request.format);
    if (!out) return failed(OIIO::geterror());
    const OIIO::TypeDesc rows = request.linear_light ? OIIO::TypeDesc::FLOAT
                                : request.eight_bits ? OIIO::TypeDesc::UINT8
                                                     : OIIO::TypeDesc::UINT16;
    auto opening = std::make_unique<image::OpenPicture>(std::move(out), rows);
    if (opening->out->supports("ioproxy") && std::string(request.format) == "jpeg" &&
        opening->out->set_ioproxy(&opening->kept))
        opening->path = request.path;
    if (!opening->out->open(request.path, spec_of(request))) return failed(opening->out->geterror());
    picture = opening.release();
    return nullptr;
}

const char* put_rows(image::OpenPicture& picture, int first, int count, const void* rows)
{
    const bool written = picture.out->write_scanlines(first, first + count, 0, picture.rows, rows);
    return written ? nullptr : failed(picture.out->geterror());
}

const char* close_picture(image::OpenPicture* picture)
{
    const std::unique_ptr<image::OpenPicture> ending(picture);
    if (!picture->out->close()) return failed(picture->out->geterror());
    if (picture->path.empty()) return nullptr;
    const std::vector<unsigned char>& bytes = picture->kept.buffer();
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(picture->path.c_str(), "wb"), std::fclose);
    const bool written = file && std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size() &&
                         std::fflush(file.get()) == 0;
    return written ? nullptr : failed(std::strerror(errno));
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
        [](image::OpenPicture& picture, int first, int count, const void* rows) {
            return guarded([&] { return put_rows(picture, first, count, rows); });
        },
        [](image::OpenPicture* picture) { return guarded([&] { return close_picture(picture); }); },
        [](image::OpenPicture* picture) { delete picture; },
        [](const char* path, image::ReadResult& result) { return guarded([&] { return read_picture(path, result); }); },
        release_picture};
    return &table;
}
