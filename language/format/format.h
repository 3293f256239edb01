#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

/// Scene text as it is usually laid out: blanks, indentation and line ends change, tokens and comments do not.
namespace language::format {

struct Options {
    int indent = 2;     ///< columns a level, 1 to 16
    bool tabs = false;  ///< a tab a level, counted as `indent` columns
    int width = 120;    ///< columns; longer lines are broken where a block or a list allows it
};

/// The text cannot be laid out: it holds something that is no token. what() is one line without a place.
class Refused : public std::runtime_error {
public:
    Refused(std::uint32_t at, const std::string& why) : std::runtime_error(why), offset(at) {}
    std::uint32_t offset;  ///< byte of the text
};

/// The text laid out. Line ends are those of its first line. Applied twice it changes nothing more.
/// Throws Refused; never gives a text whose tokens or comments differ from those of `text`.
std::string formatted(std::string_view text, const Options& options = {});

}  // namespace language::format
