#include "render/model/gltf_buffers.h"

#include "render/model/base/model.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace model {
namespace {

enum ComponentType : unsigned { kByte = 5120, kUnsignedByte, kShort, kUnsignedShort, kUnsignedInt = 5125, kFloat };

std::size_t bytes_of(unsigned type, const std::string& where)
{
    switch (type) {
    case kByte:
    case kUnsignedByte: return 1;
    case kShort:
    case kUnsignedShort: return 2;
    case kUnsignedInt:
    case kFloat: return 4;
    default: fail_gltf(where, "there is no componentType " + std::to_string(type));
    }
}

std::size_t width_of(const GltfJson& accessor, const std::string& where)
{
    const auto type = accessor.find("type");
    if (type != accessor.end() && type->is_string()) {
        const std::string& name = type->get_ref<const std::string&>();
        if (name == "SCALAR") return 1;
        if (name.size() == 4 && name.starts_with("VEC") && name[3] >= '2' && name[3] <= '4')
            return static_cast<std::size_t>(name[3] - '0');
    }
    fail_gltf(where, "its type is neither SCALAR nor VEC2 to VEC4");
}

}  // namespace

void fail_gltf(const std::string& where, const std::string& what) { throw ModelError(where + ": " + what, 0); }

std::size_t gltf_count(const GltfJson& of, const char* name, std::size_t usual, const std::string& where)
{
    const auto found = of.find(name);
    if (found == of.end()) return usual;
    if (!found->is_number_unsigned()) fail_gltf(where, std::string("its ") + name + " is no whole number");
    return found->get<std::size_t>();
}

const GltfJson& gltf_item(const GltfJson& file, const char* list, std::size_t index, const std::string& where)
{
    const auto found = file.find(list);
    const std::size_t count = found != file.end() && found->is_array() ? found->size() : 0;
    if (index >= count)
        fail_gltf(where, "there is no element " + std::to_string(index) + " of " + list + ": they are " +
                             std::to_string(count));
    const GltfJson& item = (*found)[index];
    if (!item.is_object())
        fail_gltf(where, std::string("element ") + std::to_string(index) + " of " + list + " is no object");
    return item;
}

std::string_view gltf_view(const GltfJson& file, std::string_view binary, std::size_t view, const std::string& where)
{
    const GltfJson& of = gltf_item(file, "bufferViews", view, where);
    const std::size_t buffer = gltf_count(of, "buffer", 0, where);
    if (buffer != 0 || gltf_item(file, "buffers", buffer, where).contains("uri"))
        fail_gltf(where, "its bytes are in another file");
    const std::size_t begin = gltf_count(of, "byteOffset", 0, where), length = gltf_count(of, "byteLength", 0, where);
    if (begin > binary.size() || length > binary.size() - begin)
        fail_gltf(where, "it ends behind the file's " + std::to_string(binary.size()) + " binary bytes");
    return binary.substr(begin, length);
}

GltfRows::GltfRows(const GltfJson& file, std::string_view binary, std::size_t accessor, std::size_t width)
    : where_("accessor " + std::to_string(accessor))
{
    const GltfJson& of = gltf_item(file, "accessors", accessor, where_);
    if (of.contains("sparse")) fail_gltf(where_, "sparse accessors are not read");
    if (!of.contains("bufferView")) fail_gltf(where_, "it has no bufferView");
    const std::size_t view_index = gltf_count(of, "bufferView", 0, where_);
    const std::string_view view = gltf_view(file, binary, view_index, where_);
    type_ = static_cast<unsigned>(std::min<std::size_t>(gltf_count(of, "componentType", 0, where_), 1u << 16));
    width_ = width_of(of, where_);
    if (width_ < width)
        fail_gltf(where_,
                  "it has " + std::to_string(width_) + " numbers a row, " + std::to_string(width) + " are needed");
    const std::size_t row = width_ * bytes_of(type_, where_);
    stride_ = gltf_count(gltf_item(file, "bufferViews", view_index, where_), "byteStride", row, where_);
    count_ = gltf_count(of, "count", 0, where_);
    const std::size_t begin = gltf_count(of, "byteOffset", 0, where_);
    if (stride_ < row || begin > view.size() || (count_ > 0 && view.size() - begin < row) ||
        (count_ > 1 && (view.size() - begin - row) / stride_ < count_ - 1))
        fail_gltf(where_, "its " + std::to_string(count_) + " rows end behind its bufferView");
    const auto normalized = of.find("normalized");
    normalized_ = normalized != of.end() && normalized->is_boolean() && normalized->get<bool>();
    first_ = view.data() + begin;
}

template <class Number>
Number GltfRows::at(std::size_t row, std::size_t column) const
{
    Number value;
    std::memcpy(&value, first_ + row * stride_ + column * sizeof value, sizeof value);
    return value;
}

double GltfRows::real(std::size_t row, std::size_t column) const
{
    const auto shared = [&](double value, double most) { return normalized_ ? std::max(value / most, -1.0) : value; };
    switch (type_) {
    case kByte: return shared(at<std::int8_t>(row, column), 127.0);
    case kUnsignedByte: return shared(at<std::uint8_t>(row, column), 255.0);
    case kShort: return shared(at<std::int16_t>(row, column), 32767.0);
    case kUnsignedShort: return shared(at<std::uint16_t>(row, column), 65535.0);
    case kUnsignedInt: return at<std::uint32_t>(row, column);
    default: break;
    }
    const auto value = static_cast<double>(at<float>(row, column));
    if (!std::isfinite(value)) fail_gltf(where_, "row " + std::to_string(row) + " holds what is no number");
    return value;
}

std::uint32_t GltfRows::index(std::size_t row) const
{
    switch (type_) {
    case kUnsignedByte: return at<std::uint8_t>(row, 0);
    case kUnsignedShort: return at<std::uint16_t>(row, 0);
    case kUnsignedInt: return at<std::uint32_t>(row, 0);
    default: fail_gltf(where_, "indices are whole numbers of 0 or more");
    }
}

}  // namespace model
