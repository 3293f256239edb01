#pragma once

#include "render/image/image.h"
#include "render/image/quantise.h"

#include <memory>
#include <stdexcept>
#include <string>

namespace image {

class IoLoader;

/// A picture could not be read or written; what() names the file.
struct FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// POV-Ray's letters for output file types (spec 1, 18.11).
enum class FileType : char { Png = 'N', Ppm = 'P', Targa = 'T', TargaRunLength = 'C', Jpeg = 'J', Bmp = 'B', OpenExr = 'E', RadianceHdr = 'H' };

const char* extension(FileType type);            ///< with the dot: ".png"
bool stores_alpha(FileType type);
bool stores_greyscale(FileType type);
bool stores_linear_light(FileType type);         ///< OpenEXR and Radiance: floats, no gamma, no quantisation

/// A picture file as read: 0 to 1 for integer files, straight alpha, values as stored (no gamma applied).
struct Picture {
    int width = 0, height = 0, channels = 0;
    int bits = 8;                                ///< of a sample in the file; 32 is float
    std::vector<float> samples;
    float file_gamma = 0.0f;                     ///< of its gAMA entry as decoding gamma; 0: none
    bool srgb = false;                           ///< tagged as sRGB

    const float* at(int x, int y) const
    {
        return &samples[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                        static_cast<std::size_t>(channels)];
    }
};

/// Everything that turns a traced picture into a file.
struct FileSettings {
    FileType type = FileType::Png;
    Encoding encoding;
    int jpeg_quality = 85;
};

/// Reads and writes picture files. PNG is written by libpng itself and PPM by hand; all else waits for OpenImageIO, which takes some
/// 0.2 s to load: prepare() early. The destructor does not wait for it. Copies share it.
class Files {
public:
    Files();
    /// Starts to load in the background what writing this type needs.
    void prepare(FileType type) const;
    /// Replaces `path` at once or not at all: the picture is written beside it and then renamed. Throws FileError.
    void write(const std::string& path, const Image& picture, const FileSettings& settings) const;
    /// The same for integers that are ready, tagged with the file curve.
    void write(const std::string& path, const Raster& raster, FileType type, const TransferCurve& file_curve, int jpeg_quality = 85) const;
    /// Throws FileError.
    Picture read(const std::string& path) const;

private:
    std::shared_ptr<IoLoader> loader_;
};

}  // namespace image
