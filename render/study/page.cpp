#include "render/study/page.h"

#include "render/image/base64.h"
#include "render/study/between_surfaces.h"
#include "render/study/kinds.h"
#include "render/study/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace study {
namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Error against run time</title>
<style>
body{font:15px/1.5 system-ui,sans-serif;max-width:1100px;margin:2em auto;padding:0 1em;color:#222}
h1{font-size:1.6em} h2{margin-top:2.2em;border-top:1px solid #ccc;padding-top:.7em;font-size:1.25em}
table{border-collapse:collapse;font-size:13px} td,th{padding:.15em .7em;text-align:right;border-bottom:1px solid #eee}
td:first-child,td:nth-child(2),th:first-child,th:nth-child(2){text-align:left} tr.best{background:#eef7ee}
tr.povray{color:#777} svg text{font:12px system-ui,sans-serif;fill:#333} .decade{stroke:#ddd} .tick{stroke:#f3f3f3}
.floor{fill:#f2ead8} .wanted{stroke:#2e8b57;stroke-dasharray:2 4} figure{display:inline-block;margin:.5em 1em .5em 0}
figcaption{font-size:13px;color:#555} img{image-rendering:pixelated;max-width:340px}
pre{white-space:pre-wrap;font-size:13px}
code{background:#f5f5f5;padding:0 .25em;white-space:nowrap}
</style></head><body>
)";

std::string figure(const Shown& picture, const std::string& caption, const PngOf& png)
{
    return fmt::format("<figure><img alt='' src='data:image/png;base64,{}'><figcaption>{}</figcaption></figure>\n",
                       image::base64(png(picture)), escaped(caption));
}

/// What links to a scene's part end with: the name of its file, with a number where two are called alike.
std::vector<std::string> anchors_of(const std::vector<Section>& sections)
{
    std::vector<std::string> out;
    std::map<std::string, int> seen;
    for (const Section& section : sections) {
        std::string name = std::filesystem::path(section.scene).stem().string();
        for (char& c : name)
            if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
        const int before = seen[name]++;
        out.push_back(before == 0 ? name : fmt::format("{}_{}", name, before + 1));
    }
    return out;
}

std::string cell_of(const Result* result)
{
    return result == nullptr
               ? "<td>none</td><td></td>"
               : fmt::format("<td><code>{}</code></td><td>{:.3f}</td>", escaped(result->name), result->seconds);
}

/// All scenes in one table: what reaches the wanted error soonest.
std::string summary(const std::vector<Section>& sections, const std::vector<std::string>& anchors,
                    const Circumstances& c)
{
    std::string out =
        fmt::format("<h2 id='soonest'>What is near enough soonest</h2>\n<table><tr><th>scene</th><th>fastest within "
                    "{:g} of 255</th><th>seconds</th>",
                    c.wanted);
    if (!c.povray.empty()) out += "<th>POV-Ray's fastest</th><th>seconds</th><th>ratio</th>";
    out += "</tr>\n";
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const Section& section = sections[i];
        out += fmt::format("<tr><td><a href='#{}'>{}</a></td>", anchors[i], escaped(section.scene));
        const Result *ours = cheapest(section.results, c.wanted), *theirs = cheapest(section.results, c.wanted, true);
        out += cell_of(ours);
        if (!c.povray.empty()) {
            out += cell_of(theirs);
            out += ours && theirs ? fmt::format("<td>{:.1f}</td>", theirs->seconds / ours->seconds) : "<td></td>";
        }
        out += "</tr>\n";
    }
    return out + "</table>\n";
}

/// What settings that promise something kept: what was found for each that was asked for.
/// \param asked  of a result, 0: nothing
/// \param found  what came of it
/// \param kept  whether that will do
std::string promises(const std::vector<Section>& sections, const std::vector<std::string>& anchors,
                     double Result::*asked, const std::function<double(const Result&)>& found, double slack)
{
    std::vector<std::string> names;  // settings, as they come
    for (const Section& section : sections)
        for (const Result& r : section.results)
            if (r.*asked > 0.0 && std::find(names.begin(), names.end(), r.name) == names.end()) names.push_back(r.name);
    if (names.empty()) return {};
    std::string out = "<table><tr><th>scene</th>";
    for (const std::string& name : names) out += fmt::format("<th><code>{}</code></th>", escaped(name));
    out += "</tr>\n";
    std::map<std::string, std::pair<int, int>> kept;  // of how many
    for (std::size_t i = 0; i < sections.size(); ++i) {
        out += fmt::format("<tr><td><a href='#{}'>{}</a></td>", anchors[i], escaped(sections[i].scene));
        for (const std::string& name : names) {
            const std::vector<Result>& all = sections[i].results;
            const auto one =
                std::find_if(all.begin(), all.end(), [&](const Result& r) { return r.*asked > 0.0 && r.name == name; });
            out += one == all.end() ? "<td></td>" : fmt::format("<td>{:.3f}</td>", found(*one));
            if (one == all.end()) continue;
            kept[name].first += found(*one) <= (*one).*asked * slack;
            ++kept[name].second;
        }
        out += "</tr>\n";
    }
    out += "<tr><td>kept</td>";
    for (const std::string& name : names) out += fmt::format("<td>{} of {}</td>", kept[name].first, kept[name].second);
    return out + "</tr></table>\n";
}

std::string promises(const std::vector<Section>& sections, const std::vector<std::string>& anchors)
{
    constexpr double kLate = 1.1;
    std::string out;
    const std::string errors = promises(
        sections, anchors, &Result::asked_error, [](const Result& r) { return r.error.levels; }, 1.0);
    if (!errors.empty())
        out += "<h2 id='asked_errors'>Asked for by error</h2>\n<p>What came of an error that was asked for (RMS, of "
               "255):</p>\n" +
               errors;
    const std::string times = promises(
        sections, anchors, &Result::asked_seconds, [](const Result& r) { return r.seconds; }, kLate);
    if (!times.empty())
        out += "<h2 id='asked_times'>Asked for by time</h2>\n<p>Seconds that a picture took, of those that it was "
               "given (kept: no more than a tenth above; a picture that needs no more samples ends sooner):</p>\n" +
               times;
    return out;
}

/// What the curves teach, in sentences.
std::string lesson(const Section& section, const Circumstances& circumstances)
{
    std::string out = "<p>";
    if (const Result* best = cheapest(section.results, circumstances.wanted))
        out += fmt::format(
            "The fastest setting with at most {:g} of 255 of error is <code>{}</code>: {:.3g} in {:.3g} s. ",
            circumstances.wanted, escaped(best->name), best->error.levels, best->seconds);
    else out += fmt::format("No setting reached {:g} of 255. ", circumstances.wanted);
    // What each family can't get below: more of it is time for nothing.
    std::set<std::string> told;
    for (const Result& one : section.results) {
        if (one.povray || !told.insert(one.family).second) continue;
        const Result *least = &one, *fastest = &one;
        std::size_t count = 0;
        for (const Result& other : section.results) {
            if (other.povray || other.family != one.family) continue;
            ++count;
            if (other.error.levels < least->error.levels) least = &other;
            if (other.seconds < fastest->seconds) fastest = &other;
        }
        if (count < 3) continue;
        out += fmt::format("{}: from {:.3g} in {:.3g} s to {:.3g} in {:.3g} s", escaped(one.family),
                           fastest->error.levels, fastest->seconds, least->error.levels, least->seconds);
        double cheap = least->seconds;
        const Result* enough = nullptr;
        for (const Result& other : section.results)
            if (!other.povray && other.family == one.family && other.error.levels <= 1.1 * least->error.levels &&
                other.seconds < cheap) {
                cheap = other.seconds;
                enough = &other;
            }
        if (enough)
            out += fmt::format(", of which <code>{}</code> gets all but a tenth in {:.3g} s", escaped(enough->name),
                               cheap);
        out += ". ";
    }
    return out + "</p>\n";
}

std::string table(const Section& section)
{
    const std::vector<const Result*> front = pareto_front(section.results);
    std::string out = fmt::format(
        "<table><tr><th>kind</th><th>setting</th><th>seconds</th><th>RMS, of 255, ± {:.3f}</th><th>RMS, linear</th>"
        "<th>beyond 3/255</th><th>FLIP</th><th>million rays</th></tr>\n",
        section.truth.expected_error);
    for (const Result& r : section.results) {
        const bool best = std::find(front.begin(), front.end(), &r) != front.end();
        out += fmt::format("<tr{}><td>{}{}</td><td><code>{}</code></td><td>{:.3f}</td><td>{:.3f}</td><td>{:.5f}</td>"
                           "<td>{:.2f} %</td><td>{:.4f}</td><td>{}</td></tr>\n",
                           best       ? " class='best'"
                           : r.povray ? " class='povray'"
                                      : "",
                           r.povray ? "POV-Ray, " : "", escaped(r.family), escaped(r.name), r.seconds, r.error.levels,
                           r.error.linear, 100.0 * r.error.beyond, r.error.flip,
                           r.rays > 0 ? fmt::format("{:.2f}", static_cast<double>(r.rays) / 1e6) : "");
    }
    return out + "</table>\n<p>Green: no other setting here is both faster and nearer.</p>\n";
}

std::string pictures(const Section& section, const PngOf& png)
{
    std::string out =
        figure(section.truth.picture, fmt::format("the truth: {:.0f} samples a pixel", section.truth.samples), png);
    const std::vector<const Result*> front = pareto_front(section.results);
    std::set<std::size_t> chosen;
    if (!front.empty()) chosen = {0, front.size() / 2, front.size() - 1};
    for (const std::size_t i : chosen) {
        out += figure(front[i]->picture, fmt::format("{}: {:.3g} s", front[i]->name, front[i]->seconds), png);
        out += figure(difference(section.truth.picture, front[i]->picture),
                      fmt::format("its difference, five times: {:.3g} of 255", front[i]->error.levels), png);
    }
    return out;
}

}  // namespace

Shown difference(const Shown& truth, const Shown& picture)
{
    constexpr float kTimes = 5.0f;
    Shown out = truth;
    for (std::size_t i = 0; i < out.values.size(); ++i)
        out.values[i] = std::clamp(0.5f + kTimes * (picture.values[i] - truth.values[i]), 0.0f, 1.0f);
    return out;
}

std::string page(const std::vector<Section>& sections, const Circumstances& c, const PngOf& png)
{
    std::string out = kHead;
    out += "<h1>Error against run time</h1>\n";
    out += fmt::format(
        "<p>Seconds are wall clock of passes and trace on {} thread{}, without reading. Errors are distances "
        "from the truth: the same scene with many samples a pixel, lamps and lenses drawn freely and no "
        "adaptivity; where the command asks for --integrator=path a picture of many paths a pixel. The band at the "
        "foot of a plot is what the truth itself may be off by, t: an error told as e is one of e - t to e + t. "
        "POV-Ray's curves are dashed; a line joins what nothing faster of its kind comes near.</p>\n",
        c.threads, c.threads == 1 ? "" : "s");
    out += fmt::format("<pre>{}\n{}\nWhittle {}{}</pre>\n", escaped(c.command), escaped(c.machine), escaped(c.version),
                       c.povray.empty() ? std::string() : ", " + escaped(c.povray));
    const std::vector<std::string> anchors = anchors_of(sections);
    out += summary(sections, anchors, c) + promises(sections, anchors);
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const Section& section = sections[i];
        out += fmt::format("<h2 id='{}'>{}</h2>\n", anchors[i], escaped(section.scene));
        if (!section.unmeasured.empty()) {
            out += fmt::format("<p>Not measured: {}</p>\n", escaped(section.unmeasured));
            continue;
        }
        out += fmt::format(
            "<p>{} x {} pixels. The truth: {:.0f} samples a pixel in {:.1f} s, expected to be off by {:.3f} of "
            "255.</p>\n",
            section.width, section.height, section.truth.samples, section.truth.seconds, section.truth.expected_error);
        if (!section.povray_note.empty()) out += fmt::format("<p>{}</p>\n", escaped(section.povray_note));
        out += between_surfaces(section, c.wanted);
        out += plot(series_of(section.results, false),
                    {"seconds", "error, levels of 255 (RMS)", "s", section.truth.expected_error, c.wanted});
        out += lesson(section, c) + table(section) + pictures(section, png);
    }
    if (!c.solvers.empty()) out += solver_plots(c.solvers);
    return out + "</body></html>\n";
}

std::string csv(const std::vector<Section>& sections)
{
    std::string out = "scene,program,family,setting,seconds,rms_levels,rms_linear,beyond_3,flip,rays,truth_error\n";
    const auto quoted = [](const std::string& text) {
        std::string copy;
        for (const char ch : text) copy += ch == '"' ? std::string("\"\"") : std::string(1, ch);
        return '"' + copy + '"';
    };
    for (const Section& section : sections)
        for (const Result& r : section.results)
            out += fmt::format("{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{},{:.6g}\n", quoted(section.scene),
                               r.povray ? "povray" : "whittle", quoted(r.family), quoted(r.name), r.seconds,
                               r.error.levels, r.error.linear, r.error.beyond, r.error.flip, r.rays,
                               section.truth.expected_error);
    return out;
}

}  // namespace study
