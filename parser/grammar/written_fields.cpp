#include "parser/grammar/statement.h"
#include "parser/stream/function.h"

#include <fmt/format.h>

/// Solids made of functions, components, coefficients or files (reference manual: blob, isosurface, parametric,
/// julia_fractal, height_field, text, bicubic_patch).
namespace parser {
namespace {

// ---- blob -----------------------------------------------------------------------------------------------------
void finish_component(StatementReader& s, std::string_view name, std::vector<StatementReader::Operand> operands)
{
    s.in().accept_comma();
    if (s.accept(Kind::Strength)) {}
    operands.emplace_back(float_expr(s.in()));
    scene::Object modified;
    read_component_modifiers(s.build(), modified);
    if (!modified.transform.identity()) operands.emplace_back(modified.transform);
    if (modified.texture) operands.emplace_back(modified.texture);
    s.add(name, std::move(operands));
}

bool read_component(StatementReader& s)
{
    const bool ball = s.in().peek().kind == Kind::Sphere;
    if (s.accept(Kind::Component)) {
        s.read("component", "ffv");
        return true;
    }
    if (!s.accept(Kind::Sphere) && !s.accept(Kind::Cylinder)) return false;
    const char* name = ball ? "sphere" : "cylinder";
    const auto opened = s.build().open_block(name);
    auto operands = s.operands(ball ? "vf" : "vvf");
    constexpr double kShortest = 1e-10;  // POV-Ray's (spec 5a, 5.11)
    if (!ball && glm::distance(std::get<glm::dvec3>(operands[0]), std::get<glm::dvec3>(operands[1])) < kShortest)
        s.fail("the two ends of this cylinder are one point");
    finish_component(s, name, std::move(operands));
    s.build().close_block(name, opened);
    return true;
}

void blob(StatementReader& s)
{
    static constexpr Form kForms[] = {{Kind::Threshold, "f"}, {Kind::Sturm, "o"}, {Kind::Hierarchy, "o"}};
    bool any = false;
    for (;;) {
        if (s.read_one(kForms)) continue;
        if (!read_component(s)) break;
        any = true;
    }
    if (!any) s.build().fail_unknown("a component of the blob: sphere or cylinder");
}

// ---- isosurface, parametric, julia ----------------------------------------------------------------------------
void contained_by(StatementReader& s)
{
    const auto opened = s.build().open_block("contained_by");
    if (s.accept(Kind::Sphere)) {
        const auto inner = s.build().open_block("sphere");
        s.read("contained_by sphere", "vf");
        s.build().close_block("sphere", inner);
    } else if (s.accept(Kind::Box)) {
        const auto inner = s.build().open_block("box");
        s.read("contained_by box", "vv");
        s.build().close_block("box", inner);
    } else {
        s.in().fail_expected("a sphere or box without modifiers");
    }
    s.build().close_block("contained_by", opened);
}

void read_function_operand(StatementReader& s)
{
    if (s.in().peek().kind != Kind::Function) s.in().fail_expected("'function' and its body");
    s.add("function", {read_function_value(s.in())});
}

void isosurface(StatementReader& s)
{
    static constexpr Form kForms[] = {{Kind::Threshold, "f"}, {Kind::Accuracy, "f"}, {Kind::MaxGradient, "f"},
                                      {Kind::Evaluate, "fff"}, {Kind::MaxTrace, "f"}, {Kind::AllIntersections, ""}, {Kind::Open, ""}};
    read_function_operand(s);
    for (;;) {
        if (s.accept(Kind::ContainedBy)) contained_by(s);
        else if (!s.read_one(kForms)) return;
    }
}

void parametric(StatementReader& s)
{
    for (int i = 0; i < 3; ++i) {
        if (i > 0) s.in().accept_comma();
        read_function_operand(s);
    }
    s.read("range", "pp");
    static constexpr Form kForms[] = {{Kind::Accuracy, "f"}, {Kind::MaxGradient, "f"}};
    for (;;) {
        if (s.accept(Kind::ContainedBy)) {
            contained_by(s);
        } else if (s.accept(Kind::Precompute)) {
            auto operands = s.operands("f");
            const auto at_axis = [&] {
                const Kind kind = s.in().peek().kind;
                return kind == Kind::X || kind == Kind::Y || kind == Kind::Z;
            };
            while (at_axis()) {
                operands.emplace_back(std::string(spelling(s.in().next().kind)));
                s.in().accept_comma();
            }
            s.add("precompute", std::move(operands));
        } else if (!s.read_one(kForms)) {
            return;
        }
    }
}

bool julia_function(Kind kind)
{
    switch (kind) {
    case Kind::Sqr: case Kind::Cube: case Kind::Exp: case Kind::Reciprocal: case Kind::Sin: case Kind::Asin: case Kind::Sinh:
    case Kind::Asinh: case Kind::Cos: case Kind::Acos: case Kind::Cosh: case Kind::Acosh: case Kind::Tan: case Kind::Atan:
    case Kind::Tanh: case Kind::Atanh: case Kind::Ln: case Kind::Pwr: return true;
    default: return false;
    }
}

void julia_fractal(StatementReader& s)
{
    static constexpr Form kForms[] = {{Kind::MaxIteration, "f"}, {Kind::Precision, "f"}, {Kind::Quaternion, ""}, {Kind::Hypercomplex, ""}};
    s.read("", "q");
    bool quaternion = true, sums_only = true;
    for (;;) {
        const Kind kind = s.in().peek().kind;
        if (s.accept(Kind::Slice)) {
            auto operands = s.operands("qf");
            if (glm::length(std::get<glm::dvec4>(operands[0])) == 0.0) s.fail("the slice's normal is zero");
            s.add("slice", std::move(operands));
        } else if (julia_function(kind)) {
            s.in().next();
            sums_only = kind == Kind::Sqr || kind == Kind::Cube;
            std::vector<StatementReader::Operand> operands;
            if (kind == Kind::Pwr) {
                s.in().expect(Kind::LeftParen, "'(' after pwr");
                operands = s.operands("ff");
                s.in().expect(Kind::RightParen, "')' after pwr's two numbers");
            }
            s.add(spelling(kind), std::move(operands));
        } else if (s.read_one(kForms)) {
            if (kind == Kind::Hypercomplex) quaternion = false;
            if (kind == Kind::Quaternion) quaternion = true;
        } else {
            break;
        }
    }
    if (quaternion && !sums_only) s.fail("a quaternion julia_fractal knows sqr and cube alone; see hypercomplex");
}

// ---- height_field, text, bicubic_patch ------------------------------------------------------------------------
void height_field(StatementReader& s)
{
    static constexpr Form kForms[] = {{Kind::WaterLevel, "f"}, {Kind::Smooth, "o"}, {Kind::Hierarchy, "o"}, {Kind::Premultiplied, "o"}};
    read_image_source(s, true);
    for (;;) {
        if (s.accept(Kind::Gamma)) {
            if (s.accept(Kind::Srgb)) s.add("gamma", {std::string("srgb")});
            else s.read("gamma", "f");
        } else if (!s.read_one(kForms)) {
            return;
        }
    }
}

void text(StatementReader& s)
{
    if (s.accept(Kind::Ttf)) {
        const scene::SourceRef at = s.in().here();
        const std::string name = path_expr(s.in());
        const std::string path = s.in().find_file(name, {".ttf", ".TTF"});
        if (path.empty()) s.in().fail(at, fmt::format("cannot find the font file '{}'", name));
        s.in().data_files().push_back(path);
        s.add("ttf", {path});
    } else if (s.accept(Kind::Internal)) {
        s.read("internal", "f");
    } else {
        s.in().fail_expected("'ttf' and a font's file, or 'internal' and a number");
    }
    s.in().accept_comma();
    s.read("", "sfv");
}

void bicubic_patch(StatementReader& s)
{
    static constexpr Form kForms[] = {{Kind::Flatness, "f"}, {Kind::USteps, "f"}, {Kind::VSteps, "f"}, {Kind::Accuracy, "f"}};
    bool typed = false;
    if (s.in().peek().kind != Kind::Less && at_expression(s.in())) {  // the old way: numbers alone
        s.in().warn(s.in().here(), "'type', 'flatness', 'u_steps' and 'v_steps' should name these numbers");
        const auto next = [&](std::string_view name) {
            const double value = float_expr(s.in());
            s.in().accept_comma();
            s.add(name, {value});
            return value;
        };
        const double type = next("type");
        if (type == 2.0 || type == 3.0) next("flatness");
        else s.add("flatness", {0.1});
        next("u_steps");
        next("v_steps");
        s.read("points", "vvvvvvvvvvvvvvvv");
        return;
    }
    for (;;) {
        if (s.accept(Kind::Type)) {
            double type = float_expr(s.in());
            if (type >= 2.0) {
                s.in().warn(s.in().last(), "this type of patch is unknown: type 1 is taken");
                type = 1.0;
            }
            s.add("type", {type});
            typed = true;
        } else if (!s.read_one(kForms)) {
            break;
        }
        s.in().accept_comma();
    }
    if (!typed) s.fail("this bicubic_patch has no type");
    if (s.accept(Kind::UvVectors)) s.read("uv_vectors", "pppp"), s.in().accept_comma();
    s.read("points", "vvvvvvvvvvvvvvvv");
}

}  // namespace

HeadReader field_head(Kind keyword)
{
    switch (keyword) {
    case Kind::Blob: return blob;
    case Kind::Isosurface: return isosurface;
    case Kind::Parametric: return parametric;
    case Kind::JuliaFractal: return julia_fractal;
    case Kind::HeightField: return height_field;
    case Kind::Text: return text;
    case Kind::BicubicPatch: return bicubic_patch;
    default: return nullptr;
    }
}

HeadReader written_head(Kind keyword)
{
    for (const auto head : {curve_head, polynomial_head, field_head})
        if (const HeadReader found = head(keyword)) return found;
    return nullptr;
}

}  // namespace parser
