#include "render/app/farm/engines.h"

#include "render/app/report/json_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

// A job template of Open Job Description, version 2023-09 (github.com/OpenJobDescription/openjd-specifications, page
// "Template Schemas"): the folder is a parameter of the kind PATH, which farms map to where a worker sees it.

namespace app {
namespace {

/// A name of at most so many characters without what a template would read as an expression.
std::string plain_name(const std::string& text, std::size_t most)
{
    std::string out;
    for (const char c : text) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) continue;
        out += c;
        if (c == '{') out += ' ';
    }
    while (out.size() > most || (!out.empty() && out.size() == most && (out.back() & 0x80) != 0)) out.pop_back();
    return out.empty() ? "picture" : out;
}

void put_action(JsonWriter& json, const std::vector<std::string>& words)
{
    json.key("script").begin_object();
    json.key("actions").begin_object();
    json.key("onRun").begin_object();
    json.key("command").text("bash");
    json.key("args").begin_array();
    for (const std::string& word : words) json.text(word);
    json.end();
    // A signal first: what is finished of a picture is kept.
    json.key("cancelation").begin_object();
    json.key("mode").text("NOTIFY_THEN_TERMINATE");
    json.key("notifyPeriodInSeconds").integer(5);
    json.end();
    json.end();
    json.end();
    json.end();
}

void put_step(JsonWriter& json, const char* name, const char* after, const FarmJob& job, double memory)
{
    json.key("name").text(name);
    if (after != nullptr) {
        json.key("dependencies").begin_array();
        json.begin_object();
        json.key("dependsOn").text(after);
        json.end();
        json.end();
    }
    json.key("hostRequirements").begin_object();
    json.key("amounts").begin_array();
    const auto amount = [&](const char* what, double least) {
        json.begin_object();
        json.key("name").text(what);
        json.key("min").number(least);
        json.end();
    };
    amount("amount.worker.vcpu", job.cores);
    amount("amount.worker.memory", std::ceil(memory / kMebibyte));
    json.end();
    json.end();
}

}  // namespace

std::string openjd_template(const FarmJob& job, const JobPlan& plan, const FarmFolder& folder)
{
    constexpr std::size_t kLongestName = 128;
    JsonWriter json;
    json.begin_object();
    json.key("specificationVersion").text("jobtemplate-2023-09");
    json.key("name").text(plain_name(job.settings.input_file, kLongestName));
    json.key("parameterDefinitions").begin_array();
    json.begin_object();
    json.key("name").text("Farm");
    json.key("type").text("PATH");
    json.key("objectType").text("DIRECTORY");
    json.key("dataFlow").text("INOUT");
    json.key("description").text("the folder that `whittle farm` has written");
    json.key("default").text(folder.path);
    json.end();
    json.end();
    json.key("steps").begin_array();
    if (plan.first) {
        json.begin_object();
        put_step(json, "Prepare", nullptr, job, plan.memory);
        put_action(json, {"{{Param.Farm}}/prepare", "--progress=openjd"});
        json.end();
    }
    json.begin_object();
    put_step(json, "Render", plan.first ? "Prepare" : nullptr, job, plan.memory);
    json.key("parameterSpace").begin_object();
    json.key("taskParameterDefinitions").begin_array();
    json.begin_object();
    json.key("name").text("Task");
    json.key("type").text("INT");
    json.key("range").text(fmt::format("1-{}", plan.tasks.size()));
    json.end();
    json.end();
    json.end();
    put_action(json, {"{{Param.Farm}}/task", "{{Task.Param.Task}}", "--progress=openjd"});
    json.end();
    json.begin_object();
    put_step(json, "Join", "Render", job, plan.join.memory);
    put_action(json, {"{{Param.Farm}}/join"});
    json.end();
    json.end();
    json.end();
    return json.take();
}

}  // namespace app
