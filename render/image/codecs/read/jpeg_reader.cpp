#include "render/image/codecs/read/direct_readers.h"

#include "render/image/codecs/shared/jpeg_errors.h"

#include <utility>

namespace image {
namespace {

struct JpegDecoder {
    jpeg_decompress_struct state{};
    JpegErrors errors;
    std::vector<std::uint8_t> samples;
    volatile bool ready = false;  ///< libjpeg refuses an empty source

    explicit JpegDecoder(const ByteList& bytes)
    {
        errors.take(state);
        if (setjmp(errors.failed)) return;
        jpeg_create_decompress(&state);
        jpeg_mem_src(&state, bytes.data(), static_cast<unsigned long>(bytes.size()));
        ready = true;
    }
    JpegDecoder(const JpegDecoder&) = delete;
    JpegDecoder& operator=(const JpegDecoder&) = delete;
    ~JpegDecoder() { jpeg_destroy_decompress(&state); }

    /// False if libjpeg failed: it leaves by longjmp, so nothing with a destructor may be made in here and in the next.
    bool begin()
    {
        if (!ready || setjmp(errors.failed)) return false;
        jpeg_read_header(&state, TRUE);
        return true;
    }
    /// Into `samples`, which has its size.
    bool decode()
    {
        if (setjmp(errors.failed)) return false;
        jpeg_start_decompress(&state);
        const std::size_t row = std::size_t{state.output_width} * static_cast<std::size_t>(state.output_components);
        while (state.output_scanline < state.output_height) {
            JSAMPROW at = samples.data() + state.output_scanline * row;
            jpeg_read_scanlines(&state, &at, 1);
        }
        return true;
    }
};

/// More pixels a byte than any coding of blocks gives: the sizes are not to be believed.
constexpr std::size_t kMostPixelsPerByte = 1024, kSmall = 65536;

FileError broken(const JpegDecoder& decoder)
{
    return FileError("the JPEG file is broken (" + std::string(decoder.errors.message.data()) + ")");
}

}  // namespace

std::optional<Picture> decode_jpeg(const ByteList& bytes)
{
    JpegDecoder decoder(bytes);
    if (!decoder.begin()) throw broken(decoder);
    const bool grey = decoder.state.jpeg_color_space == JCS_GRAYSCALE;
    if (!grey && decoder.state.num_components != 3) return std::nullopt;
    decoder.state.out_color_space = grey ? JCS_GRAYSCALE : JCS_RGB;
    Picture out;
    out.width = static_cast<int>(decoder.state.image_width);
    out.height = static_cast<int>(decoder.state.image_height);
    out.channels = grey ? 1 : 3;
    if (out.count() > kSmall + kMostPixelsPerByte * bytes.size())
        throw FileError("the JPEG file is broken (it ends too early)");
    decoder.samples.resize(out.count() * static_cast<std::size_t>(out.channels));
    if (!decoder.decode()) throw broken(decoder);
    out.samples = {std::move(decoder.samples), 255};
    return out;
}

}  // namespace image
