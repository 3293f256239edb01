#include "csg/freeform.h"
#include "parser/grammar/shape_makers.h"
#include "parser/queries.h"
#include "render/image/files.h"
#include "render/image/height_levels.h"

#include <algorithm>
#include <cmath>
#include <optional>

/// Terrain out of a picture or a function (reference manual: height_field; spec 5b, 10.1).
namespace parser {
namespace {

using Grid = csg::HeightField::Grid;

Grid turned_over(std::uint32_t columns, std::uint32_t rows, const std::vector<std::uint16_t>& from_top)
{
    Grid grid;
    grid.columns = columns;
    grid.rows = rows;
    grid.levels.resize(from_top.size());
    for (std::uint32_t k = 0; k < rows; ++k)
        std::copy_n(from_top.begin() + std::ptrdiff_t{rows - 1 - k} * columns, columns, grid.levels.begin() + std::ptrdiff_t{k} * columns);
    return grid;
}

/// What the function is worth as a level: numbers wrap round, colours are stored in 16 bits first.
std::uint16_t level_of(const function::Values& value, bool color)
{
    constexpr double kMost = 65535.0;
    if (!color) return static_cast<std::uint16_t>(static_cast<std::int64_t>(std::clamp(std::isnan(value[0]) ? 0.0 : value[0] * kMost, -0x1p31, 0x1p31)));
    const auto stored = [](double v) { return static_cast<std::uint16_t>(std::clamp(std::isnan(v) ? 0.0 : v, 0.0, 1.0) * kMost + 0.5); };
    return image::color_level(stored(value[0]), stored(value[1]), stored(value[2]));
}

/// Nothing if the function asks the scene and nobody answers.
std::optional<Grid> grid_of_function(SceneBuilder& build, const scene::Statement& statement)
{
    const scene::StatementItem& size = *item_of(statement, "function");
    const double columns = std::trunc(number_of(size.operands[0])), rows = std::trunc(number_of(size.operands[1]));
    if (!(columns >= 1.0 && rows >= 1.0 && columns * rows <= double(csg::HeightField::kMostPoints)))
        build.stream().fail(statement.source, "a height field has at least 1 and at most 2^30 points");
    const auto& called = std::get<function::FunctionPtr>(item_of(statement, "body")->operands[0]);
    const bool color = called->components > 1;
    const auto wide = static_cast<std::uint32_t>(columns), deep = static_cast<std::uint32_t>(rows);
    std::vector<std::uint16_t> levels;
    levels.reserve(std::size_t{wide} * deep);
    for (std::uint32_t y = 0; y < deep; ++y)
        for (std::uint32_t x = 0; x < wide; ++x) {
            const double at[3] = {x / (columns - 1.0), y / (rows - 1.0), 0.0};
            if (!called->asks_scene) {
                levels.push_back(level_of(function::evaluate_all(*called, at, function::no_host()), color));
                continue;
            }
            const auto value = build.evaluate(called, at);
            if (!value) return std::nullopt;
            levels.push_back(level_of(*value, color));
        }
    return turned_over(wide, deep, levels);
}

image::TransferCurve curve_of(const scene::Statement& statement)
{
    const scene::StatementItem* gamma = item_of(statement, "gamma");
    if (gamma == nullptr) return image::TransferCurve::linear();
    if (std::holds_alternative<std::string>(gamma->operands[0])) return image::TransferCurve::srgb();
    return image::TransferCurve::power(static_cast<float>(number_of(gamma->operands[0])));
}

Grid grid_of_picture(SceneBuilder& build, const scene::Statement& statement)
{
    try {
        const image::HeightLevels heights = image::read_heights(std::get<std::string>(statement.items.front().operands[0]), curve_of(statement));
        return turned_over(heights.width, heights.height, heights.levels);
    } catch (const image::FileError& error) {
        build.stream().fail(statement.source, error.what());
    }
}

}  // namespace

bool make_height_field(SceneBuilder& build, const scene::Statement& statement, scene::Object& object)
{
    std::optional<Grid> made = item_of(statement, "function") ? grid_of_function(build, statement) : grid_of_picture(build, statement);
    if (!made) return false;
    Grid& grid = *made;
    for (const scene::StatementItem& item : statement.items) {
        if (item.name == "water_level") grid.water = number_of(item.operands[0]) * (build.version() < 200 ? 256.0 : 65536.0);
        else if (item.name == "smooth") grid.smooth = item.operands.empty() || number_of(item.operands[0]) != 0.0;
    }
    object.shape = scene::Freeform{csg::make_freeform<csg::HeightField>(std::move(*made))};
    return true;
}

}  // namespace parser
