#include "render/app/study/report_command.h"

#include "render/app/options/command_line.h"
#include "render/app/options/ini_file.h"
#include "render/app/options/positive.h"
#include "render/app/output/scratch_folder.h"
#include "render/app/output/whole_text.h"
#include "render/app/report/json_writer.h"
#include "render/app/report/progress.h"
#include "render/app/run/run.h"
#include "render/app/frames/frames.h"
#include "render/app/run/scene_file.h"
#include "render/app/run/scene_reading.h"
#include "render/app/run/stage_options.h"
#include "render/app/study/povray_runs.h"
#include "render/image/picture_writer.h"
#include "render/study/page.h"
#include "render/picture/kernel_module.h"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

namespace app {
namespace {

constexpr const char* kReportUsage = R"(usage: whittle report SCENE... [-o report.html] [options]

Error against run time of each scene, over the settings that it has a use for: a page, and beside it CSV and JSON.

  -o FILE             the page; usual: report.html
  --truth-error=E     levels of 255 that the picture measured against may be off by; usual: 0.1
  --truth-seconds=S   and how long it may take; usual: 60
  --want=E            the error that the page names the fastest setting for, of 255; usual: 1
  --longest=S         a setting that takes longer is the last of its kind; usual: 20
  --solvers=FILE      a table of numerics_lab --csv: error against time of the solvers follows the scenes
  --povray-longest=S  POV-Ray is stopped after so long, and not asked again for that scene; usual: 300
  --povray=PROGRAM    the POV-Ray to measure beside, or off; usual: povray, where it is installed
  --povray38=PROGRAM  a POV-Ray 3.8 for what 3.7 does not know, +AM3; usual: povray38, where it is installed

  --integrator=path   measure against a picture of paths, and paths beside all else

All else is as for a render: +W +H (usual: 320 240), +WT, +L, Declare=, +Q, --isa. Exit status: 0 done, 1 something could not be
measured, 2 cancelled.
)";

struct Request {
    std::vector<std::string> scenes;
    std::string out = "report.html", povray = "povray", povray38 = "povray38";
    double truth_error = 0.1, truth_seconds = 60.0, wanted = 1.0, longest = 20.0, povray_longest = 300.0;
    std::vector<study::SolverRow> solvers;
    Settings settings;
    std::string command;
};

Request request_of(const std::vector<std::string>& arguments)
{
    Request request;
    request.settings.verbose = false;
    read_default_ini_file(request.settings);
    std::vector<std::string> others;
    request.command = "whittle report";
    for (const std::string& word : arguments) request.command += " " + word;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& word = arguments[i];
        const std::size_t equals = word.find('=');
        const std::string name = word.substr(0, equals);
        const bool own = name == "-o" || name == "--out" || name == "--truth-error" || name == "--truth-seconds" ||
                         name == "--want" || name == "--longest" || name == "--povray" || name == "--povray-longest" ||
                         name == "--solvers" || name == "--povray38";
        if (!own) {
            const bool scene = !word.starts_with('-') && !word.starts_with('+') && equals == std::string::npos &&
                               !word.ends_with('/') && !word.ends_with(".ini");
            (scene ? request.scenes : others).push_back(word);
            continue;
        }
        if (equals == std::string::npos && i + 1 == arguments.size()) throw OptionError(name + " wants a value");
        const std::string value = equals == std::string::npos ? arguments[++i] : word.substr(equals + 1);
        if (name == "-o" || name == "--out") request.out = value;
        else if (name == "--truth-error") request.truth_error = whole_positive(name, value);
        else if (name == "--truth-seconds") request.truth_seconds = whole_positive(name, value);
        else if (name == "--longest") request.longest = whole_positive(name, value);
        else if (name == "--povray-longest") request.povray_longest = whole_positive(name, value);
        else if (name == "--solvers") request.solvers = study::read_solvers(value);
        else if (name == "--want") request.wanted = whole_positive(name, value);
        else (name == "--povray" ? request.povray : request.povray38) = value == "off" ? "" : value;
    }
    if (request.scenes.empty()) throw OptionError("no scene given: whittle report scene.pov, or whittle report --help");
    apply_command_line(request.settings, others);
    if (!request.settings.given.contains("Width")) request.settings.width = 320;
    if (!request.settings.given.contains("Height")) request.settings.height = 240;
    return request;
}

std::string machine()
{
    std::ifstream in("/proc/cpuinfo");
    std::string line, model;
    while (std::getline(in, line))
        if (line.starts_with("model name") && line.find(": ") != std::string::npos) {
            model = line.substr(line.find(": ") + 2);
            break;
        }
    utsname name{};
    uname(&name);
    return fmt::format("{}, {} threads, {} {}", model, std::thread::hardware_concurrency(), name.sysname, name.machine);
}

class Reporter {
public:
    Reporter(const Request& request, Cancellation& cancel)
        : request_(request), cancel_(cancel), povray_(request.povray), povray38_(request.povray38)
    {}

    int run()
    {
        std::vector<study::Section> sections;
        int status = kSuccess;
        for (const std::string& scene : request_.scenes) {
            study::Section section = measured(scene);
            if (!section.unmeasured.empty()) {
                fmt::print(stderr, "{}\n", section.unmeasured);
                status = kError;
            }
            sections.push_back(std::move(section));
            if (cancel_.requested) status = kCancelled;
            if (cancel_.requested) break;
        }
        write(sections);
        fmt::print(stderr, "{}\n", request_.out);
        return status;
    }

private:
    study::Section measured(const std::string& scene)
    {
        study::Section section;
        section.scene = scene;
        section.width = request_.settings.width;
        section.height = request_.settings.height;
        try {
            measure(scene, section);
        } catch (const parser::Cancelled&) {
            section.unmeasured = scene + ": cancelled";
        } catch (const std::exception& error) {
            section.unmeasured = error.what();
        }
        return section;
    }

    void measure(const std::string& scene, study::Section& section)
    {
        Settings settings = request_.settings;
        settings.input_file = scene;
        const std::string file = find_scene(settings);
        const SceneReading reading(settings, cancel_.requested);
        const parser::Result parsed = parser::parse_file(file, reading.options);
        trace::RenderOptions render;
        render.threads = threads_of(settings);
        render.isa = isa_of(settings);
        render.cancel = &cancel_.requested;
        study::Study study(parsed.scene, plan_options(settings), render,
                           file_settings(settings, parsed.scene).encoding.curves);
        measure(file, study, section);
    }

    void measure(const std::string& file, study::Study& study, study::Section& section)
    {
        const std::size_t steps = study.settings().size() + 1;
        Progress progress(true, section.scene);
        section.truth = study.find_truth(request_.truth_error, request_.truth_seconds);
        std::size_t done = 1;
        std::map<std::string, double> took;  // the longest of each kind
        for (const study::Setting& setting : study.settings()) {
            if (cancel_.requested) return;
            progress.show(static_cast<double>(done++) / static_cast<double>(steps));
            if (took[setting.family] > request_.longest) continue;  // they get dearer
            const auto found = study.run(setting);
            if (!found) return;
            section.results.push_back(*found);
            took[setting.family] = std::max(took[setting.family], found->seconds);
            const PovrayRuns& povray = setting.newer ? povray38_ : povray_;
            if (povray.found() && !setting.switches.empty() && section.povray_note.empty())
                add_povray(povray, file, setting, study, section);
        }
    }

    void add_povray(const PovrayRuns& povray, const std::string& file, const study::Setting& setting,
                    const study::Study& study, study::Section& section)
    {
        const Settings& s = request_.settings;
        const unsigned all = std::max(1u, std::thread::hardware_concurrency());
        std::vector<std::string> switches{fmt::format("+W{}", s.width), fmt::format("+H{}", s.height),
                                          fmt::format("+WT{}", s.threads > 0 ? static_cast<unsigned>(s.threads) : all)};
        // Whittle looks beside the scene by itself.
        const std::filesystem::path beside = std::filesystem::absolute(file).parent_path();
        switches.push_back("+L" + beside.string());
        for (const std::string& folder : s.library_path) switches.push_back("+L" + folder);
        for (const auto& [name, value] : s.declared_numbers)
            switches.push_back(fmt::format("Declare={}={}", name, value));
        switches.insert(switches.end(), setting.switches.begin(), setting.switches.end());
        const auto start = std::chrono::steady_clock::now();
        auto found = povray.render(file, switches, files_, request_.povray_longest);
        const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        if (!found && took >= request_.povray_longest)
            section.povray_note =
                fmt::format("POV-Ray with {} was stopped after {:g} seconds.", setting.name, request_.povray_longest);
        if (!found || found->picture.values.size() != study.truth().picture.values.size()) return;
        study::Result result;
        result.family = setting.family;
        result.name = setting.name;
        result.povray = true;
        result.seconds = std::max(found->seconds, 1e-3);  // it tells thousandths
        result.error = study.error(found->picture);
        section.results.push_back(std::move(result));
    }

    std::string png_of(const study::Shown& picture) const
    {
        image::Raster raster{picture.width, picture.height, 3, 8, {}};
        for (const float v : picture.values) raster.samples.push_back(image::quantised(v, 8));
        const ScratchFolder scratch;
        const std::string path = scratch / "a.png";
        files_.write(path, raster, image::FileType::Png, image::TransferCurve::srgb());
        std::ifstream in(path, std::ios::binary);
        std::ostringstream bytes;
        bytes << in.rdbuf();
        return std::move(bytes).str();
    }

    void write(const std::vector<study::Section>& sections) const
    {
        study::Circumstances about;
        about.command = request_.command;
        about.machine = machine();
        about.version = WHITTLE_VERSION;
        about.povray = povray_.version();
        if (povray38_.found()) about.povray += (povray_.found() ? " and " : "") + povray38_.version();
        about.threads = request_.settings.threads > 0 ? request_.settings.threads
                                                      : static_cast<int>(std::thread::hardware_concurrency());
        about.wanted = request_.wanted;
        about.solvers = request_.solvers;
        const std::string base = std::filesystem::path(request_.out).replace_extension().string();
        put_bytes(request_.out, study::page(sections, about, [this](const study::Shown& p) { return png_of(p); }));
        put_bytes(base + ".csv", study::csv(sections));
        put_bytes(base + ".json", json(sections, about));
    }

    static std::string json(const std::vector<study::Section>& sections, const study::Circumstances& about)
    {
        JsonWriter json;
        json.begin_object();
        json.key("command").text(about.command);
        json.key("machine").text(about.machine);
        json.key("version").text(about.version);
        json.key("povray").text(about.povray);
        json.key("threads").integer(about.threads);
        json.key("scenes").begin_array();
        for (const study::Section& section : sections) put_section(json, section, about.wanted);
        json.end();
        json.end();
        return json.take();
    }

    static void put_section(JsonWriter& json, const study::Section& section, double wanted)
    {
        json.begin_object();
        json.key("scene").text(section.scene);
        if (!section.unmeasured.empty()) {
            json.key("unmeasured").text(section.unmeasured);
            return json.end();
        }
        json.key("truth_expected_error").number(section.truth.expected_error);
        json.key("truth_samples").number(section.truth.samples);
        json.key("truth_seconds").number(section.truth.seconds);
        json.key("cheapest");
        if (const study::Result* best = study::cheapest(section.results, wanted)) json.text(best->name);
        else json.null();
        json.key("results").begin_array();
        for (const study::Result& r : section.results) {
            json.begin_object();
            json.key("program").text(r.povray ? "povray" : "whittle");
            json.key("family").text(r.family);
            json.key("setting").text(r.name);
            json.key("seconds").number(r.seconds);
            json.key("rms_levels").number(r.error.levels);
            json.key("rms_linear").number(r.error.linear);
            json.key("beyond_3").number(r.error.beyond);
            json.key("flip").number(r.error.flip);
            json.end();
        }
        json.end();
        json.end();
    }

    const Request& request_;
    Cancellation& cancel_;
    const PovrayRuns povray_, povray38_;
    const image::Files files_;
};

}  // namespace

std::string report_help() { return kReportUsage; }

int report_command(const std::vector<std::string>& arguments, Cancellation& cancel)
{
    const Request request = request_of(arguments);
    check_place(request.out);
    trace::load_kernel(isa_of(request.settings));
    cancel.heeded = true;
    return Reporter(request, cancel).run();
}

}  // namespace app
