#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>

namespace model {

/// Files in a ZIP file: stored or deflated, of any length. Methods throw ModelError.
class ZipReader {
public:
    /// \param bytes stay as they are as long as this is in use
    explicit ZipReader(std::string_view bytes);

    bool has(const std::string& name) const { return entries_.contains(name); }
    /// All that is read of one ZIP file is at most 200 times as long as that, and a megabyte.
    std::string read(const std::string& name);

private:
    struct Entry {
        std::uint64_t at = 0, packed = 0, length = 0;
        std::uint32_t method = 0, sum = 0;
    };
    std::uint64_t number(std::uint64_t at, std::size_t count) const;
    std::uint64_t directory(std::uint64_t& count) const;

    std::string_view bytes_;
    std::uint64_t room_;
    std::unordered_map<std::string, Entry> entries_;
};

}  // namespace model
