#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// What a PLY file says of itself before its numbers.
namespace model {

enum class PlyType : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };
std::size_t bytes_of(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;
    bool list = false;
    PlyType count_type = PlyType::Uint8;  ///< of a list
};
struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};
struct PlyHeader {
    enum class Format : std::uint8_t { Text, LittleEndian, BigEndian } format = Format::Text;
    std::vector<PlyElement> elements;
    std::size_t end = 0;   ///< the first byte behind it
    std::size_t line = 1;  ///< of that byte
};

/// Throws ModelError.
PlyHeader ply_header_of(std::string_view bytes);

}  // namespace model
