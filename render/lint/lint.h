#pragma once

#include "render/scene/description.h"

#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Doubts about a scene that can be read: each has a name and can be switched off by it.
namespace lint {

struct Check {
    std::string_view name;
    std::string_view meaning;  ///< one line
};

/// All that there are, in the order in which they are told.
std::span<const Check> checks();

struct Finding {
    std::string_view check;  ///< its name
    scene::Message message;  ///< a warning; its text ends with the name in brackets
};

/// The text of a file, as an editor has it or from disk; nothing: it cannot be read.
using Reader = std::function<std::optional<std::string>(const std::string& path)>;

/// What to look for.
struct Wanted {
    std::set<std::string, std::less<>> off;
    bool wants(std::string_view check) const { return !off.contains(check); }
};

/// What the tokens of a text say by themselves. `others`: paths of files that were read with it, where its names may be
/// used.
std::vector<Finding> check_text(const std::string& path, const std::vector<std::string>& others, const Reader& read,
                                const Wanted& wanted);

/// What the parser has told already and is a check's as well.
std::vector<Finding> check_messages(std::span<const scene::Message> messages, const Reader& read, const Wanted& wanted);

/// What was made of the text. Slow checks are left out unless `thorough`: they ask solids at many points.
std::vector<Finding> check_scene(const scene::Description& description, const Reader& read, const Wanted& wanted,
                                 bool thorough = true);

/// The finding for a loop in which reading was stopped: `at` is what the parser says of it.
Finding endless_loop(const scene::Message& at, double seconds);

}  // namespace lint
