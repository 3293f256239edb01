#include "csg/freeform/freeform.h"
#include "function/field/field.h"
#include "parser/grammar/core/solid_reader.h"
#include "parser/stream/functions/function.h"

#include <algorithm>

/// Solids made of functions (reference manual: isosurface, parametric).
namespace parser {
namespace {

constexpr std::uint32_t kCoordinates = 3;

function::FunctionPtr read_function(SolidReader& s)
{
    if (s.next_kind() != Kind::Function) s.in().fail_expected("'function' and its body");
    return read_function_value(s.in());
}

/// Null: it wants more than a point.
std::shared_ptr<const csg::Field> field_of(const function::FunctionPtr& function)
{
    if (function->parameters > kCoordinates) return nullptr;
    return std::make_shared<const function::FunctionField>(function);
}

void read_container(SolidReader& s, scene::Container& to)
{
    const auto opened = s.build().open_block("contained_by");
    if (s.accept(Kind::Sphere)) {
        const auto inner = s.build().open_block("sphere");
        read_values(s.in(), to.center, to.radius);
        to.kind = scene::Container::Kind::Sphere;
        s.build().close_block("sphere", inner);
    } else if (s.accept(Kind::Box)) {
        const auto inner = s.build().open_block("box");
        read_values(s.in(), to.corner[0], to.corner[1]);
        to.kind = scene::Container::Kind::Box;
        s.build().close_block("box", inner);
    } else {
        s.in().fail_expected("a sphere or box without modifiers");
    }
    s.build().close_block("contained_by", opened);
}

csg::Container container_of(const scene::Container& written)
{
    if (written.kind == scene::Container::Kind::Sphere) return csg::Container::sphere(written.center, written.radius);
    return csg::Container::box(written.corner[0], written.corner[1]);
}

/// What must be above 0; told where it is not.
void need_positive(SolidReader& s, const char* name, double& value, double usual)
{
    if (value > 0.0) return;
    s.in().warn(s.source(), std::string(name) + " must be above 0: it is " + (usual < 1.0 ? ".001" : "1.1") + " now");
    value = usual;
}

double read_precompute(SolidReader& s, scene::Parametric& surface)
{
    const double levels = float_expr(s.in());
    surface.precomputed.clear();
    for (;;) {
        const Kind kind = s.next_kind();
        if (kind != Kind::X && kind != Kind::Y && kind != Kind::Z) return levels;
        surface.precomputed += spelling(s.in().next().kind);
        s.in().accept_comma();
    }
}

}  // namespace

bool read_parameters(SolidReader& s, scene::Isosurface& surface)
{
    using scene::Isosurface;
    static constexpr auto kFields =
        std::tuple(field(Kind::Threshold, &Isosurface::threshold), field(Kind::Accuracy, &Isosurface::accuracy),
                   field(Kind::MaxGradient, &Isosurface::max_gradient), word(Kind::Open, &Isosurface::open));
    surface.function = read_function(s);
    for (;;) {
        if (s.accept(Kind::ContainedBy)) {
            read_container(s, surface.container);
        } else if (s.accept(Kind::Evaluate)) {
            glm::dvec3& growth = surface.evaluate.emplace();
            read_values(s.in(), growth.x, growth.y, growth.z);
        } else if (s.accept(Kind::MaxTrace)) {
            surface.max_trace = std::clamp(whole_number(float_expr(s.in())), 1, Isosurface::kMostTraced);
            surface.all_intersections = false;
        } else if (s.accept(Kind::AllIntersections)) {
            surface.max_trace = Isosurface::kMostTraced;
            surface.all_intersections = true;
        } else if (!read_one(s, surface, kFields)) {
            break;
        }
    }
    csg::IsosurfaceTerms terms;
    terms.field = field_of(surface.function);
    if (!terms.field) return false;
    need_positive(s, "accuracy", surface.accuracy, Isosurface().accuracy);
    need_positive(s, "max_gradient", surface.max_gradient, Isosurface().max_gradient);
    terms.threshold = surface.threshold;
    terms.accuracy = surface.accuracy;
    terms.max_gradient = surface.max_gradient;
    terms.container = container_of(surface.container);
    terms.max_trace = surface.max_trace;
    terms.open = surface.open;
    terms.evaluate = surface.evaluate.has_value();
    if (surface.evaluate) terms.growth = *surface.evaluate;
    s.object().shape = scene::Freeform{csg::make_freeform<csg::Isosurface>(std::move(terms))};
    return true;
}

bool read_parameters(SolidReader& s, scene::Parametric& surface)
{
    using scene::Parametric;
    constexpr double kMostLevels = 20.0;
    static constexpr auto kFields =
        std::tuple(field(Kind::Accuracy, &Parametric::accuracy), field(Kind::MaxGradient, &Parametric::max_gradient));
    for (std::size_t i = 0; i < 3; ++i) {
        if (i > 0) s.in().accept_comma();
        surface.function[i] = read_function(s);
    }
    read_values(s.in(), surface.range[0], surface.range[1]);
    std::optional<double> levels;
    for (;;) {
        if (s.accept(Kind::ContainedBy)) read_container(s, surface.container);
        else if (s.accept(Kind::Precompute)) levels = read_precompute(s, surface);
        else if (!read_one(s, surface, kFields)) break;
    }
    csg::ParametricTerms terms;
    for (std::size_t i = 0; i < 3; ++i)
        if (!(terms.field[i] = field_of(surface.function[i]))) return false;
    if (levels && !(*levels >= 1.0 && *levels <= kMostLevels))
        s.in().fail(s.source(), "precompute needs 1 to 20 levels");
    surface.precompute = static_cast<int>(levels.value_or(0.0));
    need_positive(s, "accuracy", surface.accuracy, Parametric().accuracy);
    terms.lower = glm::min(surface.range[0], surface.range[1]);
    terms.upper = glm::max(surface.range[0], surface.range[1]);
    terms.precompute = surface.precompute;
    for (const char axis : surface.precomputed) terms.precomputed[static_cast<std::size_t>(axis - 'x')] = true;
    terms.accuracy = surface.accuracy;
    terms.max_gradient = surface.max_gradient;
    terms.container = container_of(surface.container);
    s.object().shape = scene::Freeform{csg::make_freeform<csg::Parametric>(std::move(terms))};
    return true;
}

}  // namespace parser
