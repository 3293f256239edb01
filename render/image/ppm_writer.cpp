#include "render/image/ppm_writer.h"

#include "render/image/files.h"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace image {

void write_ppm(const std::string& path, const Raster& raster, const char* software)
{
    std::string bytes = std::string(raster.channels == 1 ? "P5" : "P6") + "\n# Software: " + software + "\n";
    bytes += std::to_string(raster.width) + " " + std::to_string(raster.height) + "\n" + std::to_string(raster.maximum()) + "\n";
    bytes.reserve(bytes.size() + 2 * raster.samples.size());
    for (const std::uint16_t sample : raster.samples) {
        if (raster.bits > 8) bytes += static_cast<char>(sample >> 8);
        bytes += static_cast<char>(sample & 0xff);
    }
    std::ofstream out(path, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!out.flush()) throw FileError(std::strerror(errno));
}

}  // namespace image
