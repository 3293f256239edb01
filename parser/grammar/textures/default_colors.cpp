#include "parser/grammar/core/scene_builder.h"

namespace parser {
namespace {

scene::Color rgb(float r, float g, float b) { return {r, g, b, 0, 0}; }

scene::ColorMap listed(std::initializer_list<scene::Color> colors, std::size_t count)
{
    scene::ColorMap map;
    for (const scene::Color& c : colors)
        if (map.size() < count) map.push_back({static_cast<double>(map.size()), c});
    return map;
}

}  // namespace

scene::ColorMap default_colors(const scene::Pattern& pattern)
{
    const std::string& name = pattern.name;
    const scene::Color red = rgb(1, 0, 0), green = rgb(0, 1, 0), blue = rgb(0, 0, 1), yellow = rgb(1, 1, 0),
                       cyan = rgb(0, 1, 1), magenta = rgb(1, 0, 1), black = rgb(0, 0, 0), white = rgb(1, 1, 1);
    if (name == "brick") return listed({rgb(0.5f, 0.5f, 0.5f), rgb(0.6f, 0.15f, 0.15f)}, 2);
    if (name == "checker" || name == "object" || name == "hexagon")
        return listed({blue, green, red}, static_cast<std::size_t>(list_size(pattern)));
    if (const int n = list_size(pattern))
        return listed({red, green, blue, yellow, cyan, magenta}, static_cast<std::size_t>(n));
    if (name == "bozo") return {{0.4, white}, {0.4, green}, {0.6, green}, {0.6, blue}, {0.8, blue}, {0.8, red}};
    if (name == "wood") return {{0.6, rgb(0.666f, 0.312f, 0.2f)}, {0.6, rgb(0.4f, 0.1333f, 0.066f)}};
    if (name == "mandel" && pattern.numbers.size() > 1 && pattern.numbers[1] == 2)
        return {{0.001, black}, {0.001, cyan}, {0.012, yellow}, {0.015, magenta}, {0.1, cyan}};
    if (name == "agate")
        return {{0, white},
                {0.5, rgb(0.95f, 0.75f, 0.5f)},
                {0.5, rgb(0.9f, 0.7f, 0.5f)},
                {0.6, rgb(0.9f, 0.7f, 0.4f)},
                {0.6, rgb(1, 0.7f, 0.4f)},
                {1, rgb(0.6f, 0.3f, 0)}};
    if (name == "radial") return {{0, cyan}, {0.333, yellow}, {0.666, magenta}, {1, cyan}};
    if (name == "marble") return {{0, rgb(0.9f, 0.8f, 0.8f)}, {0.9, rgb(0.9f, 0.08f, 0.08f)}, {0.9, black}};
    return {{0, black}, {1, white}};
}

}  // namespace parser
