#include "csg/freeform/freeform.h"
#include "parser/grammar/core/solid_reader.h"

#include <algorithm>

/// reference manual: bicubic_patch; spec 5b, 5. Types 0 and 1 draw the same.
namespace parser {
namespace {

using scene::BicubicPatch;

struct PatchState : ParameterState<BicubicPatch> {
    using ParameterState::ParameterState;
    bool typed = false;
};
struct patch_type : item<Kind::Type, a_number, opt_comma> {
    static void act(PatchState& s)
    {
        double type = s.pop_float();
        if (type >= 2.0) {
            s.warn("this type of patch is unknown: type 1 is taken");
            type = 1.0;
        }
        s.solid.type = whole_number(type);
        s.typed = true;
    }
};
template <Kind kind, auto number>
using patch_number = seq<member<kind, number>, opt_comma>;
struct patch_numbers : pegtl::star<pegtl::sor<patch_type, patch_number<Kind::Flatness, &BicubicPatch::flatness>,
                                              patch_number<Kind::USteps, &BicubicPatch::u_steps>,
                                              patch_number<Kind::VSteps, &BicubicPatch::v_steps>,
                                              patch_number<Kind::Accuracy, &BicubicPatch::accuracy>>>,
                       item_base {
    static void act(PatchState& s)
    {
        if (!s.typed) s.fail("this bicubic_patch has no type");
    }
};
struct patch_corners
    : item<Kind::UvVectors, by_action<a_pair, opt_comma, a_pair, opt_comma, a_pair, opt_comma, a_pair>> {
    static void act(PatchState& s)
    {
        auto& uv = s.solid.uv;
        read_values(s.stream(), uv[0], uv[1], uv[2], uv[3]);
        s.solid.has_uv = true;
        s.stream().accept_comma();
    }
};
/// The old way: numbers alone. The flatness stands in types 2 and 3.
struct old_numbers : taker<old_numbers> {
    static bool take(TokenStream& in, PatchState& s)
    {
        if (in.peek().kind == Kind::Less || !at_expression(in)) return false;
        in.warn(in.here(), "'type', 'flatness', 'u_steps' and 'v_steps' should name these numbers");
        double type = 0.0;
        read_values(in, type);
        in.accept_comma();
        s.solid.type = whole_number(type);
        s.solid.flatness = 0.1;
        if (type == 2.0 || type == 3.0) {
            read_value(in, s.solid.flatness);
            in.accept_comma();
        }
        read_values(in, s.solid.u_steps, s.solid.v_steps);
        in.accept_comma();
        return true;
    }
    static Form form() { return Form::repeated(form_of<seq<a_number, opt_comma>>(), 1); }
};
struct patch_points : taker<patch_points>, always {
    static bool take(TokenStream& in, PatchState& s)
    {
        for (glm::dvec3& point : s.solid.points) {
            if (&point != &s.solid.points[0]) in.accept_comma();
            read_value(in, point);
        }
        if (!in.strictly_37()) in.accept_comma();
        return true;
    }
    static Form form() { return form_of<pegtl::rep<16, a_vector, opt_comma>>(); }
};
using patch_rule = seq<pegtl::sor<old_numbers, seq<patch_numbers, opt<patch_corners>>>, patch_points>;

csg::BicubicPatch::Input input_of(const BicubicPatch& patch)
{
    csg::BicubicPatch::Input input;
    input.flatness = patch.flatness;
    input.u_steps = std::clamp(patch.u_steps, 0, csg::BicubicPatch::kMostSteps);
    input.v_steps = std::clamp(patch.v_steps, 0, csg::BicubicPatch::kMostSteps);
    input.uv = patch.uv;
    for (std::size_t k = 0; k < 16; ++k) input.points[k / 4][k % 4] = patch.points[k];
    return input;
}

}  // namespace

Form parameters_form(const SolidReader*, const BicubicPatch*, Kind) { return form_of<patch_rule>(); }

bool read_parameters(SolidReader& s, BicubicPatch& patch)
{
    PatchState state(s, patch);
    read_solid<patch_rule>(state);
    const csg::BicubicPatch described(input_of(patch), csg::BicubicPatch::Later::Divide);
    s.object().shape = scene::Freeform{
        csg::make_freeform_later(described, [input = described.input()] { return csg::BicubicPatch(input); })};
    return true;
}

}  // namespace parser
