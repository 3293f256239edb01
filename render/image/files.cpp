#include "render/image/files.h"

#include "render/image/direct_readers.h"
#include "render/image/io_loader.h"
#include "render/image/png_writer.h"
#include "render/image/ppm_writer.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace image {

namespace {

constexpr const char* kSoftware = "Whittle";

struct TypeFacts {
    FileType type;
    const char* extension;
    const char* format;  ///< OpenImageIO's name
    bool alpha, greyscale, linear_light, sixteen_bits;
};

constexpr TypeFacts kTypes[] = {
    {FileType::Png, ".png", "png", true, true, false, true},
    {FileType::Ppm, ".ppm", "pnm", false, true, false, true},
    {FileType::Targa, ".tga", "targa", true, false, false, false},
    {FileType::TargaRunLength, ".tga", "targa", true, false, false, false},
    {FileType::Jpeg, ".jpg", "jpeg", false, false, false, false},
    {FileType::Bmp, ".bmp", "bmp", true, false, false, false},
    {FileType::OpenExr, ".exr", "openexr", true, false, true, false},
    {FileType::RadianceHdr, ".hdr", "hdr", false, false, true, false},
};

const TypeFacts& facts(FileType type)
{
    return *std::find_if(std::begin(kTypes), std::end(kTypes), [&](const TypeFacts& f) { return f.type == type; });
}

/// A file of this process beside `path`, removed unless it was put in place.
class Replacement {
public:
    explicit Replacement(const std::string& path)
        : path_(path), beside_(path + "." + std::to_string(getpid()) + ".part")
    {
    }
    Replacement(const Replacement&) = delete;
    Replacement& operator=(const Replacement&) = delete;
    ~Replacement() { std::remove(beside_.c_str()); }
    const std::string& beside() const { return beside_; }
    void put_in_place() const
    {
        if (std::rename(beside_.c_str(), path_.c_str()) != 0) throw FileError("cannot write '" + path_ + "': " + std::strerror(errno));
    }

private:
    std::string path_, beside_;
};

/// The integers over 16 bits: shorter ones stand at the top and repeat below, so that the largest stays the largest.
/// For 8 stored bits the upper byte is what counts (spec 2, 12.4).
std::vector<std::uint16_t> widened(const Raster& raster)
{
    std::vector<std::uint16_t> wide(raster.samples.size());
    const int bits = raster.bits;
    std::transform(raster.samples.begin(), raster.samples.end(), wide.begin(), [bits](std::uint16_t value) {
        std::uint32_t filled = 0;
        for (int shift = 16 - bits; shift > -bits; shift -= bits) filled |= shift >= 0 ? std::uint32_t{value} << shift : std::uint32_t{value} >> -shift;
        return static_cast<std::uint16_t>(filled);
    });
    return wide;
}

void write_request(const IoModule& module, const std::string& path, WriteRequest request)
{
    const Replacement replacement(path);
    request.path = replacement.beside().c_str();
    request.software = kSoftware;
    if (const char* message = module.write(request)) throw FileError("cannot write '" + path + "': " + message);
    replacement.put_in_place();
}

/// Linear light, colours weighted by opacity, as OpenEXR and Radiance store it.
std::vector<float> linear_light(const Image& picture, const TransferCurve& working, bool alpha)
{
    std::vector<float> levels;
    levels.reserve(picture.pixels.size());
    for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c) levels.push_back(working.decode(picture.pixels[i + c]));
        if (alpha) levels.push_back(1.0f - picture.pixels[i + 3]);
    }
    return levels;
}

}  // namespace

const char* extension(FileType type) { return facts(type).extension; }
bool stores_alpha(FileType type) { return facts(type).alpha; }
bool stores_greyscale(FileType type) { return facts(type).greyscale; }
bool stores_linear_light(FileType type) { return facts(type).linear_light; }

Files::Files() : loader_(std::make_shared<IoLoader>()) {}

void Files::prepare(FileType type) const
{
    if (type != FileType::Png && type != FileType::Ppm) loader_->start();
}

void Files::write(const std::string& path, const Image& picture, const FileSettings& settings) const
{
    const TypeFacts& type = facts(settings.type);
    Encoding encoding = settings.encoding;
    encoding.alpha = encoding.alpha && type.alpha;
    if (!type.linear_light) {
        if (!type.sixteen_bits) encoding.bits = 8;
        if (settings.type == FileType::Jpeg) encoding.dither = Dither::None;  // it would lose the pattern
        encoding.bottom_up = settings.type == FileType::Bmp;
        return write(path, quantise(picture, encoding), settings.type, encoding.curves.file, settings.jpeg_quality);
    }
    const std::vector<float> levels = linear_light(picture, encoding.curves.working, encoding.alpha);
    WriteRequest request{};
    request.format = type.format;
    request.width = picture.width;
    request.height = picture.height;
    request.channels = encoding.alpha ? 4 : 3;
    request.levels = levels.data();
    write_request(loader_->get(), path, request);
}

void Files::write(const std::string& path, const Raster& raster, FileType type, const TransferCurve& file_curve, int jpeg_quality) const
{
    const std::vector<std::uint16_t> wide = widened(raster);
    if (type == FileType::Png || type == FileType::Ppm) {
        const Replacement replacement(path);
        try {
            if (type == FileType::Png) write_png(replacement.beside(), raster, wide, file_curve, kSoftware);
            else write_ppm(replacement.beside(), raster, kSoftware);
        } catch (const FileError& error) {
            throw FileError("cannot write '" + path + "': " + error.what());
        }
        return replacement.put_in_place();
    }
    WriteRequest request{};
    request.format = facts(type).format;
    request.width = raster.width;
    request.height = raster.height;
    request.channels = raster.channels;
    request.samples = wide.data();
    request.eight_bits = raster.bits <= 8;
    request.run_length = type == FileType::TargaRunLength;
    request.srgb = file_curve.kind == TransferCurve::Kind::Srgb;
    request.gamma = file_curve.approximate_gamma();
    request.jpeg_quality = jpeg_quality;
    write_request(loader_->get(), path, request);
}

Picture Files::read(const std::string& path) const
{
    if (auto picture = read_directly(path)) return std::move(*picture);
    const IoModule& module = loader_->get();
    ReadResult result{};
    if (const char* message = module.read(path.c_str(), result)) throw FileError("cannot read '" + path + "': " + message);
    Picture picture;
    picture.width = result.width;
    picture.height = result.height;
    picture.channels = result.channels;
    picture.bits = result.bits;
    picture.file_gamma = result.gamma;
    picture.srgb = result.srgb;
    const auto count = static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height) * static_cast<std::size_t>(result.channels);
    picture.samples.assign(result.samples, result.samples + count);
    module.release(result);
    return picture;
}

}  // namespace image
