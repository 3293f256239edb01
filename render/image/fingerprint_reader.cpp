#include "render/image/fingerprint_reader.h"

#include "render/image/codecs/row_sink.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <string_view>

namespace image {

namespace {

constexpr std::uint32_t kLongest = 1 << 16;  // of an entry that may hold it

/// Numbers and texts of a file, until it ends.
class Entries {
public:
    explicit Entries(const std::string& path) : in_(path, std::ios::binary) {}
    bool ended() const { return !in_; }
    std::string bytes(std::size_t count)
    {
        std::string out(count, '\0');
        in_.read(out.data(), static_cast<std::streamsize>(count));
        return out;
    }
    std::string name()
    {
        std::string out;
        std::getline(in_, out, '\0');
        return out;
    }
    void skip(std::uint32_t count) { in_.seekg(count, std::ios::cur); }
    std::uint32_t big_endian()
    {
        std::uint32_t out = 0;
        for (const char c : bytes(4)) out = out << 8 | static_cast<std::uint8_t>(c);
        return out;
    }
    std::uint32_t little_endian() { return __builtin_bswap32(big_endian()); }

private:
    std::ifstream in_;
};

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
