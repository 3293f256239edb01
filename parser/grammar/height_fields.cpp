#include "csg/freeform.h"
#include "parser/grammar/function_samples.h"
#include "parser/grammar/shape_makers.h"
#include "render/image/files.h"
#include "render/image/height_levels.h"
#include "render/scene/picture_gamma.h"

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

/// Nothing if the function asks the scene and nobody answers.
std::optional<Grid> grid_of_function(SceneBuilder& build, const scene::Statement& statement)
{
    const scene::StatementItem& size = *item_of(statement, "function");
    const double columns = std::trunc(number_of(size.operands[0])), rows = std::trunc(number_of(size.operands[1]));
    if (!(columns >= 1.0 && rows >= 1.0 && columns * rows <= double(csg::HeightField::kMostPoints)))
        build.stream().fail(statement.source, "a height field has at least 1 and at most 2^30 points");
    const auto& called = std::get<function::FunctionPtr>(item_of(statement, "body")->operands[0]);
    const auto wide = static_cast<std::uint32_t>(columns), deep = static_cast<std::uint32_t>(rows);
    std::optional<std::vector<std::uint16_t>> levels = sampled_levels(build, called, wide, deep);
    if (!levels) return std::nullopt;
    if (const std::size_t channels = sampled_channels(*called); channels > 1) {
        for (std::size_t i = 0; i < levels->size() / channels; ++i) {
            const std::uint16_t* color = &(*levels)[i * channels];
            (*levels)[i] = image::color_level(color[0], color[1], color[2]);
        }
        levels->resize(levels->size() / channels);
    }
    return turned_over(wide, deep, *levels);
}

Grid grid_of_picture(SceneBuilder& build, const scene::Statement& statement)
{
    try {
        const image::HeightLevels heights = image::read_heights(std::get<std::string>(statement.items.front().operands[0]), scene::written_gamma(statement).value_or(image::TransferCurve::linear()));
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
