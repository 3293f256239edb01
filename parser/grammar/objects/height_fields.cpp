#include "csg/freeform/freeform.h"
#include "parser/grammar/core/function_samples.h"
#include "parser/grammar/textures/images.h"
#include "parser/grammar/core/solid_reader.h"
#include "render/image/files.h"
#include "render/image/height_levels.h"
#include "render/image/pixels/passing_failure.h"
#include "render/scene/base/passing_error.h"

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
        std::copy_n(from_top.begin() + std::ptrdiff_t{rows - 1 - k} * columns, columns,
                    grid.levels.begin() + std::ptrdiff_t{k} * columns);
    return grid;
}

/// Nothing if the function asks the scene and nobody answers.
std::optional<Grid> grid_of_function(SolidReader& s, const scene::ImageSource& source)
{
    const double columns = std::trunc(source.size.x), rows = std::trunc(source.size.y);
    if (!(columns >= 1.0 && rows >= 1.0 && columns * rows <= double(csg::HeightField::kMostPoints)))
        s.in().fail(s.source(), "a height field has at least 1 and at most 2^30 points");
    const function::FunctionPtr& called = source.function;
    const auto wide = static_cast<std::uint32_t>(columns), deep = static_cast<std::uint32_t>(rows);
    std::optional<std::vector<std::uint16_t>> levels = sampled_levels(s.build, called, wide, deep);
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

Grid grid_of_picture(SolidReader& s, const scene::ImageSource& source)
{
    try {
        const image::HeightLevels heights =
            image::read_heights(source.path, source.gamma ? source.gamma->curve() : image::TransferCurve::linear());
        return turned_over(heights.width, heights.height, heights.levels);
    } catch (const image::PassingFailure& error) {
        scene::fail_for_now([&] { s.in().fail(s.source(), error.what()); });
    } catch (const image::FileError& error) {
        s.in().fail(s.source(), error.what());
    }
}

using scene::HeightField;
struct TerrainState : ParameterState<HeightField> {
    using ParameterState::ParameterState;
    scene::ImageSource& part(scene::ImageSource*) { return solid.source; }
};
struct terrain_source : taker<terrain_source>, always {
    static bool take(TokenStream&, TerrainState& s)
    {
        s.solid.source = read_image_source(s.build);
        return true;
    }
    static Form form() { return image_source_form(); }
};
using terrain_rule =
    seq<terrain_source,
        pegtl::star<pegtl::sor<
            ignored<Kind::Hierarchy>, image_gamma, member<Kind::WaterLevel, &HeightField::water_level>,
            member<Kind::Smooth, &HeightField::smooth>, member<Kind::Premultiplied, &HeightField::premultiplied>>>>;

}  // namespace

Form parameters_form(const SolidReader*, const HeightField*, Kind) { return form_of<terrain_rule>(); }

bool read_parameters(SolidReader& s, HeightField& terrain)
{
    TerrainState state(s, terrain);
    read_solid<terrain_rule>(state);
    std::optional<Grid> grid = terrain.source.made() ? grid_of_function(s, terrain.source)
                                                     : grid_of_picture(s, terrain.source);
    if (!grid) return false;
    grid->water = terrain.water_level * (s.build.version() < 200 ? 256.0 : 65536.0);
    grid->smooth = terrain.smooth;
    s.object().shape = scene::Freeform{csg::make_freeform<csg::HeightField>(std::move(*grid))};
    return true;
}

}  // namespace parser
