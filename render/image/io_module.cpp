#include "render/image/io_module.h"

#include <OpenImageIO/imageio.h>

#include <memory>
#include <string>
#include <vector>

namespace {

thread_local std::string last_message;

const char* failed(std::string message)
{
    last_message = message.empty() ? "unknown failure" : std::move(message);
    return last_message.c_str();
}

OIIO::ImageSpec spec_of(const image::WriteRequest& request)
{
    const bool linear_light = request.levels != nullptr;
    const OIIO::TypeDesc stored = linear_light ? OIIO::TypeDesc::HALF : request.eight_bits ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16;
    OIIO::ImageSpec spec(request.width, request.height, request.channels, stored);
    const std::string format = request.format;
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

const char* write_picture(const image::WriteRequest& request)
{
    const std::unique_ptr<OIIO::ImageOutput> out = OIIO::ImageOutput::create(request.format);
    if (!out) return failed(OIIO::geterror());
    if (!out->open(request.path, spec_of(request))) return failed(out->geterror());
    bool written = false;
    if (request.levels) {
        written = out->write_image(OIIO::TypeDesc::FLOAT, request.levels);
    } else if (request.eight_bits) {
        const auto count = static_cast<std::size_t>(request.width) * static_cast<std::size_t>(request.height) * static_cast<std::size_t>(request.channels);
        std::vector<std::uint8_t> bytes(count);
        for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::uint8_t>(request.samples[i] >> 8);
        written = out->write_image(OIIO::TypeDesc::UINT8, bytes.data());
    } else {
        written = out->write_image(OIIO::TypeDesc::UINT16, request.samples);
    }
    if (!written) return failed(out->geterror());
    if (!out->close()) return failed(out->geterror());
    return nullptr;
}

const char* read_picture(const char* path, image::ReadResult& result)
{
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);  // do not multiply colours by alpha
    const std::unique_ptr<OIIO::ImageInput> in = OIIO::ImageInput::open(path, &hints);
    if (!in) return failed(OIIO::geterror());
    const OIIO::ImageSpec& spec = in->spec();
    const auto count = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) * static_cast<std::size_t>(spec.nchannels);
    auto samples = std::make_unique<float[]>(count);
    if (!in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, samples.get())) return failed(in->geterror());
    const std::string space = spec.get_string_attribute("oiio:ColorSpace");
    result = {spec.width, spec.height, spec.nchannels, spec.format.is_floating_point() ? 32 : static_cast<int>(8 * spec.format.size()),
              samples.release(), spec.get_float_attribute("oiio:Gamma", 0.0f), space == "sRGB"};
    return nullptr;
}

void release_picture(image::ReadResult& result)
{
    delete[] result.samples;
    result.samples = nullptr;
}

/// No exception leaves the module.
template <class Work> const char* guarded(Work work)
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
        [](const image::WriteRequest& request) { return guarded([&] { return write_picture(request); }); },
        [](const char* path, image::ReadResult& result) { return guarded([&] { return read_picture(path, result); }); },
        release_picture};
    return &table;
}
