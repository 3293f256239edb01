#include "parser/grammar/textures/density_file.h"

#include <cmath>

namespace parser {

std::shared_ptr<const scene::Volume> decode_density_file(std::string_view text)
{
    const std::basic_string_view bytes(reinterpret_cast<const unsigned char*>(text.data()), text.size());
    constexpr std::size_t kHeader = 6;
    auto volume = std::make_shared<scene::Volume>();
    std::size_t count = bytes.size() < kHeader ? 0 : 1;
    for (std::size_t axis = 0; axis < 3 && count > 0; ++axis) {
        volume->size[axis] = static_cast<std::uint32_t>(bytes[2 * axis] << 8 | bytes[2 * axis + 1]);
        count *= volume->size[axis];
    }
    std::size_t width = 4;
    while (width > 0 && (count == 0 || bytes.size() != kHeader + count * width)) width /= 2;
    if (width == 0) return nullptr;
    volume->samples.reserve(count);
    volume->most = std::ldexp(1.0, 8 * static_cast<int>(width)) - 1.0;
    for (std::size_t i = kHeader; i < bytes.size(); i += width) {
        std::uint32_t level = 0;
        for (std::size_t k = 0; k < width; ++k) level = level << 8 | bytes[i + k];
        volume->samples.push_back(level);
    }
    return volume;
}

}  // namespace parser
