#pragma once

#include "render/image/pixels/image.h"
#include "render/image/pixels/picture.h"
#include "render/image/levels/quantise.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace image {

class IoLoader;
class PictureWriter;
class ChannelWriter;

/// POV-Ray's letters for output file types (spec 1, 18.11).
enum class FileType : char {
    Png = 'N',
    Ppm = 'P',
    PpmPlain = 'A',  ///< numbers as text (3.8's Compression=0)
    Targa = 'T',
    TargaRunLength = 'C',
    Jpeg = 'J',
    Bmp = 'B',
    OpenExr = 'E',
    RadianceHdr = 'H'
};

constexpr bool is_ppm(FileType type) { return type == FileType::Ppm || type == FileType::PpmPlain; }
const char* extension(FileType type);  ///< with the dot: ".png"
bool stores_alpha(FileType type);
bool stores_greyscale(FileType type);

/// Bytes that a file of this type takes at least, going by what the type packs: few pictures get smaller.
double least_bytes(FileType type, int width, int height, const Encoding& encoding);
int largest_side(FileType type);  ///< in pixels, that its header can hold

/// Everything that turns a traced picture into a file.
struct FileSettings {
    FileType type = FileType::Png;
    Encoding encoding;
    int jpeg_quality = 85;
    bool quick = false;  ///< PNG: not compressed, for a picture that nobody keeps
    /// Of what the picture is made from, kept in files of PNG and OpenEXR; empty: not known, or not all of it is there.
    std::string fingerprint = {};
    /// What the picture is made of, packed; kept in files of PNG (a chunk) and OpenEXR (an attribute). Null: nothing.
    std::shared_ptr<const std::string> carried = {};
    bool lasting = false;  ///< on the disk before it has its name, whatever the file system makes of that
};

/// Values of any meaning by pixel, for an OpenEXR file: 32-bit floats, interleaved, top row first.
struct Channels {
    int width = 0, height = 0;
    int top = 0;                     ///< the first row that is here
    std::vector<std::string> names;  ///< "layer.X"
    std::vector<float> values;       ///< names.size() * width for each row that is here
    std::vector<std::pair<std::string, std::string>> attributes;
};

/// Reads and writes picture files. PNG and PPM are written by hand, direct_readers.h says what
/// is read without OpenImageIO; all else waits for that library, which takes some 0.2 s to load: prepare() early. The
/// destructor does not wait for it. Copies share it.
class Files {
public:
    Files();
    /// Loads what writing this type needs, or begins to in the background. Throws FileError where that is missing.
    void prepare(FileType type) const;
    /// A picture of this size that comes row by row. Throws FileError, as its methods do.
    std::unique_ptr<PictureWriter> start(const std::string& path, int width, int height,
                                         const FileSettings& settings) const;
    /// Replaces `path` at once or not at all: the picture is written beside it and then renamed. Throws FileError.
    void write(const std::string& path, const Image& picture, const FileSettings& settings) const;
    /// The same for integers that are ready, tagged with the file curve.
    void write(const std::string& path, const Raster& raster, FileType type, const TransferCurve& file_curve,
               int jpeg_quality = 85) const;
    /// An OpenEXR file of many channels. Throws FileError.
    void write_channels(const std::string& path, const Channels& channels) const;
    /// The same whose rows come one by one; `what` has no values.
    std::unique_ptr<ChannelWriter> start_channels(const std::string& path, const Channels& what) const;
    /// Throws FileError.
    Picture read(const std::string& path) const;

private:
    Picture read_by_library(const std::string& path, const char* kind) const;

    std::shared_ptr<IoLoader> loader_;
};

}  // namespace image
