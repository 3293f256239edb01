#include "parser/stream/values/value.h"

template struct scene::Sealed<parser::ValueKinds>;

namespace parser {

scene::Color Tuple::color() const
{
    return {static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2]), static_cast<float>(at[3]),
            static_cast<float>(at[4])};
}

std::string_view type_name(const Value& value)
{
    if (const auto* tuple = value.get_if<Tuple>()) {
        static constexpr std::string_view kTuples[] = {"float", "uv vector", "vector", "4-component vector", "color"};
        return kTuples[tuple->count - 1];
    }
    static constexpr std::string_view kNames[] = {
        "nothing",   "number",      "string",    "array",    "object",    "texture",     "pigment",
        "normal",    "finish",      "interior",  "material", "color_map", "pigment_map", "normal_map",
        "slope_map", "texture_map", "transform", "camera",   "fog",       "sky_sphere",  "function",
        "spline",    "macro",       "file",      "effect",   "effect",    "effect",      "dictionary"};
    static_assert(std::size(kNames) == std::variant_size_v<ValueKinds::variant>);
    return kNames[value.index()];
}

std::uint32_t kind_of(const Value& value)
{
    const auto* tuple = value.get_if<Tuple>();
    return static_cast<std::uint32_t>(value.index()) * 8 + static_cast<std::uint32_t>(tuple ? tuple->count : 0);
}

Value deep_copy(const Value& value)
{
    if (const auto* dictionary = value.get_if<std::shared_ptr<Dictionary>>()) {
        auto copy = std::make_shared<Dictionary>();
        for (const auto& [key, member] : (*dictionary)->members)
            copy->members.emplace(key, std::make_shared<Value>(deep_copy(*member)));
        return copy;
    }
    const auto* array = value.get_if<std::shared_ptr<Array>>();
    if (!array) return value;
    auto copy = std::make_shared<Array>();
    copy->sizes = (*array)->sizes;
    copy->kind = (*array)->kind;
    copy->growing = (*array)->growing;
    copy->mixed = (*array)->mixed;
    copy->elements.reserve((*array)->elements.size());
    for (const Value& element : (*array)->elements) copy->elements.push_back(deep_copy(element));
    return copy;
}

}  // namespace parser
