#pragma once

#include "language/names/document.h"

#include <string>
#include <vector>

namespace app {

/// A number as a text writes it, that a page may change.
struct FocusedNumber {
    language::Range range;
    double value = 0;
    std::string word;  ///< the nearest before it: "scale", "rgb", a name
};

/// What stands at a place of a text.
struct Focus {
    std::vector<language::Range> statements;  ///< blocks with their words that hold the place, the innermost first
    std::vector<FocusedNumber> numbers;       ///< of the innermost one; that at the place first
};

/// The statements at a byte of a text, and the numbers of the innermost: at most `most`.
Focus focus_at(const language::Document& document, std::uint32_t offset, std::size_t most);

/// The number of a text that begins at a byte; its range is empty where none does.
FocusedNumber number_at(const language::Document& document, std::uint32_t offset);

}  // namespace app
