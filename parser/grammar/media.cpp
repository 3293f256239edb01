#include "parser/grammar/statement.h"

/// media, density and rainbow: read whole, not drawn yet.
namespace parser {
namespace {

void scattering(StatementReader& s)
{
    constexpr int kHenyeyGreenstein = 5;
    StatementReader inner(s.build());
    inner.open();
    auto head = inner.operands("f");
    inner.in().accept_comma();
    if (at_color(inner.in())) head.emplace_back(rgb_expr(inner.in()));
    const int type = static_cast<int>(number_of(head[0]));
    if (type < 1 || type > kHenyeyGreenstein) s.in().warn(inner.statement().source, "this type of scattering is unknown");
    inner.add("", std::move(head));
    static constexpr Form kForms[] = {{Kind::Eccentricity, "f"}, {Kind::Extinction, "f"}};
    while (inner.read_one(kForms))
        if (inner.statement().items.back().name == "eccentricity" && type != kHenyeyGreenstein)
            s.fail("'eccentricity' needs scattering of type 5");
    inner.close();
    s.add("scattering", {inner.take()});
}

}  // namespace

scene::StatementPtr read_media(SceneBuilder& build)
{
    static constexpr Form kForms[] = {
        {Kind::Absorption, "c"}, {Kind::Emission, "c"}, {Kind::Method, "f", 1, 3.999}, {Kind::Intervals, "f", 1}, {Kind::Samples, "f,f"},
        {Kind::Confidence, "f"}, {Kind::Variance, "f"}, {Kind::Ratio, "f"}, {Kind::AaLevel, "f"}, {Kind::AaThreshold, "f"},
        {Kind::Jitter, "f"}, {Kind::Collect, "o"}};
    const auto guard = build.stream().nest();
    StatementReader s(build);
    s.open();
    if (const auto declared = accept_declared(build, "media")) s.add("media", {declared});
    for (;;) {
        if (s.accept(Kind::Scattering)) scattering(s);
        else if (s.accept(Kind::Density)) s.add("density", {read_density(build)});
        else if (!s.read_one(kForms) && !s.read_transform()) break;
    }
    s.close();
    return s.take();
}

scene::StatementPtr read_density(SceneBuilder& build)
{
    StatementReader s(build);
    s.statement().keyword = "density";
    s.open();
    scene::Pigment base;
    base.kind = scene::Color{1, 1, 1, 0, 0};
    s.add("", {std::make_shared<const scene::Pigment>(read_density_body(build, base))});
    s.close();
    return s.take();
}

scene::StatementPtr read_rainbow(SceneBuilder& build)
{
    static constexpr Form kForms[] = {{Kind::Direction, "v"}, {Kind::Angle, "f"}, {Kind::Width, "f"}, {Kind::Distance, "f"},
                                      {Kind::Jitter, "f"}, {Kind::Up, "v"}, {Kind::ArcAngle, "f"}, {Kind::FalloffAngle, "f"}};
    const auto guard = build.stream().nest();
    StatementReader s(build);
    s.open();
    if (const auto declared = accept_declared(build, "rainbow")) s.statement().items = declared->items;
    for (;;) {
        if (s.accept(Kind::ColorMap)) {
            scene::Pigment colors;
            scene::PatternedPigment gradient;
            gradient.pattern.name = "gradient";
            gradient.map = read_color_map(build);
            colors.kind = std::move(gradient);
            s.add("color_map", {std::make_shared<const scene::Pigment>(std::move(colors))});
        } else if (!s.read_one(kForms)) {
            break;
        }
    }
    const auto last = [&](std::string_view name, StatementReader::Operand value) {
        for (const scene::StatementItem& item : s.statement().items)
            if (item.name == name) value = item.operands.front();
        return value;
    };
    const auto direction = std::get<glm::dvec3>(last("direction", glm::dvec3(0)));
    const auto up = std::get<glm::dvec3>(last("up", glm::dvec3(0, 1, 0)));
    constexpr double kParallel = 1e-10;
    if (glm::length(direction) == 0.0) s.fail("this rainbow's direction is zero or missing");
    if (glm::length(glm::cross(direction, up)) < kParallel) s.fail("this rainbow's up and direction are parallel");
    if (number_of(last("arc_angle", 180.0)) < number_of(last("falloff_angle", 0.0)))
        s.fail("this rainbow's arc_angle is smaller than its falloff_angle");
    s.close();
    return s.take();
}

}  // namespace parser
