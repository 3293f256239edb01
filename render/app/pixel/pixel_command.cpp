#include "render/app/pixel/pixel_command.h"

#include "render/app/options/command_line.h"
#include "render/app/options/ini_file.h"
#include "render/app/pixel/pixel_answer.h"
#include "render/app/run/run.h"
#include "render/app/run/scene_file.h"
#include "render/app/run/scene_reading.h"
#include "render/app/run/stage_options.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>

namespace app {
namespace {

constexpr const char* kPixelUsage = R"(usage: whittle pixel SCENE X,Y [options]

Why a pixel has its colour: the tree of its rays, where each goes in and out of solids and at which line they stand, pigment, normal,
what each light gives, what was cut off and why. X and Y count from 0, from the top left.

All else is as for a render: +W +H, +L, Declare=, +K, +Q, --isa. Exit status: 0 done, 1 error, 2 cancelled.
)";

/// The numbers of "12,34"; nothing for other words.
std::optional<glm::ivec2> place_of(const std::string& word)
{
    glm::ivec2 at{0};
    const char* const end = word.data() + word.size();
    const auto [comma, first] = std::from_chars(word.data(), end, at.x);
    if (first != std::errc() || comma == end || *comma != ',') return {};
    const auto [rest, second] = std::from_chars(comma + 1, end, at.y);
    if (second != std::errc() || rest != end) return {};
    return at;
}

void print_message(void*, const scene::Message& message) { fmt::print(stderr, "{}\n", scene::message_text(message)); }

}  // namespace

std::string pixel_help() { return kPixelUsage; }

int pixel_command(const std::vector<std::string>& arguments, Cancellation& cancel)
{
    Settings settings;
    read_default_ini_file(settings);
    std::optional<glm::ivec2> at;
    std::vector<std::string> others;
    for (const std::string& word : arguments) {
        const auto place = place_of(word);
        if (place) at = place;
        else others.push_back(word);
    }
    apply_command_line(settings, others);
    if (settings.input_file.empty()) throw OptionError("no scene given: whittle pixel scene.pov 10,20");
    if (!at) throw OptionError("no pixel given: whittle pixel scene.pov 10,20");
    if (at->x < 0 || at->y < 0 || at->x >= settings.width || at->y >= settings.height)
        throw OptionError(
            fmt::format("pixel {},{} is not in a picture of {}x{}", at->x, at->y, settings.width, settings.height));
    const SceneReading reading(settings, cancel.requested);
    cancel.heeded = true;
    try {
        const parser::Result parsed = parser::parse_file(find_scene(settings), reading.options, print_message, nullptr);
        const PixelAnswer answer = pixel_answer(settings, parsed.scene, at->x, at->y, cancel.requested);
        if (cancel.requested) return kCancelled;
        fmt::print("{}", answer.text);
        return kSuccess;
    } catch (const parser::Cancelled&) {
        return kCancelled;
    } catch (const scene::Error& error) {
        for (const scene::Message& message : error.messages()) print_message(nullptr, message);
        return kError;
    }
}

}  // namespace app
