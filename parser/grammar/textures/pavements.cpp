#include "parser/grammar/core/scene_builder.h"

#include <array>
#include <string>

namespace parser {

void check_pavement(SceneBuilder& build, const scene::Pattern& pattern)
{
    if (pattern.name != "pavement") return;
    static constexpr std::array<std::array<int, 6>, 3> kPatterns{
        {{1, 1, 1, 3, 4, 12}, {1, 1, 2, 5, 12, 35}, {1, 1, 3, 7, 22, 0}}};
    const auto number = [&pattern](std::size_t i) { return static_cast<int>(pattern.numbers[i]); };
    const int sides = number(0), tiles = number(1);
    if (sides != 3 && sides != 4 && sides != 6)
        build.stream().fail(pattern.source, "a pavement's number_of_sides must be 3, 4 or 6");
    const int most_tiles = sides == 6 ? 5 : 6;
    if (tiles < 1 || tiles > most_tiles)
        build.stream().fail(pattern.source,
                            "this pavement's number_of_tiles must be between 1 and " + std::to_string(most_tiles));
    const int most =
        kPatterns[sides == 6 ? 2 : static_cast<std::size_t>(sides - 3)][static_cast<std::size_t>(tiles - 1)];
    if (number(2) < 1 || number(2) > most)
        build.stream().fail(pattern.source, "this pavement's pattern must be between 1 and " + std::to_string(most));
}

}  // namespace parser
