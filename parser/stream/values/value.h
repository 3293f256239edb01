#pragma once

#include "function/program.h"
#include "parser/lexer/token.h"
#include "render/scene/base/sealed.h"
#include "render/scene/description.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace parser {

/// A number, vector or colour: `count` components of `at`, the rest 0. 1 float, 2 uv vector, 3 vector, 4 vector, 5
/// colour.
struct Tuple {
    std::array<double, 5> at{};
    int count = 1;

    static Tuple of(double v) { return {{v, 0, 0, 0, 0}, 1}; }
    static Tuple of(const glm::dvec3& v) { return {{v.x, v.y, v.z, 0, 0}, 3}; }
    static Tuple of(const scene::Color& c) { return {{c.red, c.green, c.blue, c.filter, c.transmit}, 5}; }
    glm::dvec3 vec3() const { return {at[0], at[1], at[2]}; }
    scene::Color color() const;
    /// As a variable, element or parameter holds it: five components are a colour, in single precision.
    Tuple stored() const { return count == 5 ? of(color()) : *this; }
};

struct Value;

/// Elements of a 1- to 5-dimensional array, last subscript fastest. Unset elements hold monostate.
struct Array {
    std::vector<std::uint32_t> sizes;
    std::vector<Value> elements;
    std::uint32_t kind = 0;  ///< kind_of() the first element that was assigned; it binds all later ones
    bool growing = false;    ///< one dimension without a size: an element behind the last may be assigned (version 3.8)
    bool mixed = false;      ///< elements of any types (version 3.8)
    bool gaps = false;       ///< elements of the initialiser may be left out (version 3.8)
    std::vector<std::vector<Value>> retired;  ///< memory of a growing array that references may still look into
};

/// `dictionary { .Key: value }` (version 3.8).
struct Dictionary;

/// `material { }`: what an object gets at once.
struct Material {
    scene::TexturePtr texture, interior_texture;
    std::shared_ptr<const scene::Interior> interior;
};

using NormalMap = std::vector<scene::MapEntry<scene::NormalPtr>>;
using SlopeMap = std::vector<scene::MapEntry<glm::dvec2>>;
using TextureMap = std::vector<scene::MapEntry<scene::TexturePtr>>;

struct Macro;     ///< token_stream.h
struct DataFile;  ///< data_file.h

struct ValueKinds {
    using variant = std::variant<
        std::monostate,  // never set
        Tuple, std::string, std::shared_ptr<Array>, std::shared_ptr<const scene::Object>, scene::TexturePtr,
        scene::PigmentPtr, scene::NormalPtr, std::shared_ptr<const scene::Finish>,
        std::shared_ptr<const scene::Interior>, std::shared_ptr<const Material>, std::shared_ptr<const scene::ColorMap>,
        std::shared_ptr<const scene::PigmentMap>, std::shared_ptr<const NormalMap>, std::shared_ptr<const SlopeMap>,
        std::shared_ptr<const TextureMap>, std::shared_ptr<const csg::Transform>, std::shared_ptr<const scene::Camera>,
        std::shared_ptr<const scene::Fog>, std::shared_ptr<const scene::SkySphere>, function::FunctionPtr,
        std::shared_ptr<const function::Spline>, std::shared_ptr<const Macro>, std::shared_ptr<DataFile>,
        std::shared_ptr<const scene::Media>, std::shared_ptr<const scene::Density>,
        std::shared_ptr<const scene::Rainbow>, std::shared_ptr<Dictionary>>;
};
}  // namespace parser
extern template struct scene::Sealed<parser::ValueKinds>;
namespace parser {

/// What an identifier may stand for. Scene things are shared and never changed in place.
/// A texture identifier keeps its layers; a `color_map` and a colour list are both ColorMap.
struct Value : scene::Sealed<ValueKinds> {
    using Sealed::Sealed;
    using Sealed::operator=;

    bool set() const { return index() != 0; }
    /// Pointer to the content if it is a T, else null: value.get_if<scene::TexturePtr>().
    template <class T>
    const T* get_if() const
    {
        return std::get_if<T>(static_cast<const Base*>(this));
    }
    template <class T>
    T* get_if()
    {
        return std::get_if<T>(static_cast<Base*>(this));
    }
};

/// A declared place: shared by a variable and the macro parameters that refer to it.
using Cell = std::shared_ptr<Value>;

struct Dictionary {
    std::map<std::string, Cell> members;
};

/// An array or dictionary: subscripts or a member's name may follow.
inline bool is_container(const Value& value)
{
    return value.get_if<std::shared_ptr<Array>>() != nullptr || value.get_if<std::shared_ptr<Dictionary>>() != nullptr;
}

/// One whose parts are of different types: what a name with subscripts means depends on them.
inline bool has_parts_of_any_type(const Value& value)
{
    const auto* array = value.get_if<std::shared_ptr<Array>>();
    return (array && (*array)->mixed) || value.get_if<std::shared_ptr<Dictionary>>() != nullptr;
}

/// "float", "vector", "color", "texture", ... for messages.
std::string_view type_name(const Value& value);

/// Tells types apart as arrays do: vectors of different lengths are different. 0: never set.
std::uint32_t kind_of(const Value& value);

/// A copy that shares no array with the original.
Value deep_copy(const Value& value);

}  // namespace parser
