#include "render/app/options/own_options.h"

#include "render/app/options/nearest.h"
#include "render/app/options/positive.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace app {

namespace {

void set_dump(Settings& s, const std::string& value)
{
    using Dump = Settings::Dump;
    s.dump = value == "tokens"  ? Dump::Tokens
             : value == "scene" ? Dump::Scene
             : value == "plan"  ? Dump::Plan
                                : Dump::Views;
}

void set_state_after(Settings& s, const std::string& value)
{
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), s.state_after);
    if (error != std::errc() || end != value.data() + value.size() || s.state_after < 0.0)
        throw OptionError("--state-after wants seconds, found '" + value + "'");
}

void set_memory(Settings& s, const std::string& value)
{
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), s.memory);
    if (error != std::errc() || end != value.data() + value.size() || !(s.memory > 0.0))
        throw OptionError("--memory wants MB, found '" + value + "'");
    s.memory *= 1e6;
}

void set_samples(Settings& s, const std::string& value)
{
    constexpr double kMost = 65536.0;
    std::string rest;
    const double number = positive("--samples", value, kMost, rest);
    if (rest == "%" || rest == "%error") s.samples_error = 2.55 * number;
    else if (rest.empty() && number == std::floor(number)) s.samples = static_cast<int>(number);
    else throw OptionError("--samples wants a whole number of samples or an error in percent, found '" + value + "'");
}

void set_error(Settings& s, const std::string& value) { s.error = whole_positive("--error", value, 255.0); }

void set_time(Settings& s, const std::string& value)
{
    constexpr double kMost = 1e6;
    std::string rest;
    s.time = positive("--time", value, kMost, rest);
    if (rest == "m" || rest == "min") s.time *= 60.0;
    else if (rest == "h") s.time *= 3600.0;
    else if (!rest.empty() && rest != "s")
        throw OptionError("--time wants seconds, or minutes with m, hours with h, found '" + value + "'");
}

void set_seed(Settings& s, const std::string& value)
{
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), s.seed);
    if (error != std::errc() || end != value.data() + value.size())
        throw OptionError("--seed wants a whole number from 0 to 4294967295, found '" + value + "'");
}

constexpr const char* kFrameForms = "--frames wants numbers and ranges that go up, as in 2,4,10-20 or 1-99:2, found '";

/// A number at the beginning of `text`, which is taken from it; below 0 where there is none.
int taken_number(std::string_view& text)
{
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return -1;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

bool taken(std::string_view& text, char sign)
{
    if (!text.starts_with(sign)) return false;
    text.remove_prefix(1);
    return true;
}

void set_frames(Settings& s, const std::string& value)
{
    s.frame_list.clear();
    std::string_view rest = value;
    do {
        FrameRange range{taken_number(rest), 0, 1};
        range.last = taken(rest, '-') ? taken_number(rest) : range.first;
        if (taken(rest, ':')) range.step = taken_number(rest);
        if (range.first < 0 || range.last < range.first || range.step < 1) throw OptionError(kFrameForms + value + "'");
        s.frame_list.push_back(range);
    } while (taken(rest, ','));
    if (!rest.empty()) throw OptionError(kFrameForms + value + "'");
}

void set_progress(Settings& s, const std::string& value)
{
    using enum ProgressLines;
    s.progress = value == "povray" ? Povray : value == "json" ? Json : OpenJd;
}

void set_shard(Settings& s, const std::string& value)
{
    constexpr int kMost = 1'000'000;
    const char* const last = value.data() + value.size();
    const auto [slash, error] = std::from_chars(value.data(), last, s.shard);
    const bool has_slash = error == std::errc() && slash != last && *slash == '/';
    const auto [end, other] = has_slash ? std::from_chars(slash + 1, last, s.shards)
                                        : std::from_chars_result{slash, std::errc::invalid_argument};
    if (other != std::errc() || end != last || s.shard < 1 || s.shard > s.shards || s.shards > kMost)
        throw OptionError("--shard wants a part and their number, as in 3/16, found '" + value + "'");
}

/// In the order in which texts show them.
constexpr OwnOption kOwnOptions[] = {
    {"check", "", "read the scene, tell its errors and warnings, and stop; files that it would write are left alone",
     [](Settings& s, const std::string&) { s.parse_only = s.check = true; }},
    {"parse-only", "", "read the scene as for a render, and stop",
     [](Settings& s, const std::string&) { s.parse_only = true; }},
    {"deps", "", "print the files that the scene is made of, one a line, and stop",
     [](Settings& s, const std::string&) { s.parse_only = s.deps = true; }},
    {"json", "FILE",
     "write what was done as JSON: options, phases, counts, memory, messages, pictures; - is standard output",
     [](Settings& s, const std::string& v) { s.json_file = v; }},
    {"quiet", "", "errors only", [](Settings& s, const std::string&) { s.quiet = true; }},
    {"werror", "", "a warning of the scene ends the run with status 1, before anything is rendered",
     [](Settings& s, const std::string&) { s.warnings_are_errors = true; }},
    {"console", "whittle|povray",
     "whose lines the console speaks; usual: by the name under which the program is called",
     [](Settings& s, const std::string& v) {
         s.console_style = v == "povray" ? ConsoleStyle::Povray : ConsoleStyle::Whittle;
     }},
    {"frames", "LIST", "these frames of the animation alone, as in 2,4,10-20; 10-20:5 takes every fifth", set_frames},
    {"progress", "povray|json|openjd",
     "lines of progress for a program, on standard error: POV-Ray's, an object of JSON each, or Open Job Description's",
     set_progress},
    {"make-folders", "", "make the folder of the picture if it is missing",
     [](Settings& s, const std::string&) { s.make_folders = true; }},
    {"state-after", "SECONDS", "after so long a render keeps its finished blocks beside the picture, for +C; usual: 2",
     set_state_after},
    {"partial", "SECONDS",
     "so often the picture's file is replaced by what is done, the rest black; a cancelled render leaves it too, and "
     "+C "
     "with the same option goes on",
     [](Settings& s, const std::string& v) { s.partial = whole_positive("--partial", v); }},
    {"memory", "MB",
     "so much may the pixels of a picture take, 16 bytes each: larger pictures are rendered by rows; usual: half of "
     "what is free",
     set_memory},
    {"shard", "I/N",
     "render part I of N of the picture, into PICTURE.I-of-N.whittle-part: whittle join makes the picture of all parts",
     set_shard},
    {"prepare", "",
     "find what the parts of a picture need of the whole, photons and radiosity, into PICTURE.whittle-prepared, and "
     "stop",
     [](Settings& s, const std::string&) { s.prepare = true; }},
    {"views", "FILE or WORDS",
     "pictures of many cameras, of a scene that is read and planned once: those of a file (JSON), or the scene's own "
     "moved by quilt=8x6, stereo or turntable=36 (docs/tools/views.md); a size is that of one view",
     [](Settings& s, const std::string& v) { s.views = v; }},
    {"embed", "",
     "the picture carries the scene's text, the files that it read and the options, for whittle open (PNG and OpenEXR)",
     [](Settings& s, const std::string&) { s.embed = true; }},
    {"allow-write", "FOLDER",
     "a scene may write files below this folder too, besides the current one and the picture's",
     [](Settings& s, const std::string& v) { s.write_folders.push_back(v); }},
    {"restrict-read", "",
     "a scene may read files only below the current folder, its own, the picture's, those of the library path and of "
     "--allow-write",
     [](Settings& s, const std::string&) { s.restrict_read = true; }},
    {"allow-commands", "", "run the commands of Pre_Scene_Command and its kin",
     [](Settings& s, const std::string&) { s.allow_commands = true; }},
    {"preview", "FILE",
     "a file mapped into memory in which another program watches the picture grow; also +SMFILE, as LeoCAD has it",
     [](Settings& s, const std::string& v) { s.preview_file = v; }},
    {"samples", "N or N%",
     "N samples in each pixel, of area lights and lenses too, or as many as bring the error to N % of white; instead "
     "of "
     "antialiasing",
     set_samples},
    {"error", "LEVELS",
     "samples where they are needed, until the estimated error of the picture is so many levels of 255", set_error},
    {"time", "SECONDS", "samples where they are needed, for so long a frame; also 2m, 1h", set_time},
    {"seed", "N", "other random places of those samples: the errors of two pictures with two seeds are independent",
     set_seed},
    {"integrator", "whitted|path",
     "how light is found: as POV-Ray does, or by paths through the same scene, 64 in each pixel unless samples, error "
     "or "
     "time say more",
     [](Settings& s, const std::string& v) { s.paths = v == "path"; }},
    {"denoise", "", "filter a picture of --integrator=path, guided by surfaces and by the variance of its pixels",
     [](Settings& s, const std::string&) { s.denoise = true; }},
    {"dump", "tokens|scene|plan|views", "print what a stage made, and stop; views: the cameras of --views", set_dump},
    {"explain", "cost",
     "say where reading spent its time, what the plan kept, what it left out and why; with =cost also, of a sampled "
     "run, what each statement, light and texture costs and what that is left out would cost",
     [](Settings& s, const std::string& v) {
         s.explain = true;
         s.explain_cost = v == "cost";
     },
     true},
    {"heat", "FILE",
     "a picture of nanoseconds and rays by pixel in false colours; of a name in .exr or .hdr the values themselves, "
     "red and green",
     [](Settings& s, const std::string& v) { s.heat_file = v; }},
    {"aov", "LAYERS",
     "write PICTURE.layers.exr beside the picture: its colours and, by name or all, depth, normal, position, albedo, "
     "object (with Cryptomatte), material, uv, time (docs/tools/layers.md)",
     [](Settings& s, const std::string& v) { s.layers = v; }},
    {"no-lean", "",
     "leave nothing out that the picture does not show: slower, and the same picture to the byte (docs/lean.md)",
     [](Settings& s, const std::string&) { s.lean = false; }},
    {"no-extensions", "",
     "the constant Whittle is not defined, so that scenes skip the words that POV-Ray lacks (docs/extensions.md)",
     [](Settings& s, const std::string&) { s.extensions = false; }},
    {"povray", "3.7|3.8",
     "the POV-Ray whose language and pictures are meant; usual is 3.8 for scenes that begin with #version 3.71 or "
     "more, "
     "else 3.7",
     [](Settings& s, const std::string& v) { s.povray = v == "3.8" ? scene::PovRay::V38 : scene::PovRay::V37; }},
    {"faithful", "",
     "POV-Ray's constants where better ones are usual, to find the cause of a difference: docs/faithful.md",
     [](Settings& s, const std::string&) { s.faithful = true; }},
    {"isa", "v2|v3|v4|auto", "instruction set of the tracer",
     [](Settings& s, const std::string& v) { s.isa = v == "auto" ? "" : v; }},
    {"benchmark", "", "render POV-Ray's benchmark scene where it is installed, 512x512, antialiased", nullptr},
    {"help", "", "this text", nullptr},
    {"man", "", "print the manual page, in the form that man reads", nullptr},
    {"grammar", "", "print the scene language as this program reads it, in EBNF", nullptr},
    {"completion", "bash|zsh", "print the completion for a shell, bash if none is named", nullptr, true},
    {"version", "", "print the version", nullptr},
};

bool is_choice(const OwnOption& option, std::string_view value)
{
    if (option.value.find('|') == std::string_view::npos) return true;
    std::string_view rest = option.value;
    while (true) {
        const std::size_t bar = rest.find('|');
        if (rest.substr(0, bar) == value) return true;
        if (bar == std::string_view::npos) return false;
        rest.remove_prefix(bar + 1);
    }
}

}  // namespace

std::string OwnOption::form() const
{
    std::string text("--");
    text += name;
    if (value.empty()) return text;
    text += value_may_lack ? "[=" : "=";
    text += value;
    if (value_may_lack) text += ']';
    return text;
}

std::span<const OwnOption> own_options() { return kOwnOptions; }

const OwnOption* find_own_option(std::string_view word)
{
    if (!word.starts_with("--")) return nullptr;
    const std::string_view name = word.substr(2, word.find('=') - 2);
    const auto* found = std::find_if(std::begin(kOwnOptions), std::end(kOwnOptions),
                                     [&](const OwnOption& o) { return o.name == name; });
    return found == std::end(kOwnOptions) ? nullptr : found;
}

bool apply_own_option(Settings& settings, const std::string& word, const std::string* next)
{
    const OwnOption* option = find_own_option(word);
    if (!option || !option->apply) throw OptionError("unknown option '" + word + "'" + nearest_own_option(word));
    const std::string name = "--" + std::string(option->name);
    const std::size_t equals = word.find('=');
    const bool given = equals != std::string::npos;
    if (option->value.empty()) {
        if (given) throw OptionError(name + " wants no value");
        option->apply(settings, {});
        settings.given_own.push_back(name);
        return false;
    }
    if (!given && option->value_may_lack) {
        option->apply(settings, {});
        settings.given_own.push_back(name);
        return false;
    }
    if (!given && !next) throw OptionError(name + " wants a value: " + std::string(option->value));
    const std::string value = given ? word.substr(equals + 1) : *next;
    if (value.empty() || !is_choice(*option, value) || (option->value_may_lack && value != option->value))
        throw OptionError(name + " wants " + std::string(option->value) + ", found '" + value + "'");
    option->apply(settings, value);
    settings.given_own.push_back(name + "=" + value);
    return !given;
}

}  // namespace app
