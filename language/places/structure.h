#pragma once

#include "language/names/outline.h"

#include <string>
#include <vector>

namespace language {

/// A line of an editor's outline.
struct Entry {
    std::string name, detail;
    enum class Kind : std::uint8_t { Variable, Constant, Function, Object } kind = Kind::Variable;
    Range whole, word;
    std::vector<Entry> inner;  ///< of a macro
};

/// Declarations, macros with what is local to them, and the objects, lights and cameras outside of all blocks.
std::vector<Entry> entries_of(const Document& document, const Outline& outline);

/// What can be folded, by lines from 1, the first being the one that stays.
struct Fold {
    std::uint32_t first = 0, last = 0;
    bool comment = false;
    friend bool operator==(const Fold&, const Fold&) = default;
};

/// Blocks in braces, directives up to their next branch or end, comments of several lines.
std::vector<Fold> folds_of(const Document& document);

}  // namespace language
