#pragma once

#include "render/app/options/settings.h"

#include <span>
#include <string>
#include <string_view>

namespace app {

/// What becomes of an option.
enum class State {
    Acts,      ///< changes what the program does
    Settled,   ///< needs nothing: it cannot change the picture, or asks for what is done anyway
    NotYet,    ///< accepted, without effect for now; the user is told
    Obsolete,  ///< of earlier POV-Ray versions: a remark in an INI file, an error on the command line
};

enum class ValueKind { Flag, Integer, Number, Text, Gamma };

/// A value in the form that its option wants.
struct Value {
    std::string text;
    bool flag = false;
    int integer = 0;
    double number = 0.0;
    image::TransferCurve curve;
};

/// One INI keyword.
struct Option {
    std::string_view keyword;
    std::string_view meaning;
    ValueKind kind;
    State state;
    void (*apply)(Settings&, const Value&);  ///< null unless state is Acts
};

std::span<const Option> option_table();

/// Null if there is none; any case.
const Option* find_option(std::string_view keyword);

/// `keyword=text`. Throws OptionError for an unknown keyword or a malformed number.
void set_option(Settings& settings, std::string_view keyword, const std::string& text);

/// POV-Ray's idea of a truth: agrees with on, true, yes or 1 up to the end of the shorter one; never an error.
bool truth_of(std::string_view text);

/// POV-Ray's letter. Throws OptionError for another.
image::FileType file_type_of(char letter);

/// The part of a +F switch after the letter F, as in N16 or Pg. Throws OptionError.
void set_file_type_switch(Settings& settings, const std::string& text);

}  // namespace app
