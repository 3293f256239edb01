#include "render/image/codecs/library_readers.h"

#include "render/image/codecs/module_path.h"

namespace image {
namespace {

const LibraryReaders& readers()
{
    static const LibraryReaders& all =
        *reinterpret_cast<const LibraryReaders* (*)()>(module_entry(kReadersModule, kReadersEntry))();
    return all;
}

}  // namespace

Picture decode_png(const ByteList& bytes) { return readers().png(bytes); }
Picture decode_gif(const ByteList& bytes) { return readers().gif(bytes); }
std::optional<Picture> decode_jpeg(const ByteList& bytes) { return readers().jpeg(bytes); }

}  // namespace image
