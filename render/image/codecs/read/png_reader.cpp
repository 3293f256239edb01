#include "render/image/codecs/read/direct_readers.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>
#include <utility>

namespace image {
namespace {

constexpr std::size_t kDepth = 24;  // where every PNG has the bits of a sample

/// Bytes handed to libpng, and its two structures, released together.
class PngDecoder {
public:
    explicit PngDecoder(const ByteList& bytes)
        : bytes_(bytes), png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, ignore))
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
        png_read_png(png_, info_, PNG_TRANSFORM_PACKING | PNG_TRANSFORM_SWAP_ENDIAN,
                     nullptr);  // a byte or a short a sample
        return true;
    }
    const char* message() const { return message_.data(); }
    png_structp png() { return png_; }
    png_infop info() { return info_; }

private:
    static void fail(png_structp png, png_const_charp message)
    {
        auto* self = static_cast<PngDecoder*>(png_get_error_ptr(png));
        std::snprintf(self->message_.data(), self->message_.size(), "the PNG file is broken (%s)", message);
        png_longjmp(png, 1);
    }
    static void ignore(png_structp, png_const_charp) {}
    static void read(png_structp png, png_bytep out, std::size_t count)
    {
        auto* self = static_cast<PngDecoder*>(png_get_io_ptr(png));
        if (count > self->bytes_.size() - self->at_) png_error(png, "it ends too early");
        std::copy_n(self->bytes_.data() + self->at_, count, out);
        self->at_ += count;
    }

    const ByteList& bytes_;
    std::size_t at_ = 0;
    std::array<char, 200> message_{};
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

/// The entries about the picture as a whole; tRNS says what is clear.
struct Entries {
    png_uint_32 width = 0, height = 0;
    int depth = 0, kind = 0;
    bool has_clear = false;
    png_uint_16 clear = 0;           ///< the clear level of grey files
    std::array<float, 256> alpha{};  ///< of the palette's colours
};

/// \param depth  of the file: libpng tells that of the samples it hands out
Entries entries_of(PngDecoder& decoder, int depth)
{
    Entries e;
    png_get_IHDR(decoder.png(), decoder.info(), &e.width, &e.height, nullptr, &e.kind, nullptr, nullptr, nullptr);
    e.depth = depth;
    e.alpha.fill(1.0f);
    png_bytep alpha = nullptr;
    int count = 0;
    png_color_16p clear = nullptr;
    e.has_clear = png_get_tRNS(decoder.png(), decoder.info(), &alpha, &count, &clear) != 0 &&
                  e.kind != PNG_COLOR_TYPE_RGB;  // one colour that is clear: POV-Ray draws it (spec 4, 12.10)
    if (e.has_clear && e.kind == PNG_COLOR_TYPE_PALETTE)
        std::transform(alpha, alpha + count, e.alpha.begin(),
                       [](png_byte a) { return static_cast<float>(a) / 255.0f; });
    else if (e.has_clear) e.clear = clear->gray;
    return e;
}

void take_palette(PngDecoder& decoder, const Entries& e, Picture& picture)
{
    png_colorp colors = nullptr;
    int count = 0;
    png_get_PLTE(decoder.png(), decoder.info(), &colors, &count);
    for (int i = 0; i < count; ++i) {
        for (const png_byte level : {colors[i].red, colors[i].green, colors[i].blue})
            picture.palette.push_back(static_cast<float>(level) / 255.0f);
        picture.palette.push_back(e.alpha[static_cast<std::size_t>(i)]);
    }
    png_bytepp rows = png_get_rows(decoder.png(), decoder.info());
    for (png_uint_32 y = 0; y < e.height; ++y)
        picture.indices.insert(picture.indices.end(), rows[y], rows[y] + e.width);
    finish_palette(picture);
}

/// Samples of Level's size; a clear level of grey makes a channel of alpha.
template <class Level>
void take_samples(PngDecoder& decoder, const Entries& e, Picture& picture)
{
    const int stored = png_get_channels(decoder.png(), decoder.info());
    picture.channels = stored + (e.has_clear ? 1 : 0);
    const std::uint32_t most = (1u << e.depth) - 1;
    std::vector<Level> levels;
    levels.reserve(picture.count() * static_cast<std::size_t>(picture.channels));
    png_bytepp rows = png_get_rows(decoder.png(), decoder.info());
    for (png_uint_32 y = 0; y < e.height; ++y) {
        const Level* p = reinterpret_cast<const Level*>(rows[y]);  // libpng aligns its rows
        for (png_uint_32 x = 0; x < e.width; ++x, p += stored) {
            levels.insert(levels.end(), p, p + stored);
            if (e.has_clear) levels.push_back(*p == e.clear ? Level{0} : static_cast<Level>(most));
        }
    }
    picture.samples = {std::move(levels), most};
}

std::size_t number_at(const ByteList& bytes, std::size_t at)
{
    return std::size_t{bytes[at]} << 24 | std::size_t{bytes[at + 1]} << 16 | std::size_t{bytes[at + 2]} << 8 |
           bytes[at + 3];
}

/// libpng makes room, up to 2 GB, for what a length says before it looks whether the file has so much, and for all rows
/// before it reads the first.
void check_lengths(const ByteList& bytes)
{
    constexpr std::size_t kSignature = 8, kFrame = 12, kWidth = 16,
                          kHeight = 20;                            // a chunk is its length, name, data, checksum
    constexpr std::size_t kMostPerByte = 1032, kSmallPng = 65536;  // deflate's best
    for (std::size_t at = kSignature; at < bytes.size();) {
        if (bytes.size() - at < kFrame || number_at(bytes, at) > bytes.size() - at - kFrame)
            throw FileError("the PNG file is broken (it ends too early)");
        if (number_at(bytes, at + 4) == 0x49454e44) break;  // IEND
        at += kFrame + number_at(bytes, at);
    }
    if (bytes.size() <= kDepth + 1) throw FileError("the PNG file is broken (it ends too early)");
    const std::size_t width = number_at(bytes, kWidth), height = number_at(bytes, kHeight);
    const std::uint8_t kind = bytes[kDepth + 1];
    const std::size_t samples = kind == PNG_COLOR_TYPE_RGB          ? 3
                                : kind == PNG_COLOR_TYPE_RGB_ALPHA  ? 4
                                : kind == PNG_COLOR_TYPE_GRAY_ALPHA ? 2
                                                                    : 1;
    const std::size_t bits = std::max<std::size_t>(1, bytes[kDepth] * samples),
                      most_bits = 8 * (kSmallPng + kMostPerByte * bytes.size());
    if (width > 0 && height > most_bits / bits / width)
        throw FileError("the PNG file is broken (its sizes do not fit its length)");
}

}  // namespace

Picture decode_png(const ByteList& bytes)
{
    check_lengths(bytes);
    PngDecoder decoder(bytes);
    if (!decoder.decode()) throw FileError(decoder.message());
    const Entries e = entries_of(decoder, bytes[kDepth]);
    Picture picture;
    picture.width = static_cast<int>(e.width);
    picture.height = static_cast<int>(e.height);
    picture.bits = e.depth <= 8 ? 8 : 16;
    int intent = 0;
    picture.srgb = png_get_sRGB(decoder.png(), decoder.info(), &intent) != 0;
    double gamma = 0.0;
    if (!picture.srgb && png_get_gAMA(decoder.png(), decoder.info(), &gamma) != 0 && gamma > 0.0)
        picture.file_gamma = static_cast<float>(1.0 / gamma);
    if (e.kind == PNG_COLOR_TYPE_PALETTE) take_palette(decoder, e, picture);
    else if (e.depth == 16) take_samples<png_uint_16>(decoder, e, picture);
    else take_samples<png_byte>(decoder, e, picture);
    return picture;
}

}  // namespace image
