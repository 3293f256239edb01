#include "render/image/png_writer.h"

#include "render/image/files.h"

#include <png.h>

#include <array>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>

namespace image {

namespace {

/// zlib's effort. A picture of 800x600 took 57 ms to write with 2, 176 ms with zlib's usual 6, and was 15 % larger.
constexpr int kEffort = 2;

struct Failure {
    std::array<char, 200> text{};  // no std::string: longjmp passes by its owner
};

void keep_message(png_structp png, png_const_charp message)
{
    auto* failure = static_cast<Failure*>(png_get_error_ptr(png));
    std::snprintf(failure->text.data(), failure->text.size(), "%s", message);
    png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

/// libpng's two structures, released together.
class Encoder {
public:
    Encoder() : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &failure_, keep_message, ignore_warning))
    {
        if (png_) info_ = png_create_info_struct(png_);
        if (!info_) throw FileError("not enough memory for PNG");
    }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;
    ~Encoder() { png_destroy_write_struct(&png_, &info_); }
    png_structp png() { return png_; }
    png_infop info() { return info_; }
    const char* message() const { return failure_.text.data(); }

private:
    Failure failure_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

/// What stands before the samples.
struct Header {
    png_uint_32 width, height;
    int bits, color_type;
    png_byte significant_bits;
    bool srgb;
    double gamma;
    const char* software;
};

void write_header(png_structp png, png_infop info, const Header& header)
{
    png_set_IHDR(png, info, header.width, header.height, header.bits, header.color_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_gAMA(png, info, 1.0 / header.gamma);
    if (header.srgb) png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    const png_byte significant = header.significant_bits;
    const png_color_8 bits{significant, significant, significant, significant, significant};
    png_set_sBIT(png, info, &bits);
    png_text text{};
    std::array<char, 9> key{"Software"};
    text.compression = PNG_TEXT_COMPRESSION_NONE;
    text.key = key.data();
    text.text = const_cast<char*>(header.software);  // libpng copies it
    png_set_text(png, info, &text, 1);
    png_write_info(png, info);
}

/// The samples as PNG stores them: one byte, or two with the high one first.
std::vector<png_byte> stored(const std::vector<std::uint16_t>& wide, bool eight_bits)
{
    std::vector<png_byte> bytes;
    bytes.reserve(eight_bits ? wide.size() : 2 * wide.size());
    for (const std::uint16_t sample : wide) {
        bytes.push_back(static_cast<png_byte>(sample >> 8));
        if (!eight_bits) bytes.push_back(static_cast<png_byte>(sample & 0xff));
    }
    return bytes;
}

/// False if libpng failed: it leaves by longjmp, so nothing with a destructor may be made in here.
bool encode(Encoder& encoder, std::FILE* file, const Header& header, const png_byte* samples, std::size_t row_bytes)
{
    png_structp png = encoder.png();
    if (setjmp(png_jmpbuf(png))) return false;
    png_init_io(png, file);
    png_set_compression_level(png, kEffort);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_NO_FILTERS);
    write_header(png, encoder.info(), header);
    for (png_uint_32 row = 0; row < header.height; ++row) png_write_row(png, samples + row * row_bytes);
    png_write_end(png, encoder.info());
    return true;
}

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

void write_png(const std::string& path, const Raster& raster, const std::vector<std::uint16_t>& wide, const TransferCurve& file_curve,
               const char* software)
{
    constexpr std::array kColorTypes{PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGB_ALPHA};
    const bool eight_bits = raster.bits <= 8;
    const Header header{static_cast<png_uint_32>(raster.width), static_cast<png_uint_32>(raster.height), eight_bits ? 8 : 16,
                        kColorTypes.at(static_cast<std::size_t>(raster.channels - 1)), static_cast<png_byte>(raster.bits),
                        file_curve.kind == TransferCurve::Kind::Srgb, static_cast<double>(file_curve.approximate_gamma()), software};
    const std::vector<png_byte> samples = stored(wide, eight_bits);
    const std::size_t row_bytes = static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.channels) * (eight_bits ? 1 : 2);

    std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "wb"));
    if (!file) throw FileError(std::strerror(errno));
    Encoder encoder;
    if (!encode(encoder, file.get(), header, samples.data(), row_bytes)) throw FileError(encoder.message());
    if (std::fclose(file.release()) != 0) throw FileError(std::strerror(errno));  // a full disk may show only now
}

}  // namespace image
