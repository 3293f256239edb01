#include "csg/freeform/freeform.h"
#include "parser/grammar/core/solid_reader.h"

#include <algorithm>

/// reference manual: bicubic_patch; spec 5b, 5. Types 0 and 1 draw the same.
namespace parser {
namespace {

using scene::BicubicPatch;

/// The old way: numbers alone.
void read_old_numbers(SolidReader& s, BicubicPatch& patch)
{
    const auto next = [&](auto& to) {
        read_value(s.in(), to);
        s.in().accept_comma();
    };
    double type = 0.0;
    next(type);
    patch.type = whole_number(type);
    if (type == 2.0 || type == 3.0) next(patch.flatness);
    else patch.flatness = 0.1;
    next(patch.u_steps);
    next(patch.v_steps);
}

void read_numbers(SolidReader& s, BicubicPatch& patch)
{
    static constexpr auto kFields =
        std::tuple(field(Kind::Flatness, &BicubicPatch::flatness), field(Kind::USteps, &BicubicPatch::u_steps),
                   field(Kind::VSteps, &BicubicPatch::v_steps), field(Kind::Accuracy, &BicubicPatch::accuracy));
    bool typed = false;
    for (;;) {
        if (s.accept(Kind::Type)) {
            double type = float_expr(s.in());
            if (type >= 2.0) {
                s.in().warn(s.in().last(), "this type of patch is unknown: type 1 is taken");
                type = 1.0;
            }
            patch.type = whole_number(type);
            typed = true;
        } else if (!read_one(s, patch, kFields)) {
            break;
        }
        s.in().accept_comma();
    }
    if (!typed) s.fail("this bicubic_patch has no type");
    if (!s.accept(Kind::UvVectors)) return;
    read_values(s.in(), patch.uv[0], patch.uv[1], patch.uv[2], patch.uv[3]);
    patch.has_uv = true;
    s.in().accept_comma();
}

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

bool read_parameters(SolidReader& s, BicubicPatch& patch)
{
    if (s.next_kind() != Kind::Less && at_expression(s.in())) {
        s.in().warn(s.in().here(), "'type', 'flatness', 'u_steps' and 'v_steps' should name these numbers");
        read_old_numbers(s, patch);
    } else {
        read_numbers(s, patch);
    }
    read_value(s.in(), patch.points[0]);
    for (std::size_t k = 1; k < 16; ++k) {
        s.in().accept_comma();
        read_value(s.in(), patch.points[k]);
    }
    const csg::BicubicPatch described(input_of(patch), csg::BicubicPatch::Later::Divide);
    s.object().shape = scene::Freeform{
        csg::make_freeform_later(described, [input = described.input()] { return csg::BicubicPatch(input); })};
    return true;
}

}  // namespace parser
