#pragma once

#include "render/app/options/settings.h"

#include <span>
#include <string>
#include <string_view>

namespace app {

/// One of Whittle's own options: `--name`, or `--name=value` (also as two arguments, `--name value`).
struct OwnOption {
    std::string_view name;   ///< without the dashes
    std::string_view value;  ///< what stands for the value in texts; empty: none. With '|': one of these words
    std::string_view meaning;
    /// Null for what main() answers by itself: help, version and the like.
    void (*apply)(Settings&, const std::string& value);
    bool value_may_lack = false;  ///< then it is only taken behind '='

    /// As texts show it: "--name", "--name=value", "--name[=value]".
    std::string form() const;
};

std::span<const OwnOption> own_options();

/// Null if there is none.
/// \param word  with its dashes, with or without "=value"
const OwnOption* find_own_option(std::string_view word);

/// Applies `--name`, `--name=value`; `next` is the argument behind it, and true is returned if that was its value.
/// Throws OptionError for an unknown option, a value that is missing, or one too many.
bool apply_own_option(Settings& settings, const std::string& word, const std::string* next);

}  // namespace app
