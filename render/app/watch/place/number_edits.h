#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace app {

/// Numbers of a file that a page has set, in place of those that the text has.
struct NumberEdits {
    struct Number {
        std::uint32_t end = 0;  ///< byte behind it in the file
        double value = 0;
        bool operator==(const Number&) const = default;
    };
    std::uint64_t mark = 0;                   ///< of the file's text that the bytes are of
    std::map<std::uint32_t, Number> numbers;  ///< by first byte in the file
    bool operator==(const NumberEdits&) const = default;
};

/// As it is written: the shortest that reads as nearly so, with six digits at most.
std::string number_text(double value);

/// The file's text with them.
std::string edited(const std::string& text, const NumberEdits& edits);

/// Where a byte of the file is in the edited text.
std::uint32_t edited_place(std::uint32_t offset, const NumberEdits& edits);

/// Where a byte of the edited text is in the file; within a number it is that one's first.
std::uint32_t written_place(std::uint32_t offset, const NumberEdits& edits);

}  // namespace app
