#pragma once

#include "language/names/symbol.h"

#include <string>
#include <string_view>
#include <vector>

namespace language {

enum class ItemKind : std::uint8_t { Directive, Keyword, Function, Constant, Variable, Macro, Parameter, File, Folder };

/// Something that may be written at a place.
struct Item {
    std::string word;
    ItemKind kind = ItemKind::Keyword;
    std::string detail;  ///< what it is, in a line
    int rank = 0;        ///< lower ones first
};

struct Completion {
    std::vector<Item> items;
    Range replaced;        ///< the word, or the last part of a file's name, around the place
    bool complete = true;  ///< else there are more than were told
};

/// What may stand at a byte of a text that `files` has: after '#' directives, in `#include` files, in a block its
/// words, and declared names. Nothing in comments and texts.
Completion completion_at(Files& files, const std::string& path, std::uint32_t offset);

}  // namespace language
