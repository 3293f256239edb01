#include "render/model/ply_reader.h"

#include "render/model/ply_header.h"
#include "render/model/base/polygon_triangles.h"
#include "render/model/base/text_words.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace model {
namespace {

/// Numbers behind the header, one after the other.
class PlyText {
public:
    PlyText(std::string_view text, std::size_t line) : words_(text, line), most_(text.size() / 2 + 1) {}
    double number(PlyType) { return words_.number<double>(); }
    [[noreturn]] void fail(const std::string& what) const { words_.fail(what); }
    /// No more numbers can follow.
    std::size_t most() const { return most_; }

private:
    TextWords words_;
    std::size_t most_;
};

class PlyBytes {
public:
    PlyBytes(std::string_view bytes, std::size_t begin, bool swapped) : bytes_(bytes), at_(begin), swapped_(swapped) {}
    double number(PlyType type)
    {
        switch (type) {
        case PlyType::Int8: return take<std::int8_t>();
        case PlyType::Uint8: return take<std::uint8_t>();
        case PlyType::Int16: return take<std::int16_t>();
        case PlyType::Uint16: return take<std::uint16_t>();
        case PlyType::Int32: return take<std::int32_t>();
        case PlyType::Uint32: return take<std::uint32_t>();
        case PlyType::Float32: return static_cast<double>(take<float>());
        case PlyType::Float64: return take<double>();
        }
        return 0.0;
    }
    [[noreturn]] void fail(const std::string& what) const { throw ModelError::at_byte(what, last_); }
    std::size_t most() const { return bytes_.size() - at_; }

private:
    template <class Number>
    Number take()
    {
        last_ = at_;
        if (bytes_.size() - at_ < sizeof(Number)) fail("it ends");
        std::array<char, sizeof(Number)> raw;
        std::memcpy(raw.data(), bytes_.data() + at_, sizeof(Number));
        at_ += sizeof(Number);
        if (swapped_) std::reverse(raw.begin(), raw.end());
        return std::bit_cast<Number>(raw);
    }

    std::string_view bytes_;
    std::size_t at_, last_ = 0;
    bool swapped_;
};

/// What a number of an element becomes.
enum class Role : std::uint8_t {
    None,
    X,
    Y,
    Z,
    NormalX,
    NormalY,
    NormalZ,
    Red,
    Green,
    Blue,
    U,
    V,
    Corners,
    Strip,
    kCount
};
constexpr auto kRoles = static_cast<std::size_t>(Role::kCount);

struct RoleName {
    std::string_view element, property;
    Role role;
};
constexpr RoleName kRoleNames[] = {{"vertex", "x", Role::X},
                                   {"vertex", "y", Role::Y},
                                   {"vertex", "z", Role::Z},
                                   {"vertex", "nx", Role::NormalX},
                                   {"vertex", "ny", Role::NormalY},
                                   {"vertex", "nz", Role::NormalZ},
                                   {"vertex", "red", Role::Red},
                                   {"vertex", "green", Role::Green},
                                   {"vertex", "blue", Role::Blue},
                                   {"vertex", "diffuse_red", Role::Red},
                                   {"vertex", "diffuse_green", Role::Green},
                                   {"vertex", "diffuse_blue", Role::Blue},
                                   {"vertex", "s", Role::U},
                                   {"vertex", "t", Role::V},
                                   {"vertex", "u", Role::U},
                                   {"vertex", "v", Role::V},
                                   {"vertex", "texture_u", Role::U},
                                   {"vertex", "texture_v", Role::V},
                                   {"face", "red", Role::Red},
                                   {"face", "green", Role::Green},
                                   {"face", "blue", Role::Blue},
                                   {"face", "vertex_indices", Role::Corners},
                                   {"face", "vertex_index", Role::Corners},
                                   {"tristrips", "vertex_indices", Role::Strip},
                                   {"tristrips", "vertex_index", Role::Strip}};

struct Field {
    PlyProperty property;
    Role role = Role::None;
    double share = 1.0;  ///< of what the type's largest level is: 1 over it
};

/// Levels of colours by type: floats are 0 to 1.
double share_of(PlyType type)
{
    switch (type) {
    case PlyType::Uint8: return 1.0 / 255.0;
    case PlyType::Uint16: return 1.0 / 65535.0;
    case PlyType::Float32:
    case PlyType::Float64: return 1.0;
    default: return 1.0 / 255.0;
    }
}

template <class Numbers>
class Ply {
public:
    Ply(const PlyHeader& header, Numbers numbers) : header_(header), numbers_(std::move(numbers)) {}

    Model read()
    {
        for (const PlyElement& element : header_.elements) read_element(element);
        if (model_.vertices.empty()) throw ModelError("it has no vertices", 0);
        if (model_.faces.empty()) throw ModelError("it has no faces", 0);
        return std::move(model_);
    }

private:
    void read_element(const PlyElement& element)
    {
        if (element.properties.empty()) return;  // any number of nothing
        std::array<bool, kRoles> has{};
        std::vector<Field> fields;
        for (const PlyProperty& property : element.properties) {
            Field field{property};
            for (const RoleName& known : kRoleNames)
                if (known.element == element.name && known.property == property.name) field.role = known.role;
            if (property.list != (field.role == Role::Corners || field.role == Role::Strip)) field.role = Role::None;
            if (field.role >= Role::Red && field.role <= Role::Blue) field.share = share_of(property.type);
            has[static_cast<std::size_t>(field.role)] = true;
            fields.push_back(std::move(field));
        }
        const auto all = [&](Role first, int count) {
            for (int i = 0; i < count; ++i)
                if (!has[static_cast<std::size_t>(first) + static_cast<std::size_t>(i)]) return false;
            return true;
        };
        const bool vertex = element.name == "vertex", face = element.name == "face";
        if (vertex && !all(Role::X, 3)) numbers_.fail("its vertices have no x, y and z");
        if (vertex && !model_.vertices.empty()) numbers_.fail("it has two lists of vertices");
        if ((face || element.name == "tristrips") && model_.vertices.empty())
            numbers_.fail("its faces stand before its vertices");
        const bool normals = vertex && all(Role::NormalX, 3), colors = all(Role::Red, 3),
                   uvs = vertex && all(Role::U, 2);
        const auto room = static_cast<std::size_t>(std::min<std::uint64_t>(element.count, numbers_.most()));
        if (vertex) model_.vertices.reserve(room);
        if (face) model_.faces.reserve(room);
        for (std::uint64_t n = 0; n < element.count; ++n) {
            read_fields(element, fields, n);
            if (vertex) take_vertex(normals, colors, uvs);
            else if (face) take_face(colors);
            else if (has[static_cast<std::size_t>(Role::Strip)]) take_strips();
        }
    }

    double number(const PlyElement& element, std::uint64_t n, PlyType type)
    try {
        return numbers_.number(type);
    } catch (const ModelError& error) {
        ModelError whole("in " + element.name + " " + std::to_string(n + 1) + " of " + std::to_string(element.count) +
                             ": " + error.what(),
                         error.line);
        whole.byte = error.byte;
        throw whole;
    }

    void read_fields(const PlyElement& element, const std::vector<Field>& fields, std::uint64_t n)
    {
        corners_.clear();
        for (const Field& field : fields) {
            if (!field.property.list) {
                const double value = number(element, n, field.property.type);
                if (field.role != Role::None && !std::isfinite(value))
                    numbers_.fail("a number of " + element.name + " " + std::to_string(n + 1) + " is none");
                value_[static_cast<std::size_t>(field.role)] = value * field.share;
                continue;
            }
            const double count = number(element, n, field.property.count_type);
            if (count < 0.0) numbers_.fail("a list has " + std::to_string(static_cast<long>(count)) + " elements");
            for (double i = 0; i < count; ++i) {
                const double one = number(element, n, field.property.type);
                if (field.role == Role::None) continue;
                const bool ends = field.role == Role::Strip && one == -1.0;
                if (!ends && !(one >= 0.0 && one < static_cast<double>(model_.vertices.size())))
                    numbers_.fail(element.name + " " + std::to_string(n + 1) + " has a vertex that is none of " +
                                  std::to_string(model_.vertices.size()));
                corners_.push_back(ends ? kNone : static_cast<std::uint32_t>(one));
            }
        }
    }

    glm::vec3 color() const
    {
        return {static_cast<float>(value(Role::Red)), static_cast<float>(value(Role::Green)),
                static_cast<float>(value(Role::Blue))};
    }
    double value(Role role) const { return value_[static_cast<std::size_t>(role)]; }

    void take_vertex(bool normals, bool colors, bool uvs)
    {
        model_.vertices.emplace_back(value(Role::X), value(Role::Z), value(Role::Y));
        if (normals) model_.normals.emplace_back(value(Role::NormalX), value(Role::NormalZ), value(Role::NormalY));
        if (uvs) model_.uvs.emplace_back(value(Role::U), value(Role::V));
        if (colors) model_.colors.push_back(color());
        vertex_colors_ = colors;
    }

    void take_face(bool colors)
    {
        std::uint32_t face_color = kNone;
        if (colors && !vertex_colors_) {
            // Faces of one colour mostly follow each other.
            if (model_.colors.empty() || model_.colors.back() != color()) model_.colors.push_back(color());
            face_color = static_cast<std::uint32_t>(model_.colors.size() - 1);
        }
        if (corners_.size() < 3) numbers_.fail("a face has " + std::to_string(corners_.size()) + " corners");
        if (corners_.size() == 3) return add(0, 1, 2, face_color);
        outline_.clear();
        for (const std::uint32_t corner : corners_) outline_.push_back(model_.vertices[corner]);
        triangulate(outline_, triangles_);
        for (const auto& [a, b, c] : triangles_) add(a, b, c, face_color);
    }

    /// Every second triangle of a strip turns the other way; -1 ends one.
    void take_strips()
    {
        std::size_t first = 0;
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            if (corners_[i] == kNone) first = i + 1;
            else if (i >= first + 2) (i - first) % 2 == 0 ? add(i - 2, i - 1, i, kNone) : add(i - 1, i - 2, i, kNone);
        }
    }

    /// The sense of turning goes with the axes that change places.
    void add(std::size_t a, std::size_t b, std::size_t c, std::uint32_t face_color)
    {
        Model::Face face;
        face.vertex = {corners_[a], corners_[c], corners_[b]};
        if (face.vertex[0] == face.vertex[1] || face.vertex[1] == face.vertex[2] || face.vertex[0] == face.vertex[2])
            return;  // strips turn round by such
        if (!model_.normals.empty()) face.normal = face.vertex;
        if (!model_.uvs.empty()) face.uv = face.vertex;
        if (vertex_colors_) face.color = face.vertex;
        else face.color.fill(face_color);
        model_.faces.push_back(face);
    }

    const PlyHeader& header_;
    Numbers numbers_;
    Model model_;
    bool vertex_colors_ = false;
    std::array<double, kRoles> value_{};
    std::vector<std::uint32_t> corners_;
    std::vector<glm::dvec3> outline_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

bool is_ply(std::string_view bytes) { return bytes.starts_with("ply\n") || bytes.starts_with("ply\r\n"); }

Model ply_of(std::string_view bytes)
{
    const PlyHeader header = ply_header_of(bytes);
    if (header.format == PlyHeader::Format::Text)
        return Ply(header, PlyText(bytes.substr(header.end), header.line)).read();
    const bool big = header.format == PlyHeader::Format::BigEndian;
    return Ply(header, PlyBytes(bytes, header.end, big != (std::endian::native == std::endian::big))).read();
}

}  // namespace model
