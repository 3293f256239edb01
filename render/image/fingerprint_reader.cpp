#include "render/image/fingerprint_reader.h"

#include "render/image/codecs/write/row_sink.h"
#include "render/image/entries.h"

#include <cstdint>
#include <string_view>

namespace image {

namespace {

constexpr std::uint32_t kLongest = 1 << 16;  // of an entry that may hold it

std::optional<std::string> in_png(Entries& file)
{
    constexpr std::uint32_t kCheck = 4;
    while (true) {
        const std::uint32_t size = file.big_endian();
        const std::string kind = file.bytes(4);
        if (file.ended() || kind == "IDAT") return std::nullopt;
        if (kind != "tEXt" || size > kLongest) {
            file.skip(size);
        } else {
            const std::string text = file.bytes(size);
            const std::size_t end = text.find('\0');
            if (!file.ended() && end != std::string::npos && text.substr(0, end) == kFingerprintKey)
                return text.substr(end + 1);
        }
        file.skip(kCheck);
    }
}

/// A version, then name, type, size and value of each attribute, until a name is empty (OpenEXR file layout).
std::optional<std::string> in_exr(Entries& file)
{
    file.skip(4);
    while (true) {
        const std::string name = file.name();
        if (file.ended() || name.empty()) return std::nullopt;
        const std::string type = file.name();
        const std::uint32_t size = file.little_endian();
        if (name != kFingerprintKey || size > kLongest) {
            file.skip(size);
            continue;
        }
        std::string value = file.bytes(size);
        if (file.ended() || type != "string") return std::nullopt;
        return value;
    }
}

}  // namespace

std::optional<std::string> fingerprint_in(const std::string& path)
{
    using std::string_view_literals::operator""sv;
    Entries file(path);
    std::string magic = file.bytes(4);
    if (magic == "\x76\x2f\x31\x01"sv) return in_exr(file);
    magic += file.bytes(4);
    if (magic == "\x89PNG\r\n\x1a\n"sv) return in_png(file);
    return std::nullopt;
}

}  // namespace image
