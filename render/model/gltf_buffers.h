#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <string_view>

/// The parts of a binary glTF file, with everything that it says of itself checked.
namespace model {

using GltfJson = nlohmann::json;

/// \param where as "accessor 3: what is wrong"
[[noreturn]] void fail_gltf(const std::string& where, const std::string& what);

/// A whole number of 0 or more; `usual` where there is none of that name.
std::size_t gltf_count(const GltfJson& of, const char* name, std::size_t usual, const std::string& where);
/// The element of a list of the file's, as "accessors"; fails where there is none.
const GltfJson& gltf_item(const GltfJson& file, const char* list, std::size_t index, const std::string& where);

/// Numbers of the file in rows, as a list of vectors.
class GltfRows {
public:
    /// \param width numbers a row that are wanted; more are passed over
    GltfRows(const GltfJson& file, std::string_view binary, std::size_t accessor, std::size_t width);

    std::size_t count() const { return count_; }
    std::size_t width() const { return width_; }  ///< that there are
    double real(std::size_t row, std::size_t column) const;
    /// Of whole numbers alone.
    std::uint32_t index(std::size_t row) const;

private:
    template <class Number>
    Number at(std::size_t row, std::size_t column) const;

    const char* first_ = nullptr;
    std::size_t count_ = 0, width_ = 0, stride_ = 0;
    unsigned type_ = 0;
    bool normalized_ = false;
    std::string where_;
};

/// The bytes of a bufferView.
std::string_view gltf_view(const GltfJson& file, std::string_view binary, std::size_t view, const std::string& where);

}  // namespace model
