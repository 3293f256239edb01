#include "render/image/codecs/picture_libraries.h"

#include "render/image/codecs/module_path.h"

namespace image {
namespace {

const PictureLibraries& libraries()
{
    static const PictureLibraries& all =
        *reinterpret_cast<const PictureLibraries* (*)()>(module_entry(kPicturesModule, kPicturesEntry))();
    return all;
}

}  // namespace

void open_picture_libraries() { libraries(); }

Picture decode_png(const ByteList& bytes) { return libraries().png(bytes); }
Picture decode_gif(const ByteList& bytes) { return libraries().gif(bytes); }
std::optional<Picture> decode_jpeg(const ByteList& bytes) { return libraries().jpeg(bytes); }

std::unique_ptr<RowSink> jpeg_sink(const std::string& path, const FileShape& shape, int quality)
{
    return libraries().jpeg_sink(path, shape, quality);
}

}  // namespace image
