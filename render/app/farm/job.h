#pragma once

#include "render/app/frames/frames.h"

#include <string>
#include <vector>

namespace app {

/// What is to be rendered on many machines, and in how many tasks.
struct FarmJob {
    Settings settings;               ///< what the words come to
    std::vector<std::string> words;  ///< for the renderer, as given
    FrameList list;
    int tasks = 0;     ///< at most
    int cores = 1;     ///< of a task
    std::string from;  ///< folder with --json files of finished tasks; empty: none
};

/// Takes the word at `i`, and its value, if it is one of the job's own: --tasks, --cores, --from.
bool take_job_word(const std::vector<std::string>& arguments, std::size_t& i, FarmJob& job);

/// The value of `--name=value`, or of `--name value`, whose second word is taken too. False: another word.
bool take_word_value(const std::vector<std::string>& arguments, std::size_t& i, const char* name, std::string& value);

/// Understands the renderer's words; throws OptionError.
void complete(FarmJob& job, std::vector<std::string> words);

/// The renderer's file: `whittle` beside this program or where it is installed.
std::string renderer_program();

}  // namespace app
