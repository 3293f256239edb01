#include "parser/parse.h"
#include "render/lint/lint.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <fstream>
#include <thread>

namespace {

std::optional<std::string> text_of(const std::string& path)
{
    std::ifstream in(path, std::ios::binary);
    if (!in) return {};
    return std::string(std::istreambuf_iterator<char>(in), {});
}

std::vector<lint::Finding> findings_in(const std::string& path, const lint::Wanted& wanted = {})
{
    const parser::Result parsed = parser::parse_file(path, {});
    std::vector<lint::Finding> all = lint::check_text(path, parsed.scene.files, text_of, wanted);
    for (lint::Finding& finding : lint::check_messages(parsed.messages, text_of, wanted))
        all.push_back(std::move(finding));
    for (lint::Finding& finding : lint::check_scene(parsed.scene, text_of, wanted)) all.push_back(std::move(finding));
    return all;
}

std::string scene_path(std::string_view check, const char* kind)
{
    return std::string(LINT_SCENES) + "/" + std::string(check) + "." + kind + ".pov";
}

std::uint32_t marked_line(const std::string& path)
{
    std::ifstream in(path);
    std::string line;
    for (std::uint32_t number = 1; std::getline(in, line); ++number)
        if (line.find("// here") != std::string::npos) return number;
    return 0;
}

}  // namespace

TEST_CASE("every check names its scene, at its line, and nothing else", "[lint]")
{
    for (const lint::Check& check : lint::checks()) {
        const std::string path = scene_path(check.name, "bad");
        INFO(path);
        const std::vector<lint::Finding> found = findings_in(path);
        REQUIRE(found.size() == 1);
        CHECK(found[0].check == check.name);
        CHECK(found[0].message.place.path == path);
        CHECK(found[0].message.place.at.line == marked_line(path));
        CHECK(found[0].message.quote);
        CHECK(scene::message_text(found[0].message).find("[" + std::string(check.name) + "]") != std::string::npos);
    }
}

TEST_CASE("no check names the scene beside it", "[lint]")
{
    for (const lint::Check& check : lint::checks()) {
        const std::string path = scene_path(check.name, "good");
        INFO(path);
        for (const lint::Finding& finding : findings_in(path)) FAIL_CHECK(scene::message_text(finding.message));
    }
}

TEST_CASE("a check that is switched off says nothing", "[lint]")
{
    for (const lint::Check& check : lint::checks()) {
        const std::string path = scene_path(check.name, "bad");
        lint::Wanted wanted;
        wanted.off.emplace(check.name);
        CHECK(findings_in(path, wanted).empty());
    }
}

TEST_CASE("a loop without end is named by its line", "[lint]")
{
    std::atomic<bool> stop = false;
    parser::Options options;
    options.cancel = &stop;
    std::thread timer([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        stop = true;
    });
    parser::Message said;
    const auto keep = [](void* to, const parser::Message& m) { *static_cast<parser::Message*>(to) = m; };
    CHECK_THROWS_AS(
        parser::parse_text("#declare A = 1;\n#declare B = 2;\n#while (A < B)\n  #declare B = B + 1;\n#end\n", "t.pov",
                           options, keep, &said),
        parser::Cancelled);
    timer.join();
    const lint::Finding finding = lint::endless_loop(said, 0.2);
    CHECK(finding.message.place.at.line == 3);
    CHECK(finding.message.severity == scene::Severity::Warning);
}
