#include "parser/grammar/statement.h"

/// Blocks of effects that are read whole and not computed yet: radiosity, photons, subsurface, and what a camera may hold.
namespace parser {
namespace {

/// A file's name that belongs on the command line since version 3.7.
void warn_files(StatementReader& s, const scene::Statement& statement)
{
    for (const scene::StatementItem& item : statement.items)
        if (item.name == "save_file" || item.name == "load_file")
            s.in().warn(statement.source, item.name + " is ignored: such files are named on the command line");
}

}  // namespace

scene::StatementPtr read_global_radiosity(SceneBuilder& build)
{
    static constexpr Form kForms[] = {
        {Kind::AdcBailout, "f", 0, 1e300, true}, {Kind::AlwaysSample, "f"}, {Kind::Brightness, "f", 0, 1e300, true},
        {Kind::Count, "f,f", 0, 1e300, true}, {Kind::ErrorBound, "f", 0, 1e300, true}, {Kind::GrayThreshold, "f", 0, 1},
        {Kind::LowErrorFactor, "f", 0, 1e300, true}, {Kind::MaxSample, "f"}, {Kind::MaximumReuse, "f", 0, 1e300, true},
        {Kind::Media, "f"}, {Kind::MinimumReuse, "f", 0}, {Kind::NearestCount, "f,f", 1, 20}, {Kind::Normal, "f"},
        {Kind::PretraceStart, "f", 0, 1, true}, {Kind::PretraceEnd, "f", 0, 1, true}, {Kind::RecursionLimit, "f", 1, 20},
        {Kind::Subsurface, "f"}, {Kind::SaveFile, "t"}, {Kind::LoadFile, "t"}};
    StatementReader s(build);
    s.open();
    s.read_all(kForms);
    double least = 0.015, most = -1.0;
    for (const scene::StatementItem& item : s.statement().items) {
        if (item.name == "minimum_reuse") least = number_of(item.operands[0]);
        if (item.name == "maximum_reuse") most = number_of(item.operands[0]);
    }
    if (most >= 0.0 && most <= least) s.fail("'maximum_reuse' must be above 'minimum_reuse'");
    warn_files(s, s.statement());
    s.close();
    return s.take();
}

scene::StatementPtr read_global_photons(SceneBuilder& build)
{
    static constexpr Form kForms[] = {
        {Kind::Radius, ",f,f,f,f"}, {Kind::Spacing, "f"}, {Kind::Count, "f"}, {Kind::Gather, "ff"}, {Kind::Media, "f,f"},
        {Kind::Autostop, "f"}, {Kind::Jitter, "f"}, {Kind::AdcBailout, "f"}, {Kind::MaxTraceLevel, "f"},
        {Kind::ExpandThresholds, "ff"}, {Kind::SaveFile, "t"}, {Kind::LoadFile, "t"}};
    return read_forms(build, kForms);
}

scene::StatementPtr read_global_subsurface(SceneBuilder& build)
{
    static constexpr Form kForms[] = {{Kind::Samples, "ff"}, {Kind::Radiosity, "f"}};
    return read_forms(build, kForms);
}

scene::StatementPtr read_object_photons(SceneBuilder& build)
{
    static constexpr Form kForms[] = {{Kind::Target, "o"}, {Kind::Reflection, "f"}, {Kind::Refraction, "f"}, {Kind::Collect, "f"},
                                      {Kind::PassThrough, "o"}};
    return read_forms(build, kForms);
}

scene::StatementPtr read_light_photons(SceneBuilder& build)
{
    static constexpr Form kForms[] = {{Kind::Refraction, "f"}, {Kind::Reflection, "f"}, {Kind::AreaLight, ""}};
    return read_forms(build, kForms);
}

scene::StatementPtr read_object_radiosity(SceneBuilder& build)
{
    static constexpr Form kForms[] = {{Kind::Importance, "f", 0, 1, true}};
    return read_forms(build, kForms);
}

scene::StatementPtr read_finish_subsurface(SceneBuilder& build)
{
    static constexpr Form kForms[] = {{Kind::Translucency, "c"}, {Kind::Anisotropy, "f"}};
    return read_forms(build, kForms);
}

scene::StatementPtr read_mesh_camera(SceneBuilder& build)
{
    constexpr int kMostMethods = 3;
    StatementReader s(build);
    s.open();
    auto head = s.operands("ff");
    if (static_cast<int>(number_of(head[0])) == 0) s.fail("the rays per pixel of a mesh_camera must not be 0");
    const double method = number_of(head[1]);
    if (!(method >= 0 && method < kMostMethods + 1)) s.fail("the distribution of a mesh_camera must lie from 0 to 3");
    s.add("", std::move(head));
    s.in().accept_comma();
    if (at_expression(s.in())) s.read("max_distance", "f");
    bool any = false;
    for (;; any = true) {
        s.in().accept_comma();
        if (s.accept(Kind::Mesh)) s.add("mesh", {std::make_shared<const scene::Object>(read_mesh(build, s.in().last()))});
        else if (s.accept(Kind::Mesh2)) s.add("mesh2", {std::make_shared<const scene::Object>(read_mesh2(build, s.in().last()))});
        else break;
    }
    if (!any) build.fail_unknown("a mesh");
    static constexpr Form kForms[] = {{Kind::Smooth, ""}};
    s.read_one(kForms);
    s.close();
    return s.take();
}

scene::StatementPtr read_bokeh(SceneBuilder& build)
{
    StatementReader s(build);
    s.open();
    if (s.accept(Kind::Pigment))
        s.add("pigment", {std::make_shared<const scene::Pigment>(read_pigment(build, build.default_layer().pigment))});
    s.close();
    return s.take();
}

}  // namespace parser
