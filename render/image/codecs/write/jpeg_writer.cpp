#include "render/image/codecs/write/jpeg_writer.h"

#include "render/image/codecs/shared/jpeg_errors.h"
#include "render/image/pixels/passing_failure.h"

#include <cerrno>
#include <cstring>

namespace image {
namespace {

struct JpegEncoder {
    jpeg_compress_struct state{};
    JpegErrors errors;

    JpegEncoder() { errors.take(state); }
    JpegEncoder(const JpegEncoder&) = delete;
    JpegEncoder& operator=(const JpegEncoder&) = delete;
    ~JpegEncoder() { jpeg_destroy_compress(&state); }

    /// Throws what libjpeg could not do.
    template <class Work>
    void run(Work work)
    {
        errno = 0;
        if (setjmp(errors.failed)) {
            if (errno != 0) fail_by_system(errno);
            throw FileError(errors.message.data());
        }
        work();
    }
};

class JpegWriter final : public RowSink {
public:
    JpegWriter(const std::string& path, const FileShape& shape, int quality)
        : file_(std::fopen(path.c_str(), "wb"), std::fclose), bits_(shape.bits),
          row_(static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.channels))
    {
        if (!file_) fail_by_system(errno);
        jpeg_compress_struct& state = encoder_.state;
        encoder_.run([&] {
            jpeg_create_compress(&state);
            jpeg_stdio_dest(&state, file_.get());
            state.image_width = static_cast<JDIMENSION>(shape.width);
            state.image_height = static_cast<JDIMENSION>(shape.height);
            state.input_components = shape.channels;
            state.in_color_space = shape.channels == 1 ? JCS_GRAYSCALE : JCS_RGB;
            jpeg_set_defaults(&state);
            jpeg_set_quality(&state, quality, TRUE);
            for (int c = 0; c < state.num_components; ++c)  // colours as fine as brightness
                state.comp_info[c].h_samp_factor = state.comp_info[c].v_samp_factor = 1;
            jpeg_start_compress(&state, TRUE);
            jpeg_write_marker(&state, JPEG_COM, reinterpret_cast<const JOCTET*>(shape.software),
                              static_cast<unsigned>(std::strlen(shape.software)));
        });
    }

    void put(const std::uint16_t* samples) override
    {
        for (std::size_t i = 0; i < row_.size(); ++i) row_[i] = byte_of(samples[i], bits_);
        encoder_.run([&] {
            JSAMPROW row = row_.data();
            jpeg_write_scanlines(&encoder_.state, &row, 1);
        });
    }

    void finish() override
    {
        encoder_.run([&] { jpeg_finish_compress(&encoder_.state); });
        if (std::fflush(file_.get()) != 0) fail_by_system(errno);
    }

private:
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    JpegEncoder encoder_;
    const int bits_;
    std::vector<std::uint8_t> row_;
};

}  // namespace

std::unique_ptr<RowSink> jpeg_sink(const std::string& path, const FileShape& shape, int quality)
{
    return std::make_unique<JpegWriter>(path, shape, quality);
}

}  // namespace image
