// What is told of a pixel sums up to it, in every scene that there is.
#include "render/app/run/scene_file.h"
#include "render/app/run/scene_reading.h"
#include "render/explain/pixel.h"
#include "render/kernel/gather/indirect_light.h"
#include "render/picture/passes/passes.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>

namespace {

namespace fs = std::filesystem;
using trace::RecordedGain;

constexpr int kWidth = 40, kHeight = 30;

bool same(const glm::vec3& a, const glm::vec3& b)
{
    for (int c = 0; c < 3; ++c)
        if (!(a[c] == b[c] || (a[c] != a[c] && b[c] != b[c]))) return false;
    return true;
}

/// What the explanations of all scenes have told of; a scene that is told without its effects is none.
struct Told {
    std::size_t pixels = 0, shadows = 0, maps = 0, lenses = 0;
    std::size_t gains[3] = {}, air[4] = {}, nodes[6] = {};

    void count(const trace::Record& record)
    {
        ++pixels;
        lenses += record.camera.size() > 1 ? 1 : 0;
        maps += record.entries.empty() ? 0 : 1;
        for (const trace::ShadeNode& node : record.nodes) ++nodes[static_cast<std::size_t>(node.kind)];
        for (const trace::RecordedRay& ray : record.rays) {
            for (const trace::RecordedAir& step : ray.air) ++air[static_cast<std::size_t>(step.effect)];
            for (const trace::RecordedLamp& lamp : ray.lamps) shadows += lamp.shadow.blocked > 0 ? 1 : 0;
            for (const trace::RecordedRow& row : ray.rows)
                for (const RecordedGain& gain : row.gains)
                    if (gain.source < 0) ++gains[-1 - gain.source];
        }
    }
};

void check_scene(const std::string& path, Told& told)
{
    INFO(path);
    app::Settings settings;
    settings.input_file = path;
    settings.width = kWidth;
    settings.height = kHeight;
    const std::atomic<bool> cancel = false;
    const app::SceneReading reading(settings, cancel);
    const parser::Result parsed = parser::parse_file(app::find_scene(settings), reading.options);
    plan::CompiledScene scene = plan::compile(parsed.scene, app::plan_options(settings));
    scene.options.antialiasing.method = 0;
    trace::RenderOptions options;
    const auto light = trace::run_passes(scene, options);
    options.indirect = light.get();
    image::Image picture;
    trace::render(scene, options, picture);
    for (const glm::ivec2& at : {glm::ivec2(20, 15), glm::ivec2(11, 22), glm::ivec2(30, 9), glm::ivec2(17, 27)}) {
        INFO("pixel " << at.x << "," << at.y);
        const explain::Pixel pixel = explain::explain_pixel(scene, options, at.x, at.y);
        const float* const rgb = picture.at(at.x, at.y);
        CHECK(same(pixel.rendered, {rgb[0], rgb[1], rgb[2]}));
        CHECK(same(pixel.sum, pixel.rendered));
        CHECK(explain::pixel_text(pixel, parsed.scene, scene, {0, 0, 0}).find("\nsum ") != std::string::npos);
        told.count(pixel.record);
    }
}

}  // namespace

TEST_CASE("what is told of a pixel sums up to it, to the last bit, in every scene", "[explain]")
{
    std::vector<std::string> scenes;
    for (const auto& entry : fs::recursive_directory_iterator(SOURCE_ROOT "/scenes"))
        if (entry.path().extension() == ".pov") scenes.push_back(entry.path().string());
    std::sort(scenes.begin(), scenes.end());
    REQUIRE(scenes.size() > 250);
    Told told;
    for (const std::string& scene : scenes) check_scene(scene, told);
    CHECK(told.pixels == 4 * scenes.size());
    CHECK(told.shadows > 0);
    CHECK(told.maps > 0);
    CHECK(told.lenses > 0);
    for (const std::size_t count : told.gains) CHECK(count > 0);
    for (const std::size_t count : told.air) CHECK(count > 0);
    for (const std::size_t count : told.nodes) CHECK(count > 0);
}
