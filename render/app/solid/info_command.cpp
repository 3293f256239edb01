#include "render/app/solid/info_command.h"

#include "render/app/options/command_line.h"
#include "render/app/options/ini_file.h"
#include "render/app/options/positive.h"
#include "render/app/run/frame_render.h"
#include "render/app/solid/bodies.h"
#include "render/solid/measure/measure.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <cmath>

namespace app {
namespace {

constexpr const char* kInfoUsage = R"(usage: whittle info SCENE [options]

Extent, volume, surface, centre of mass and inertia (of density 1, about the centre) of each object of a scene, from the parts of
rays inside of it. Each number has the amount that it may be off by.

  --object=NAME        of the object that was declared by this name, wherever it stands in the scene
  --precision=P        share of volume and surface that they may be off by; usual: 2e-4
  --json               one JSON object a line

Declare=, +L, Clock= and INI files are as for a render. Exit status: 0 done, 1 some object is not a body with an end, 2 cancelled.
)";

struct InfoRequest {
    BodyRequest bodies;
    double precision = 2e-4;
    bool json = false;
};

InfoRequest info_request(const std::vector<std::string>& arguments)
{
    InfoRequest request;
    read_default_ini_file(request.bodies.settings);
    std::vector<std::string> others;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        std::string value;
        if (take_value(arguments, i, {"--object"}, value)) request.bodies.object = value;
        else if (take_value(arguments, i, {"--precision"}, value))
            request.precision = whole_positive("--precision", value, 1.0);
        else if (arguments[i] == "--json") request.json = true;
        else others.push_back(arguments[i]);
    }
    apply_command_line(request.bodies.settings, others);
    if (request.bodies.settings.input_file.empty())
        throw OptionError("no scene given: whittle info scene.pov, or whittle info --help");
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

std::string quoted(const std::string& text)
{
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

std::string json_vector(const glm::dvec3& v) { return fmt::format("[{:.12g},{:.12g},{:.12g}]", v.x, v.y, v.z); }

void put_json(const std::string& name, const solid::Measures& m)
{
    fmt::print(
        "{{\"object\":{},\"lower\":{},\"upper\":{},\"extent_error\":{:.3g},\"volume\":{:.12g},\"volume_error\":{:.3g},"
        "\"surface\":{:.12g},\"surface_error\":{:.3g},\"centre\":{},\"centre_error\":{},\"inertia\":[{},{},{}],"
        "\"inertia_error\":{:.3g},\"rays\":{}}}\n",
        quoted(name), json_vector(m.extent.lower), json_vector(m.extent.upper), m.extent_error, m.volume.value,
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
    const int threads = request.bodies.settings.threads;
    std::optional<tbb::global_control> limit;
    if (threads > 0) limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    try {
        return info(request, cancel);
    } catch (...) {
        return tell_thrown();
    }
}

}  // namespace app
