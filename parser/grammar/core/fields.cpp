#include "csg/freeform/freeform.h"
#include "function/field/field.h"
#include "parser/grammar/core/solid_reader.h"
#include "parser/stream/functions/function.h"

#include <algorithm>

/// Solids made of functions (reference manual: isosurface, parametric).
namespace parser {
namespace {

constexpr std::uint32_t kCoordinates = 3;

/// `function { ... }` or the name of one.
function::FunctionPtr read_function(TokenStream& in)
{
    if (in.peek().kind != Kind::Function) in.fail_expected("'function' and its body");
    return read_function_value(in);
}
struct function_form {
    static Form form() { return Form::named(function_value); }
};

/// Null: it wants more than a point.
std::shared_ptr<const csg::Field> field_of(const function::FunctionPtr& function, bool negated = false)
{
    if (function->parameters > kCoordinates) return nullptr;
    return std::make_shared<const function::FunctionField>(function, nullptr, negated);
}

using scene::Container;
/// A solid without modifiers.
struct ContainerState : BlockState {
    ContainerState(SceneBuilder& b, Container& c) : BlockState(b), container(c) {}
    Container& container;
};
struct container_sphere : seq<a_vector, opt_comma, a_number>, item_base {
    static void act(ContainerState& s)
    {
        s.container.radius = s.pop_float();
        s.container.center = s.pop_vector();
    }
};
struct container_box : seq<a_vector, opt_comma, a_vector>, item_base {
    static void act(ContainerState& s)
    {
        s.container.corner[1] = s.pop_vector();
        s.container.corner[0] = s.pop_vector();
    }
};
template <Kind keyword, Container::Kind kind, class Values>
struct container : item<keyword, by_action<block<keyword, no_items, Values>>> {
    static void act(ContainerState& s)
    {
        block<keyword, no_items, Values>::read(s.build, s);
        s.container.kind = kind;
    }
};
struct container_solid : pegtl::sor<container<Kind::Sphere, Container::Kind::Sphere, container_sphere>,
                                    container<Kind::Box, Container::Kind::Box, container_box>> {};
using ContainerBlock = block<Kind::ContainedBy, no_items, container_solid>;
struct contained_by : item<Kind::ContainedBy, by_action<ContainerBlock>> {
    template <class State>
    static void act(State& s)
    {
        ContainerState inner(s.build, s.solid.container);
        ContainerBlock::read(s.build, inner);
    }
};

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

using scene::Isosurface;
using scene::Parametric;
using IsosurfaceState = ParameterState<Isosurface>;
struct field_function : taker<field_function>, always {
    static bool take(TokenStream& in, IsosurfaceState& s)
    {
        s.solid.function = read_function(in);
        return true;
    }
    static Form form() { return function_form::form(); }
};
struct evaluate : item<Kind::Evaluate, a_number, opt_comma, a_number, opt_comma, a_number> {
    static void act(IsosurfaceState& s)
    {
        glm::dvec3& growth = s.solid.evaluate.emplace();
        for (int i = 3; i-- > 0;) growth[i] = s.pop_float();
    }
};
struct max_trace : item<Kind::MaxTrace, a_number> {
    static void act(IsosurfaceState& s)
    {
        s.solid.max_trace = std::clamp(s.pop_int(), 1, Isosurface::kMostTraced);
        s.solid.all_intersections = false;
    }
};
struct all_intersections : item<Kind::AllIntersections> {
    static void act(IsosurfaceState& s)
    {
        s.solid.max_trace = Isosurface::kMostTraced;
        s.solid.all_intersections = true;
    }
};
using isosurface_rule =
    seq<field_function,
        pegtl::star<pegtl::sor<
            contained_by, evaluate, max_trace, all_intersections, member<Kind::Threshold, &Isosurface::threshold>,
            member<Kind::Accuracy, &Isosurface::accuracy>, member<Kind::MaxGradient, &Isosurface::max_gradient>,
            word<Kind::Open, &Isosurface::open>, member<Kind::Polarity, &Isosurface::polarity>>>>;

struct ParametricState : ParameterState<Parametric> {
    using ParameterState::ParameterState;
    std::optional<double> levels;
};
struct surface_functions : taker<surface_functions>, always {
    static bool take(TokenStream& in, ParametricState& s)
    {
        for (std::size_t i = 0; i < 3; ++i) {
            if (i > 0) in.accept_comma();
            s.solid.function[i] = read_function(in);
        }
        read_values(in, s.solid.range[0], s.solid.range[1]);
        return true;
    }
    static Form form()
    {
        return form_of<
            seq<function_form, opt_comma, function_form, opt_comma, function_form, a_pair, opt_comma, a_pair>>();
    }
};
struct axis : any_token<Kind::X, Kind::Y, Kind::Z>, item_base {
    static void act(ParametricState& s) { s.solid.precomputed += spelling(s.stream().taken_last().kind); }
};
struct levels : a_number, item_base {
    static void act(ParametricState& s)
    {
        s.levels = s.pop_float();
        s.solid.precomputed.clear();
    }
};
struct precompute : pegtl::if_must<token<Kind::Precompute>, levels, pegtl::star<axis, opt_comma>> {};
using parametric_rule =
    seq<surface_functions,
        pegtl::star<pegtl::sor<contained_by, precompute, member<Kind::Accuracy, &Parametric::accuracy>,
                               member<Kind::MaxGradient, &Parametric::max_gradient>>>>;

}  // namespace

template <>
inline constexpr auto expected<levels> = "the number of levels";
template <>
inline constexpr auto expected<container_sphere> = "the centre and the radius";
template <>
inline constexpr auto expected<container_box> = "two corners";
template <>
inline constexpr auto expected<container_solid> = "a sphere or box without modifiers";

Form parameters_form(const SolidReader*, const Isosurface*, Kind) { return form_of<isosurface_rule>(); }
Form parameters_form(const SolidReader*, const Parametric*, Kind) { return form_of<parametric_rule>(); }

bool read_parameters(SolidReader& s, Isosurface& surface)
{
    read_solid<isosurface_rule>(s, surface);
    csg::IsosurfaceTerms terms;
    const bool above = surface.polarity > 0.0;  // what is below the threshold's opposite, of the function's
    terms.field = field_of(surface.function, above);
    if (!terms.field) return false;
    need_positive(s, "accuracy", surface.accuracy, Isosurface().accuracy);
    need_positive(s, "max_gradient", surface.max_gradient, Isosurface().max_gradient);
    terms.threshold = above ? -surface.threshold : surface.threshold;
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

bool read_parameters(SolidReader& s, Parametric& surface)
{
    constexpr double kMostLevels = 20.0;
    ParametricState state(s, surface);
    read_solid<parametric_rule>(state);
    const std::optional<double>& levels = state.levels;
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
