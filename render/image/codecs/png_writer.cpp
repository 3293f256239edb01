#include "render/image/codecs/png_writer.h"

#include "render/image/pixels/picture.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

namespace image {

namespace {

using Failure = std::array<char, 200>;  // no std::string: longjmp passes by its owner

void keep_message(png_structp png, png_const_charp message)
{
    auto* failure = static_cast<Failure*>(png_get_error_ptr(png));
    std::snprintf(failure->data(), failure->size(), "%s", message);
    png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

/// What stands before the samples.
struct PngHeader {
    png_uint_32 width, height;
    int bits, color_type;
    png_byte significant_bits;
    bool srgb;
    double gamma;
    const char* software;
};

/// Chunks are put one by one: their order is not the same in each version of libpng.
void write_header(png_structp png, png_infop info, const PngHeader& header)
{
    png_set_IHDR(png, info, header.width, header.height, header.bits, header.color_type, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    const auto put = [&](const char* name, const png_byte* data, std::size_t size) {
        png_write_chunk(png, reinterpret_cast<png_const_bytep>(name), data, size);
    };
    std::array<png_byte, 4> gamma{};
    png_save_uint_32(gamma.data(), static_cast<png_uint_32>(std::floor(100000.0 / header.gamma + 0.5)));
    put("gAMA", gamma.data(), gamma.size());
    const png_byte intent = PNG_sRGB_INTENT_PERCEPTUAL;
    if (header.srgb) put("sRGB", &intent, 1);
    std::array<png_byte, 4> significant{};
    significant.fill(header.significant_bits);
    put("sBIT", significant.data(), png_get_channels(png, info));
    constexpr std::size_t kLongest = 79;  // of text: our own name and version
    std::array<png_byte, 9 + kLongest> text{'S', 'o', 'f', 't', 'w', 'a', 'r', 'e', 0};
    const std::size_t length = std::min(std::strlen(header.software), kLongest);
    std::memcpy(text.data() + 9, header.software, length);
    put("tEXt", text.data(), 9 + length);
}

}  // namespace

/// libpng's two structures and the file, released together.
struct PngWriter::Encoder {
    Encoder() : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &failure, keep_message, ignore_warning))
    {
        if (png) info = png_create_info_struct(png);
        if (!info) throw FileError("not enough memory for PNG");
    }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;
    ~Encoder() { png_destroy_write_struct(&png, &info); }

    // False if libpng failed: it leaves by longjmp, so nothing with a destructor may be made in these three.
    bool begin(const PngHeader& header, int effort)
    {
        if (setjmp(png_jmpbuf(png))) return false;
        png_init_io(png, file.get());
        png_set_compression_level(png, effort);
        png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_NO_FILTERS);
        write_header(png, info, header);
        return true;
    }
    bool put()
    {
        if (setjmp(png_jmpbuf(png))) return false;
        png_write_row(png, row.data());
        return true;
    }
    bool end()
    {
        if (setjmp(png_jmpbuf(png))) return false;
        png_write_end(png, info);
        return true;
    }
    void check(bool done) const
    {
        if (!done) throw FileError(failure.data());
    }

    Failure failure{};
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file{nullptr, std::fclose};
    png_structp png = nullptr;
    png_infop info = nullptr;
    int bits = 8;
    std::vector<png_byte> row;  ///< as PNG stores it: one byte a sample, or two with the high one first
};

PngWriter::PngWriter(const std::string& path, const FileShape& shape, PngEffort effort)
    : encoder_(std::make_unique<Encoder>())
{
    constexpr std::array kColorTypes{PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                     PNG_COLOR_TYPE_RGB_ALPHA};
    const bool eight_bits = shape.bits <= 8;
    const PngHeader header{static_cast<png_uint_32>(shape.width),
                           static_cast<png_uint_32>(shape.height),
                           eight_bits ? 8 : 16,
                           kColorTypes.at(static_cast<std::size_t>(shape.channels - 1)),
                           static_cast<png_byte>(shape.bits),
                           shape.curve.kind == TransferCurve::Kind::Srgb,
                           static_cast<double>(shape.curve.approximate_gamma()),
                           shape.software};
    encoder_->bits = shape.bits;
    encoder_->row.resize(static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.channels) *
                         (eight_bits ? 1 : 2));
    encoder_->file.reset(std::fopen(path.c_str(), "wb"));
    if (!encoder_->file) throw FileError(std::strerror(errno));
    encoder_->check(encoder_->begin(header, static_cast<int>(effort)));
}

PngWriter::~PngWriter() = default;

void PngWriter::put(const std::uint16_t* samples)
{
    std::vector<png_byte>& row = encoder_->row;
    if (encoder_->bits == 8) {
        std::transform(samples, samples + row.size(), row.begin(),
                       [](std::uint16_t sample) { return static_cast<png_byte>(sample); });
    } else if (encoder_->bits < 8) {
        std::transform(samples, samples + row.size(), row.begin(), [this](std::uint16_t sample) {
            return static_cast<png_byte>(widened(sample, encoder_->bits) >> 8);
        });
    } else {
        for (std::size_t i = 0; i < row.size(); i += 2) {
            const std::uint16_t wide = widened(samples[i / 2], encoder_->bits);
            row[i] = static_cast<png_byte>(wide >> 8);
            row[i + 1] = static_cast<png_byte>(wide & 0xff);
        }
    }
    encoder_->check(encoder_->put());
}

void PngWriter::finish()
{
    encoder_->check(encoder_->end());
    if (std::fclose(encoder_->file.release()) != 0)
        throw FileError(std::strerror(errno));  // a full disk may show only now
}

}  // namespace image
