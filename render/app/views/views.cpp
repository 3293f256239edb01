#include "render/app/views/views.h"

#include "numbers/functions/functions.h"
#include "parser/parse.h"
#include "render/app/options/positive.h"
#include "render/app/output/output_name.h"
#include "render/app/views/pivot.h"
#include "render/app/views/view_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <numbers>

namespace app {
namespace {

using Kind = scene::Camera::Kind;

constexpr double kUsualCone = 35.0;               // degrees from the first view of a quilt to the last
constexpr double kUsualShareOfEyes = 1.0 / 30.0;  // eyes that far apart, of the distance, are looked at with ease
constexpr int kMostViews = 10'000;

/// "quilt=8x6,cone=40": a word, its value, and what follows it.
struct ViewWords {
    std::string word, value;
    double cone = kUsualCone;
    double eyes = 0.0, distance = 0.0;  ///< scene units; 0: not given
};

[[noreturn]] void wrong(const std::string& value)
{
    throw OptionError(
        "--views wants a file of cameras (JSON), quilt=8x6[,cone=35], stereo[,eyes=E] or turntable=36, each "
        "with [,distance=D], found '" +
        value + "'");
}

ViewWords words_in(const std::string& value)
{
    ViewWords out;
    for (std::size_t at = 0, number = 0; at <= value.size(); ++number) {
        const std::size_t end = std::min(value.find(',', at), value.size());
        const std::string part = value.substr(at, end - at);
        const std::size_t equals = std::min(part.find('='), part.size());
        const std::string name = part.substr(0, equals), given = part.substr(std::min(equals + 1, part.size()));
        at = end + 1;
        if (number == 0) {
            out.word = name;
            out.value = given;
        } else if (name == "cone" && out.word == "quilt") {
            out.cone = whole_positive("cone of --views=quilt", given, 170.0);
        } else if (name == "eyes" && out.word == "stereo") {
            out.eyes = whole_positive("eyes of --views=stereo", given);
        } else if (name == "distance") {
            out.distance = whole_positive("distance of --views", given);
        } else {
            wrong(value);
        }
    }
    return out;
}

/// A whole number from 1 on at the beginning of the text, which is taken from it; 0 where there is none.
int taken_count(std::string_view& text)
{
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || number < 1 || number > kMostViews) return 0;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

/// The camera beside itself, its picture's frame in the distance held where it is: what lies there stays in its place
/// from view to view. A frustum that is sheared, not turned.
scene::Camera beside(const scene::Camera& camera, double aside, double distance)
{
    scene::Camera out = camera;
    const glm::dvec3 step = aside * glm::normalize(camera.right);
    out.location += step;
    out.direction -= glm::length(camera.direction) / distance * step;
    return out;
}

/// The camera turned about the sky vector through a point, as `rotate` turns.
scene::Camera turned(const scene::Camera& camera, const glm::dvec3& pivot, double degrees)
{
    const double angle = degrees * std::numbers::pi / 180.0, c = numbers::cos(angle), s = numbers::sin(angle);
    const glm::dvec3 axis = glm::normalize(camera.sky);
    const auto turn = [&](const glm::dvec3& v) {
        return c * v + s * glm::cross(axis, v) + (1.0 - c) * glm::dot(axis, v) * axis;
    };
    scene::Camera out = camera;
    out.location = pivot + turn(camera.location - pivot);
    out.direction = turn(camera.direction);
    out.right = turn(camera.right);
    out.up = turn(camera.up);
    return out;
}

void want_flat(const scene::Camera& camera, const std::string& word)
{
    if (camera.kind != Kind::Perspective && camera.kind != Kind::Orthographic)
        throw OptionError(
            fmt::format("--views={} is for perspective and orthographic cameras: only they have a frame in "
                        "the distance",
                        word));
}

SceneViews quilt(const ViewWords& words, const std::string& value, const Settings& settings,
                 const scene::Camera& camera, double distance)
{
    std::string_view rest = words.value;
    const int columns = taken_count(rest);
    const bool by = rest.starts_with('x');
    if (by) rest.remove_prefix(1);
    const int rows = by ? taken_count(rest) : 0;
    if (columns == 0 || rows == 0 || !rest.empty() || columns * rows < 2 || columns * rows > kMostViews) wrong(value);
    want_flat(camera, words.word);
    const double travel = 2.0 * distance * numbers::tan(words.cone * std::numbers::pi / 360.0);
    SceneViews out;
    const int count = columns * rows;
    for (int i = 0; i < count; ++i)
        out.views.push_back(
            {fmt::format("{:02}", i + 1),
             camera_statement(beside(camera, travel * (static_cast<double>(i) / (count - 1) - 0.5), distance))});
    out.sheet =
        SheetForm{columns, rows, true,
                  fmt::format("_qs{}x{}a{:.6g}", columns, rows, static_cast<double>(settings.width) / settings.height)};
    return out;
}

SceneViews stereo(const ViewWords& words, const scene::Camera& camera, double distance)
{
    want_flat(camera, words.word);
    const double eyes = words.eyes > 0.0 ? words.eyes : kUsualShareOfEyes * distance;
    SceneViews out;
    out.views = {{"left", camera_statement(beside(camera, -0.5 * eyes, distance))},
                 {"right", camera_statement(beside(camera, 0.5 * eyes, distance))}};
    out.sheet = SheetForm{2, 1, false, {}};
    return out;
}

SceneViews turntable(const ViewWords& words, const std::string& value, const scene::Camera& camera, double distance)
{
    std::string_view rest = words.value;
    const int count = taken_count(rest);
    if (count == 0 || !rest.empty()) wrong(value);
    if (glm::length(camera.sky) == 0.0)
        throw OptionError("--views=turntable turns about the camera's sky vector, which is 0");
    const glm::dvec3 pivot = camera.location + distance * glm::normalize(camera.direction);
    const std::size_t digits = std::max<std::size_t>(2, std::to_string(count).size());
    SceneViews out;
    for (int i = 0; i < count; ++i)
        out.views.push_back({fmt::format("{:0{}}", i + 1, digits),
                             camera_statement(i == 0 ? camera : turned(camera, pivot, 360.0 * i / count))});
    return out;
}

}  // namespace

bool is_view_words(const std::string& value)
{
    return value.starts_with("quilt=") || value == "stereo" || value.starts_with("stereo,") ||
           value.starts_with("turntable=");
}

SceneViews views_of(const Settings& settings, const scene::Camera& camera, const plan::CompiledScene& compiled)
{
    const std::string& value = settings.views;
    camera_statement(camera);  // one that cannot be turned is told before all else
    if (!is_view_words(value)) return views_in_file(value, settings);
    const ViewWords words = words_in(value);
    const double distance = words.distance > 0.0 ? words.distance : pivot_distance(compiled);
    if (words.word == "quilt") return quilt(words, value, settings, camera, distance);
    if (words.word == "stereo") return stereo(words, camera, distance);
    return turntable(words, value, camera, distance);
}

scene::Camera camera_of(const SceneView& view, const Settings& settings, const scene::Description& description)
{
    parser::Options options;
    options.image_width = settings.width;
    options.image_height = settings.height;
    options.povray = description.povray;
    const std::string text =
        fmt::format("#version {}.{:02};\n{}", description.version / 100, description.version % 100, view.text);
    return parser::parse_text(text, fmt::format("view {}", view.name), options).scene.camera;
}

void refuse_views(const Settings& settings)
{
    if (is_view_words(settings.views)) words_in(settings.views);
    if (settings.shards > 0 || settings.prepare)
        throw OptionError("--views goes with whole pictures: --shard and --prepare are for one");
    if (settings.radiosity_to_file)
        throw OptionError("--views does not go with Radiosity_To_File: each view would write over the one before");
    if (!settings.preview_file.empty())
        throw OptionError("--views does not go with --preview, which shows one picture");
}

std::string view_path(const std::string& picture, const SceneView& view)
{
    if (picture.empty()) return {};
    const std::size_t dot = picture.rfind('.');
    return picture.substr(0, dot) + "." + view.name + picture.substr(dot);
}

}  // namespace app
