#include "render/image/carried_reader.h"

#include "render/image/base64.h"
#include "render/image/codecs/write/row_sink.h"
#include "render/image/entries.h"
#include "render/image/pixels/passing_failure.h"

#include <zlib.h>

#include <string_view>

namespace image {

namespace {

[[noreturn]] void too_long(std::uint32_t size)
{
    throw FileError("its scene takes " + std::to_string(size) + " bytes, more than the " +
                    std::to_string(kMostCarried) + " that a picture may carry");
}

constexpr const char* kEndsEarly = "the file ends before its scene does";

std::optional<std::string> carried_in_png(Entries& file)
{
    constexpr std::uint32_t kCheck = 4;
    while (true) {
        const std::uint32_t size = file.big_endian();
        const std::string kind = file.bytes(4);
        if (file.ended()) throw FileError("the file ends where an entry of PNG has to begin");
        if (kind == "IEND") return std::nullopt;
        if (kind != kCarriedChunk) {
            file.skip(size);
            file.skip(kCheck);
            continue;
        }
        if (size > kMostCarried) too_long(size);
        std::string value = file.bytes(size);
        const std::uint32_t sum = file.big_endian();
        if (file.ended()) throw FileError(kEndsEarly);
        uLong found = crc32(0, reinterpret_cast<const Bytef*>(kind.data()), 4);
        if (size > 0) found = crc32(found, reinterpret_cast<const Bytef*>(value.data()), size);
        if (found != sum) throw FileError("its scene is damaged: the checksum is another");
        return value;
    }
}

/// A version, then name, type, size and value of each attribute, until a name is empty (OpenEXR file layout).
std::optional<std::string> carried_in_exr(Entries& file)
{
    file.skip(4);
    while (true) {
        const std::string name = file.name();
        if (file.ended()) throw FileError("the file ends within its attributes");
        if (name.empty()) return std::nullopt;
        const std::string type = file.name();
        const std::uint32_t size = file.little_endian();
        if (name != kCarriedKey) {
            file.skip(size);
            continue;
        }
        if (size > kMostCarried / 3 * 4) too_long(size);
        const std::string text = file.bytes(size);
        if (file.ended()) throw FileError(kEndsEarly);
        auto value = from_base64(text);
        if (type != "string" || !value) throw FileError("its scene is damaged: it is not written in base64");
        return value;
    }
}

}  // namespace

std::optional<std::string> carried_in(const std::string& path)
{
    using std::string_view_literals::operator""sv;
    Entries file(path);
    std::string magic = file.bytes(4);
    if (file.ended()) throw FileError("there is no such file, or it cannot be read");
    if (magic == "\x76\x2f\x31\x01"sv) return carried_in_exr(file);
    magic += file.bytes(4);
    if (magic == "\x89PNG\r\n\x1a\n"sv) return carried_in_png(file);
    throw FileError("it is neither PNG nor OpenEXR, and other pictures carry no scene");
}

}  // namespace image
