#include "render/image/indexed_picture.h"

#include "render/image/files.h"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <fstream>
#include <iterator>

namespace image {
namespace {

using ByteList = std::vector<std::uint8_t>;

/// Bytes handed to libpng, and its two structures, released together.
class PngDecoder {
public:
    explicit PngDecoder(const ByteList& bytes) : bytes_(bytes), png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, ignore))
    {
        if (png_) info_ = png_create_info_struct(png_);
        if (!info_) throw FileError("not enough memory for PNG");
    }
    PngDecoder(const PngDecoder&) = delete;
    PngDecoder& operator=(const PngDecoder&) = delete;
    ~PngDecoder() { png_destroy_read_struct(&png_, &info_, nullptr); }

    /// False if libpng failed: it leaves by longjmp, so nothing with a destructor may be made in here.
    bool decode()
    {
        if (setjmp(png_jmpbuf(png_))) return false;
        png_set_read_fn(png_, this, read);
        png_read_png(png_, info_, PNG_TRANSFORM_PACKING, nullptr);  // one byte a pixel
        return true;
    }
    png_structp png() { return png_; }
    png_infop info() { return info_; }

private:
    static void fail(png_structp png, png_const_charp) { png_longjmp(png, 1); }
    static void ignore(png_structp, png_const_charp) {}
    static void read(png_structp png, png_bytep out, std::size_t count)
    {
        auto* self = static_cast<PngDecoder*>(png_get_io_ptr(png));
        if (count > self->bytes_.size() - self->at_) png_error(png, "too short");
        std::copy_n(self->bytes_.data() + self->at_, count, out);
        self->at_ += count;
    }

    const ByteList& bytes_;
    std::size_t at_ = 0;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

bool begins(const ByteList& bytes, const char* text, std::size_t length)
{
    return bytes.size() >= length && std::equal(text, text + length, bytes.begin(), [](char c, std::uint8_t b) { return static_cast<std::uint8_t>(c) == b; });
}

/// The kind of colour stands at a fixed place of every PNG.
bool is_png_with_palette(const ByteList& bytes)
{
    constexpr std::size_t kColorType = 25;
    return begins(bytes, "\x89PNG\r\n\x1a\n", 8) && bytes.size() > kColorType && bytes[kColorType] == PNG_COLOR_TYPE_PALETTE;
}

IndexedPicture decode_png(const ByteList& bytes)
{
    PngDecoder decoder(bytes);
    if (!decoder.decode()) throw FileError("the PNG file is broken");
    IndexedPicture out;
    out.width = png_get_image_width(decoder.png(), decoder.info());
    out.height = png_get_image_height(decoder.png(), decoder.info());
    png_bytepp rows = png_get_rows(decoder.png(), decoder.info());
    for (std::uint32_t y = 0; y < out.height; ++y) out.indices.insert(out.indices.end(), rows[y], rows[y] + out.width);
    return out;
}

// Targa (Truevision TGA specification 2.0): 18 bytes, an identification, the palette, the pixels.
constexpr std::size_t kTargaHeader = 18;

bool is_targa_with_palette(const std::string& path, const ByteList& bytes)
{
    const bool named = path.ends_with(".tga") || path.ends_with(".TGA");
    return named && bytes.size() > kTargaHeader && bytes[1] == 1 && (bytes[2] == 1 || bytes[2] == 9) && bytes[16] == 8;
}

IndexedPicture decode_targa(const ByteList& bytes)
{
    const auto pair = [&](std::size_t at) { return static_cast<std::uint32_t>(bytes[at] | bytes[at + 1] << 8); };
    IndexedPicture out;
    out.width = pair(12);
    out.height = pair(14);
    const std::size_t count = std::size_t{out.width} * out.height;
    std::size_t at = kTargaHeader + bytes[0] + std::size_t{pair(5)} * ((bytes[7] + 7u) / 8u);
    const auto next = [&] {
        if (at >= bytes.size()) throw FileError("the Targa file ends too early");
        return bytes[at++];
    };
    ByteList stored;
    while (stored.size() < count) {
        if (bytes[2] == 1) {
            stored.push_back(next());
            continue;
        }
        const std::uint8_t run = next();
        const bool repeated = run & 0x80;
        std::uint8_t value = repeated ? next() : std::uint8_t{0};
        for (int i = 0; i <= (run & 0x7f); ++i) {
            if (!repeated) value = next();
            stored.push_back(value);
        }
    }
    const bool from_top = bytes[17] & 0x20, from_right = bytes[17] & 0x10;
    out.indices.resize(count);
    for (std::uint32_t y = 0; y < out.height; ++y)
        for (std::uint32_t x = 0; x < out.width; ++x)
            out.indices[std::size_t{from_top ? y : out.height - 1 - y} * out.width + (from_right ? out.width - 1 - x : x)] =
                stored[std::size_t{y} * out.width + x];
    return out;
}

}  // namespace

std::optional<IndexedPicture> read_indexed(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) throw FileError("cannot read '" + path + "'");
    const ByteList bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    try {
        if (begins(bytes, "GIF8", 4)) return decode_gif(bytes);
        if (is_png_with_palette(bytes)) return decode_png(bytes);
        if (is_targa_with_palette(path, bytes)) return decode_targa(bytes);
    } catch (const std::exception& error) {
        throw FileError("cannot read '" + path + "': " + error.what());
    }
    return std::nullopt;
}

}  // namespace image
