#include "render/texture/function_host.h"
#include "render/texture/patterns/patterns.h"

/// What user functions make of many points: values of a pattern, components of a colour.
namespace texture {
namespace {

/// A user function, in whole lanes.
void plain_values(const TextureSet& set, std::uint32_t index, const Points& p, Values& out)
{
    const function::Function& function = *set.functions[index];
    static_assert(kMostPoints % function::kLanes == 0);
    constexpr std::size_t kWhole = function::kLanes - 1;
    const double* const at[] = {p.x.data(), p.y.data(), p.z.data()};
    double* const values = out.data();
    function::evaluate_lanes(function, at, (p.size() + kWhole) & ~kWhole, FunctionHost(set), 1, &values);
}

}  // namespace

void function_values(const TextureSet& set, const Pattern& pattern, const Points& p, Values& out)
{
    plain_values(set, pattern.function, p, out);
    for (std::size_t i = 0; i < p.size(); ++i) out[i] = wrapped_value(out[i]);
}

void function_colors(const TextureSet& set, const ColorFunctions& functions, const Points& p, ColorPoints& out)
{
    std::array<float, kMostPoints>* const parts[] = {&out.red, &out.green, &out.blue, &out.filter, &out.transmit};
    for (std::size_t i = 0; i < functions.size(); ++i) {
        if (functions[i] == kNone) {
            parts[i]->fill(0.0f);
            continue;
        }
        Values values;
        plain_values(set, functions[i], p, values);
        for (std::size_t k = 0; k < p.size(); ++k) (*parts[i])[k] = static_cast<float>(values[k]);
    }
}

}  // namespace texture
