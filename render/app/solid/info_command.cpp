#include "render/app/solid/info_command.h"

#include "render/app/options/command_line.h"
#include "render/app/options/ini_file.h"
#include "render/app/options/positive.h"
#include "render/app/run/stage_options.h"
#include "render/app/run/run.h"
#include "render/app/report/json_writer.h"
#include "render/app/solid/bodies.h"
#include "render/app/solid/part_file.h"
#include "render/app/solid/section_run.h"
#include "render/solid/measure/measure.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <cmath>
#include <optional>

namespace app {
namespace {

constexpr const char* kInfoUsage = R"(usage: whittle info SCENE [options]
       whittle info SCENE --section=AXIS,VALUE -o FILE.svg|.dxf [options]

Extent, volume, surface, centre of mass and inertia (of density 1, about the centre) of each object of a scene, from the parts of
rays inside of it. Each number has the amount that it may be off by.

  --object=NAME        of the object that was declared by this name, wherever it stands in the scene
  --precision=P        share of volume and surface that they may be off by; usual: 2e-4
  --json               one JSON object a line

A cut by a plane, as a drawing of its own:

  --section=AXIS,VALUE of the objects by the plane in which x, y or z has that value, as in y,0.5
  -o FILE              the drawing; more than one may be given
  --tolerance=T        scene units (a unit is a millimetre) that it may be off by; usual: 0.01
  --seconds=S          after which an object's cut is not refined any more; usual: 60

Declare=, +L, Clock= and INI files are as for a render. Exit status: 0 done, 1 some object is not a body with an end, no object was cut
or a cut is farther off than it may be, 2 cancelled.
)";

struct InfoRequest {
    BodyRequest bodies;
    double precision = 2e-4;
    bool json = false;
    std::optional<SectionRequest> section;
};

InfoRequest info_request(const std::vector<std::string>& arguments)
{
    InfoRequest request;
    SectionRequest section;
    std::string plane, of_measures, of_section;  // words that belong to one of the two alone
    read_default_ini_file(request.bodies.settings);
    std::vector<std::string> others;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        std::string value;
        const std::string word = arguments[i].substr(0, arguments[i].find('='));
        if (take_value(arguments, i, {"--object"}, value)) request.bodies.object = value;
        else if (take_value(arguments, i, {"--precision"}, value)) {
            request.precision = whole_positive("--precision", value, 1.0);
            of_measures = word;
        } else if (take_value(arguments, i, {"--section"}, plane)) {
            section.plane = cutting_plane(plane);
        } else if (take_value(arguments, i, {"-o", "--out"}, value)) {
            section.out.push_back(value);
            of_section = word;
        } else if (take_value(arguments, i, {"--tolerance"}, value)) {
            section.tolerance = whole_positive("--tolerance", value);
            of_section = word;
        } else if (take_value(arguments, i, {"--seconds"}, value)) {
            section.seconds = whole_positive("--seconds", value);
            of_section = word;
        } else if (arguments[i] == "--json") request.json = true;
        else others.push_back(arguments[i]);
    }
    apply_command_line(request.bodies.settings, others);
    if (request.bodies.settings.input_file.empty())
        throw OptionError("no scene given: whittle info scene.pov, or whittle info --help");
    if (plane.empty() && !of_section.empty())
        throw OptionError(of_section + " wants a --section, as in --section=y,0.5");
    if (plane.empty()) return request;
    if (!of_measures.empty()) throw OptionError(of_measures + " does not go with --section");
    if (section.out.empty()) throw OptionError("where to? whittle info scene.pov --section=y,0.5 -o cut.svg (or .dxf)");
    for (const std::string& out : section.out) solid::drawing_format_of(out);
    section.json = request.json;
    request.section = section;
    return request;
}

/// A number with as many digits as its error leaves.
std::string with_error(double value, double error)
{
    const int digits = error > 0.0 ? static_cast<int>(std::ceil(1.0 - std::log10(error))) : 9;
    return fmt::format("{:.{}f} +- {:.2g}", value, std::clamp(digits, 0, 12), error);
}

std::string vector_text(const glm::dvec3& v, double error)
{
    const int digits = error > 0.0 ? static_cast<int>(std::ceil(1.0 - std::log10(error))) : 9;
    const int d = std::clamp(digits, 0, 9);
    return fmt::format("<{:.{}f}, {:.{}f}, {:.{}f}>", v.x + 0.0, d, v.y + 0.0, d, v.z + 0.0, d);
}

void put_text(const std::string& name, const solid::Measures& m)
{
    const double off = std::max(m.centre_error.x, std::max(m.centre_error.y, m.centre_error.z));
    fmt::print("{}\n", name);
    fmt::print("  extent   {} to {} +- {:.2g}\n", vector_text(m.extent.lower, m.extent_error),
               vector_text(m.extent.upper, m.extent_error), m.extent_error);
    fmt::print("  volume   {}\n", with_error(m.volume.value, m.volume.error));
    fmt::print("  surface  {}\n", with_error(m.surface.value, m.surface.error));
    fmt::print("  centre   {} +- {:.2g}\n", vector_text(m.centre, off), off);
    for (int row = 0; row < 3; ++row)
        fmt::print("  {:<7}  {}{}\n", row == 0 ? "inertia" : "",
                   vector_text({m.inertia[0][row], m.inertia[1][row], m.inertia[2][row]}, m.inertia_error),
                   row == 0 ? fmt::format(" +- {:.2g}", m.inertia_error) : "");
    fmt::print("  rays     {}\n", m.rays);
}

std::string json_vector(const glm::dvec3& v) { return fmt::format("[{:.12g},{:.12g},{:.12g}]", v.x, v.y, v.z); }

void put_json(const std::string& name, const solid::Measures& m)
{
    fmt::print(
        "{{\"object\":{},\"lower\":{},\"upper\":{},\"extent_error\":{:.3g},\"volume\":{:.12g},\"volume_error\":{:.3g},"
        "\"surface\":{:.12g},\"surface_error\":{:.3g},\"centre\":{},\"centre_error\":{},\"inertia\":[{},{},{}],"
        "\"inertia_error\":{:.3g},\"rays\":{}}}\n",
        json_quoted(name), json_vector(m.extent.lower), json_vector(m.extent.upper), m.extent_error, m.volume.value,
        m.volume.error, m.surface.value, m.surface.error, json_vector(m.centre), json_vector(m.centre_error),
        json_vector(m.inertia[0]), json_vector(m.inertia[1]), json_vector(m.inertia[2]), m.inertia_error, m.rays);
}

int info(const InfoRequest& request, Cancellation& cancel)
{
    const BodyScene scene = read_bodies(request.bodies, cancel);
    int status = kSuccess;
    for (const NamedObject& named : scene.objects) {
        try {
            const solid::Body body(*named.object, scene.description.global);
            solid::MeasureOptions options;
            options.precision = request.precision;
            options.cancel = &cancel.requested;
            const solid::Measures found = solid::measure(body, options);
            if (request.json) put_json(named.name, found);
            else put_text(named.name, found);
        } catch (const solid::NoBody& why) {
            fmt::print(stderr, "{}: not a body: {}\n", named.name, why.what());
            status = kError;
        }
    }
    if (scene.objects.empty()) fmt::print(stderr, "the scene has no objects\n");
    return status;
}

}  // namespace

std::string info_help() { return kInfoUsage; }

int info_command(const std::vector<std::string>& arguments, Cancellation& cancel)
{
    const InfoRequest request = info_request(arguments);
    cancel.heeded = true;
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads_of(request.bodies.settings)));
    try {
        if (request.section) return draw_section(request.bodies, *request.section, cancel);
        return info(request, cancel);
    } catch (...) {
        return tell_thrown();
    }
}

}  // namespace app
