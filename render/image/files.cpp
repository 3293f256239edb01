#include "render/image/files.h"

#include "render/image/base64.h"
#include "render/image/codecs/picture_libraries.h"
#include "render/image/codecs/write/bmp_writer.h"
#include "render/image/codecs/read/direct_readers.h"
#include "render/image/codecs/write/hdr_writer.h"
#include "render/image/file_types.h"
#include "render/image/codecs/io_loader.h"
#include "render/image/codecs/io_writer.h"
#include "render/image/channel_writer.h"
#include "render/image/picture_writer.h"
#include "render/image/codecs/write/png_writer.h"
#include "render/image/codecs/write/ppm_writer.h"
#include "render/image/codecs/write/targa_writer.h"
#include "render/image/pixels/passing_failure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace image {

namespace {

constexpr int kAnySide = 0x7fffffff, kSixteenBits = 0xffff;

constexpr TypeFacts kTypes[] = {
    {FileType::Png, ".png", true, true, false, true, kAnySide, 16},
    {FileType::Ppm, ".ppm", false, true, false, true, kAnySide, 1},
    {FileType::PpmPlain, ".ppm", false, true, false, true, kAnySide, 1},
    {FileType::Targa, ".tga", true, false, false, false, kSixteenBits, 1},
    {FileType::TargaRunLength, ".tga", true, false, false, false, kSixteenBits, 16},
    {FileType::Jpeg, ".jpg", false, false, false, false, 65500, 16},
    {FileType::Bmp, ".bmp", true, false, false, false, kAnySide, 1},
    {FileType::OpenExr, ".exr", true, false, true, false, kAnySide, 16},
    {FileType::RadianceHdr, ".hdr", false, false, true, false, kAnySide, 16},
};

/// POV-Ray takes TIFFs through a picture of 8 bits whose colours are times alpha: it rounds colours and cuts greys of
/// 16 bits (spec 4, 12.10).
void take_as_bytes(Picture& picture, bool premultiplied)
{
    const auto channels = static_cast<std::size_t>(picture.channels);
    const bool grey = channels < 3, alpha = channels == 2 || channels == 4;
    std::vector<std::uint8_t> bytes;
    bytes.reserve(picture.samples.size());
    for (std::size_t i = 0; i < picture.samples.size(); i += channels) {
        std::array<int, 4> levels{};
        for (std::size_t c = 0; c < channels; ++c) {
            const int most = picture.bits == 16 ? 65535 : 255,
                      level = static_cast<int>(std::lround(static_cast<float>(most) * picture.samples[i + c]));
            levels[c] = picture.bits != 16 ? level : grey ? level >> 8 : (level + 128) / 257;
        }
        for (std::size_t c = 0; c < channels; ++c) {
            const bool times = alpha && !premultiplied && c + 1 < channels;
            bytes.push_back(
                static_cast<std::uint8_t>(times ? (levels[c] * levels[channels - 1] + 127) / 255 : levels[c]));
        }
    }
    picture.samples = {std::move(bytes), 255};
    picture.bits = 8;
    picture.premultiplied = true;
}

}  // namespace

const TypeFacts& facts(FileType type)
{
    return *std::find_if(std::begin(kTypes), std::end(kTypes), [&](const TypeFacts& f) { return f.type == type; });
}

std::unique_ptr<RowSink> integer_sink(FileType type, const std::string& path, const FileShape& shape, int jpeg_quality,
                                      bool quick)
{
    if (is_ppm(type)) return std::make_unique<PpmWriter>(path, shape, type == FileType::PpmPlain);
    if (type == FileType::Bmp) return std::make_unique<BmpWriter>(path, shape);
    if (type == FileType::Jpeg) return jpeg_sink(path, shape, jpeg_quality);
    if (type == FileType::Targa || type == FileType::TargaRunLength)
        return std::make_unique<TargaWriter>(path, shape, type == FileType::TargaRunLength);
    return std::make_unique<PngWriter>(path, shape, quick ? PngEffort::None : PngEffort::Usual);
}

std::unique_ptr<LevelSink> level_sink(IoLoader& loader, FileType type, const std::string& path, const FileShape& shape)
{
    if (type == FileType::RadianceHdr) return std::make_unique<HdrWriter>(path, shape);
    std::vector<const char*> attributes;
    if (!shape.fingerprint.empty()) attributes.insert(attributes.end(), {kFingerprintKey, shape.fingerprint.c_str()});
    const std::string carried = shape.carried ? base64(*shape.carried) : std::string();
    if (shape.carried) attributes.insert(attributes.end(), {kCarriedKey, carried.c_str()});
    attributes.push_back(nullptr);
    WriteRequest request{};
    request.attributes = attributes.data();
    return std::make_unique<IoWriter>(loader.get(), path, shape, request);
}

const char* extension(FileType type) { return facts(type).extension; }
bool stores_alpha(FileType type) { return facts(type).alpha; }
bool stores_greyscale(FileType type) { return facts(type).greyscale; }

Files::Files() : loader_(std::make_shared<IoLoader>()) {}

void Files::prepare(FileType type) const
{
    if (type == FileType::OpenExr) loader_->start();
    if (type == FileType::Jpeg) open_picture_libraries();
}

double least_bytes(FileType type, int width, int height, const Encoding& encoding)
{
    const TypeFacts& of = facts(type);
    const int channels = (encoding.greyscale ? 1 : 3) + (encoding.alpha && of.alpha ? 1 : 0);
    const bool two_bytes = of.linear_light ? type == FileType::OpenExr : of.sixteen_bits && encoding.bits > 8;
    return static_cast<double>(width) * height * channels * (two_bytes ? 2 : 1) / of.packing;
}

int largest_side(FileType type) { return facts(type).largest_side; }

std::unique_ptr<PictureWriter> Files::start(const std::string& path, int width, int height,
                                            const FileSettings& settings) const
{
    return std::make_unique<PictureWriter>(*loader_, path, width, height, settings);
}

void Files::write(const std::string& path, const Image& picture, const FileSettings& settings) const
{
    PictureWriter writer(*loader_, path, picture.width, picture.height, settings);
    for (int i = 0; i < picture.height; ++i) writer.put(picture.at(0, writer.next_row()));
    writer.finish();
}

void Files::write(const std::string& path, const Raster& raster, FileType type, const TransferCurve& file_curve,
                  int jpeg_quality) const
{
    Replacement replacement(path);
    try {
        const FileShape shape{raster.width, raster.height, raster.channels, raster.bits, file_curve, kSoftware, {}};
        const std::unique_ptr<RowSink> sink = integer_sink(type, replacement.temporary(), shape, jpeg_quality, false);
        for (int row = 0; row < raster.height; ++row)
            sink->put(raster.at(0, type == FileType::Bmp ? raster.height - 1 - row : row));
        sink->finish();
    } catch (const FileError& error) {
        fail_named("cannot write '" + path + "': ", error);
    }
    replacement.put_in_place();
}

void Files::write_channels(const std::string& path, const Channels& channels) const
{
    const std::unique_ptr<ChannelWriter> writer = start_channels(path, channels);
    const std::size_t row = channels.names.size() * static_cast<std::size_t>(channels.width);
    for (std::size_t at = 0; at < channels.values.size(); at += row) writer->put(&channels.values[at]);
    writer->finish(false);
}

std::unique_ptr<ChannelWriter> Files::start_channels(const std::string& path, const Channels& what) const
{
    return std::make_unique<ChannelWriter>(*loader_, path, what);
}

Picture Files::read(const std::string& path) const
{
    try {
        const ByteList bytes = bytes_of_file(path);
        if (auto picture = decode_directly(path, bytes)) return std::move(*picture);
        return read_by_library(path, kind_of_file(path, bytes));
    } catch (const FileError& error) {
        fail_named("cannot read '" + path + "': ", error);
    } catch (const std::exception& error) {
        throw FileError("cannot read '" + path + "': " + error.what());
    }
}

Picture Files::read_by_library(const std::string& path, const char* kind) const
{
    const IoModule& module = loader_->get();
    ReadResult result{};
    // The library's own words name files, positions and formats that nobody asked for.
    if (module.read(path.c_str(), result) != nullptr)
        throw FileError(kind ? std::string("the ") + kind + " file is broken, or of a variant that is not known"
                             : "it is no picture of a known kind");
    Picture picture;
    picture.width = result.width;
    picture.height = result.height;
    picture.channels = result.channels;
    picture.bits = result.bits;
    picture.file_gamma = result.gamma;
    picture.srgb = result.srgb;
    const auto count = static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height) *
                       static_cast<std::size_t>(result.channels);
    picture.samples = {std::vector<float>(result.samples, result.samples + count)};
    const std::string_view named = kind ? kind : "";
    if (named == "OpenEXR") picture.premultiplied = true;
    if (named == "TIFF" && picture.bits <= 16 && picture.channels <= 4) take_as_bytes(picture, result.premultiplied);
    module.release(result);
    return picture;
}

}  // namespace image
