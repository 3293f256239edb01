#include "render/app/output/preview_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace app {

namespace {

constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kPixelBytes = 4;

}  // namespace

PreviewFile::PreviewFile(const std::string& path, int width, int height, const image::Encoding& encoding)
    : encoding_(encoding),
      bytes_(sizeof(Header) + kPixelBytes * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      width_(width)
{
    encoding_.bits = 8;
    encoding_.alpha = true;
    encoding_.greyscale = false;
    encoding_.dither = image::Dither::None;
    const int file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    const bool sized = file >= 0 && ftruncate(file, static_cast<off_t>(bytes_)) == 0;
    map_ = sized ? mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0) : MAP_FAILED;
    const int why = errno;
    if (file >= 0) close(file);
    if (map_ == MAP_FAILED) throw std::runtime_error("cannot make the preview '" + path + "': " + std::strerror(why));
    const Header header{kVersion, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), 0, 0};
    std::memset(map_, 0, bytes_);
    std::memcpy(map_, &header, sizeof header);
}

PreviewFile::~PreviewFile() { munmap(map_, bytes_); }

void PreviewFile::show(const trace::Block& block, const image::Image& picture)
{
    image::Image part{block.width, block.height, {}, 0};
    for (int row = 0; row < block.height; ++row) {
        const float* from = picture.at(block.left, block.top + row);
        part.pixels.insert(part.pixels.end(), from, from + 4 * block.width);
    }
    const image::Raster raster = image::quantise(part, encoding_);
    auto* pixels = static_cast<unsigned char*>(map_) + sizeof(Header);
    for (int row = 0; row < block.height; ++row) {
        unsigned char* to = pixels + kPixelBytes *
                                         (static_cast<std::size_t>(block.top + row) * static_cast<std::size_t>(width_) +
                                          static_cast<std::size_t>(block.left));
        const std::uint16_t* from = raster.at(0, row);
        for (std::size_t i = 0; i < kPixelBytes * static_cast<std::size_t>(block.width); ++i)
            to[i] = static_cast<unsigned char>(from[i]);
    }
    const std::lock_guard lock(counting_);
    auto* header = static_cast<Header*>(map_);
    std::atomic_thread_fence(std::memory_order_release);  // the count never runs ahead of the pixels
    header->written += static_cast<std::uint32_t>(block.width) * static_cast<std::uint32_t>(block.height);
}

}  // namespace app
