#pragma once

#include "render/app/options/settings.h"

#include <span>
#include <string>
#include <string_view>

namespace app {

/// One switch: its letters, whether text follows them, the flag that its sign sets and the option that the text sets.
struct Switch {
    const char* letters;
    bool parameter;
    const char* flag;         ///< null: the sign does not matter
    const char* option;       ///< null: the text is not used
    const char* prefix = "";  ///< put before the text: the digit that the letters took from a number
};

/// In the order in which they are tried.
std::span<const Switch> switch_table();

/// A switch as texts show it, "+W<n>", and what it does; empty for the second half of an entry that took a digit.
struct SwitchText {
    std::string form;
    std::string_view meaning;
};
SwitchText text_of(const Switch& entry);

/// One switch with its sign, as in +W640 or -A. Throws OptionError for one that is not known.
void apply_switch(Settings& settings, const std::string& word);

}  // namespace app
