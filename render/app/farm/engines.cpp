#include "render/app/farm/engines.h"

#include "render/app/base/text.h"
#include "render/app/output/output_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace app {
namespace {

/// Every script finds the folder by itself, also where an engine runs a copy of it, and goes where the words were
/// given.
std::string script_head(const FarmFolder& folder, const std::string& what)
{
    return fmt::format("#!/usr/bin/env bash\n# {}\nset -euo pipefail\n"
                       "farm=$(dirname \"$(realpath \"${{BASH_SOURCE[0]}}\")\")\n[[ -e $farm/tasks ]] || "
                       "farm={}\nwhittle=${{WHITTLE:-{}}}\ncd {}\n",
                       what, shell_word(folder.path), shell_word(renderer_program()),
                       shell_word(std::filesystem::current_path().string()));
}

std::string renderer_words(const FarmJob& job, bool all_threads = false)
{
    std::string text = "\"$whittle\"";
    if (!all_threads) text += fmt::format(" +WT{}", job.cores);
    for (const std::string& word : job.words) text += ' ' + shell_word(word);
    return text;
}

/// The renderer takes the place of the shell, so that it gets the signals of the engine.
std::string task_script(const FarmJob& job, const JobPlan& plan, const FarmFolder& folder)
{
    const char* const option = plan.parts ? "--shard" : "--frames";
    return script_head(folder, "Task N of the file tasks: bash task N [options]") +
           fmt::format("what=$(sed -n \"${{1:?which task}}p\" \"$farm/tasks\")\n"
                       "[[ -n $what ]] || {{ echo \"there is no task $1\" >&2; exit 1; }}\nmkdir -p \"$farm/done\"\n"
                       "exec {} +C --make-folders --json \"$farm/done/$1.json\" {}=\"$what\" \"${{@:2}}\"\n",
                       renderer_words(job), option);
}

std::string prepare_script(const FarmJob& job, const FarmFolder& folder)
{
    // Under make and in the shell nothing else of the job runs on the host meanwhile: all its threads.
    const bool alone = folder.engine == Engine::Make || folder.engine == Engine::Shell;
    return script_head(folder, "Photons and radiosity, once for all tasks") +
           fmt::format("exec {} --make-folders --prepare \"$@\"\n", renderer_words(job, alone));
}

/// Names of what the tasks leave, in order.
std::vector<std::string> pieces(const FarmJob& job, const JobPlan& plan)
{
    std::vector<std::string> names;
    if (!plan.parts) {
        for (const Frame& frame : job.list.frames) names.push_back(output_path(job.settings, job.list, frame));
        return names;
    }
    Settings settings = job.settings;
    settings.shards = static_cast<int>(plan.tasks.size());
    for (settings.shard = 1; settings.shard <= settings.shards; ++settings.shard)
        names.push_back(output_path(settings, job.list, job.list.frames.front()));
    return names;
}

std::string pieces_file(const FarmJob& job, const JobPlan& plan)
{
    std::string text;
    for (const std::string& name : pieces(job, plan)) text += name + "\n";
    return text;
}

/// A frame that is not there may come with another try of its task: 75, as for a part.
std::string join_script(const FarmJob& job, const JobPlan& plan, const FarmFolder& folder)
{
    std::string text =
        script_head(folder, "What the tasks left, joined: bash join; what is missing is told, with status 75");
    text += "mapfile -t pieces <\"$farm/pieces\"\n";
    if (plan.parts)
        return text + fmt::format("exec \"$whittle\" join {} \"${{pieces[@]}}\"\n",
                                  shell_word(output_path(job.settings, job.list, job.list.frames.front())));
    text += "missing=0\nfor piece in \"${pieces[@]}\"; do\n"
            "    [[ -s $piece ]] || { echo \"missing: $piece\" >&2; missing=75; }\ndone\n"
            "[[ $missing == 0 ]] || exit $missing\n";
    text +=
        fmt::format("if ! sha256sum --check --status \"$farm/sources\"; then\n"
                    "    echo \"the scene was edited since it was handed in: frames of before are rendered anew\" >&2\n"
                    "    {} +C\nfi\n",
                    renderer_words(job));
    if (folder.movie.empty()) return text + "echo \"all ${#pieces[@]} frames are there\"\n";
    return text + fmt::format("exec \"$whittle\" join --movie {} \"${{pieces[@]}}\"\n", shell_word(folder.movie));
}

/// For engines that do not try again by themselves: a script of the folder, as long as it says that it may help.
std::string tries_script(const FarmFolder& folder)
{
    return script_head(folder, "A script of this folder, up to three times while it ends with 75: bash tries task 7") +
           "for try in 1 2 3; do\n    status=0\n    bash \"$farm/$1\" \"${@:2}\" || status=$?\n"
           "    [[ $status == 75 ]] || exit $status\n    sleep $try\ndone\nexit 75\n";
}

/// What the scene is made of as it is handed in; a scene with an error is told here.
std::string sources_script(const FarmJob& job, const FarmFolder& folder)
{
    std::string words = renderer_words(job);
    if (job.list.animation) words += fmt::format(" --frames={}", job.list.frames.front().number);
    return script_head(folder, "Writes sources: the files that the scene is made of, with their sums") + words +
           " --deps --quiet >\"$farm/sources.new\"\n"
           "xargs -d '\\n' sha256sum <\"$farm/sources.new\" >\"$farm/sources\"\nrm \"$farm/sources.new\"\n";
}

std::string slurm_submit(const FarmJob& job, const JobPlan& plan, const FarmFolder& folder)
{
    const std::string limits =
        fmt::format("--cpus-per-task={} --mem={:.0f}M", job.cores, std::ceil(plan.memory / kMebibyte));
    std::string text = script_head(folder, "Hands the job in: bash submit [options of sbatch]");
    text += fmt::format("bash \"$farm/sources_now\"\nmkdir -p \"$farm/log\"\nhand_in() {{ sbatch --parsable --requeue "
                        "--open-mode=append {} \"$@\" | cut -d';' -f1; }}\n",
                        limits);
    if (plan.first) text += "first=$(hand_in --job-name=prepare -o \"$farm/log/prepare\" \"$@\" \"$farm/prepare\")\n";
    text += fmt::format(
        "tasks=$(hand_in --job-name=render --array=1-{} -o \"$farm/log/%a\" {}\"$@\" \"$farm/slurm_task\")\n",
        plan.tasks.size(), plan.first ? "-d afterok:\"$first\" " : "");
    text += "last=$(hand_in --job-name=join -o \"$farm/log/join\" -d afterok:\"$tasks\" \"$@\" \"$farm/join\")\n";
    return text + fmt::format("echo \"{}$tasks $last\"\n", plan.first ? "$first " : "");
}

std::string slurm_task(const FarmFolder& folder)
{
    return script_head(folder, "The task of the array that Slurm starts") +
           "exec bash \"$farm/task\" \"$SLURM_ARRAY_TASK_ID\"\n";
}

/// Every task is begun each time, and leaves by +C what is there: only it knows whether the scene is still the same.
std::string makefile(const JobPlan& plan)
{
    std::string text =
        fmt::format("# make -j8 -C FOLDER: tasks that are done already leave what is there.\n"
                    "TASKS = $(addprefix task-,$(shell seq {}))\n.PHONY: join prepare sources $(TASKS)\n\n"
                    "join: $(TASKS)\n\tbash tries join\n\n$(TASKS): task-%: {}\n\tbash tries task $*\n",
                    plan.tasks.size(), plan.first ? "prepare" : "sources");
    if (plan.first) text += "\nprepare: sources\n\tbash tries prepare\n";
    return text + "\nsources:\n\tbash sources_now\n";
}

std::string make_submit(const FarmFolder& folder)
{
    return script_head(folder, "Runs the job here: bash submit [options of make]") +
           "exec make -C \"$farm\" -j\"$(nproc)\" -k \"$@\"\n";
}

/// Each host has as many slots as it is named; a slot that is free takes the next task.
std::string shell_submit(const JobPlan& plan, const FarmFolder& folder)
{
    std::string text = script_head(
        folder, "Runs the job: bash submit here, bash submit HOST HOST ... over ssh, a task at a time each");
    text += "hosts=(\"$@\")\nexport farm\nrun() {\n"
            "    if [[ $1 == - ]]; then exec bash \"$farm/tries\" \"${@:2}\"; fi\n"
            "    local status=0\n    ssh -o BatchMode=yes \"$1\" \"bash $(printf '%q' \"$farm/tries\") ${*:2}\" || "
            "status=$?\n"
            "    [[ $status != 255 ]] || status=75  # the host is away; xargs would end\n    return $status\n}\nexport "
            "-f run\n"
            "bash \"$farm/sources_now\"\n"
            "(( ${#hosts[@]} )) || mapfile -t hosts < <(yes - | head -n \"$(nproc)\")\n";
    if (plan.first) text += "bash \"$farm/tries\" prepare\n";
    return text +
           fmt::format("seq {} | xargs -P ${{#hosts[@]}} -n 1 --process-slot-var=slot bash -c "
                       "'hosts=(\"${{@:1:$#-1}}\"); run \"${{hosts[slot]}}\" task \"${{@: -1}}\"' - \"${{hosts[@]}}\" "
                       "|| true\n",
                       plan.tasks.size()) +
           "bash \"$farm/tries\" join\n";
}

std::string openjd_submit(const FarmFolder& folder)
{
    return script_head(
               folder,
               "Runs the template by the openjd command where it is installed; a farm takes template.json itself") +
           "if ! command -v openjd >/dev/null; then\n"
           "    echo \"hand $farm/template.json to your farm; here there is no openjd to run it (pip install "
           "openjd-cli)\" >&2\n"
           "    exit 1\nfi\nbash \"$farm/sources_now\"\nexec openjd run \"$farm/template.json\" \"$@\"\n";
}

std::string readme(const FarmJob& job, const JobPlan& plan, const FarmFolder& folder)
{
    constexpr const char* kEngines[] = {"Slurm", "Open Job Description", "make", "a shell"};
    return fmt::format(
        "{} in {} {}, for {}.\n`bash submit` hands it in; `tasks` has a line a task, `bash task N` runs one, `bash "
        "join` "
        "joins them and tells what is missing.\n`plan.json`: seconds and memory of each; `done/N.json`: what they "
        "took. "
        "`whittle plan ... --from=done` goes by that.\nHanded in again it goes on: what is there is left, what was "
        "interrupted continues.\nStatus 75 of a task: try again; 1: never (docs/farm.md).\n",
        job.settings.input_file, plan.tasks.size(), plan.parts ? "parts" : "tasks of frames",
        kEngines[static_cast<int>(folder.engine)]);
}

}  // namespace

std::vector<FarmFile> farm_files(const FarmJob& job, const JobPlan& plan, const FarmFolder& folder)
{
    std::string tasks;
    for (const FarmTask& task : plan.tasks) tasks += task.what + "\n";
    std::vector<FarmFile> files = {{"README", readme(job, plan, folder)},
                                   {"plan.json", plan_json(job, plan)},
                                   {"tasks", tasks},
                                   {"pieces", pieces_file(job, plan)},
                                   {"task", task_script(job, plan, folder)},
                                   {"join", join_script(job, plan, folder)},
                                   {"sources_now", sources_script(job, folder)}};
    if (plan.first) files.push_back({"prepare", prepare_script(job, folder)});
    switch (folder.engine) {
    case Engine::Slurm:
        files.push_back({"slurm_task", slurm_task(folder)});
        files.push_back({"submit", slurm_submit(job, plan, folder)});
        break;
    case Engine::OpenJd:
        files.push_back({"template.json", openjd_template(job, plan, folder)});
        files.push_back({"submit", openjd_submit(folder)});
        break;
    case Engine::Make:
        files.push_back({"tries", tries_script(folder)});
        files.push_back({"Makefile", makefile(plan)});
        files.push_back({"submit", make_submit(folder)});
        break;
    case Engine::Shell:
        files.push_back({"tries", tries_script(folder)});
        files.push_back({"submit", shell_submit(plan, folder)});
        break;
    }
    return files;
}

}  // namespace app
