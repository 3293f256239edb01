#pragma once

#include "render/image/pixels/image.h"
#include "render/image/levels/quantise.h"
#include "render/picture/blocks.h"

#include <cstdint>
#include <mutex>
#include <string>

namespace app {

/// A file, mapped into memory, in which another program watches the picture grow (LeoCAD's `+SM"file"`): five 32-bit
/// numbers, then 8-bit red, green, blue, alpha of all pixels, top row first.
class PreviewFile {
public:
    /// \param encoding of the picture's file: the preview has its colours, in 8 bits. Throws std::runtime_error.
    PreviewFile(const std::string& path, int width, int height, const image::Encoding& encoding);
    PreviewFile(const PreviewFile&) = delete;
    PreviewFile& operator=(const PreviewFile&) = delete;
    ~PreviewFile();

    /// The block stands in the picture; from any thread.
    void show(const trace::Block& block, const image::Image& picture);

private:
    struct Header {
        std::uint32_t version, width, height;
        std::uint32_t written;  ///< pixels in place
        std::uint32_t read;     ///< the watcher's own
    };
    image::Encoding encoding_;
    std::size_t bytes_;
    int width_;
    void* map_;
    std::mutex counting_;
};

}  // namespace app
