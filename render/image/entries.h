#pragma once

#include <cstdint>
#include <fstream>
#include <string>

namespace image {

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

}  // namespace image
