#pragma once

#include "parser/lexer/lexer.h"
#include "parser/nearest.h"
#include "render/scene/base/message.h"

#include <string>
#include <string_view>
#include <vector>

namespace parser {

/// The line of a place, which is somewhere. Long lines are cut around it.
scene::QuotedLine quoted_line(const SourceFile& file, const scene::LineAndColumn& at);

/// The text with '?' for control characters and for bytes that are no UTF-8; tabs stay.
std::string printable(std::string_view text);
/// The last beginning of a UTF-8 character at or before byte `at`.
std::size_t character_start(std::string_view text, std::size_t at);

/// How many letters must be inserted, removed, exchanged or swapped with their neighbour to turn one into the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Keeps the candidate nearest to `word`, if any is near enough to be a slip of the pen.
class NearestName {
public:
    explicit NearestName(std::string_view word);
    void offer(std::string_view candidate);
    std::string_view best() const { return best_; }  ///< empty if none

private:
    std::string_view word_, best_;
    std::size_t distance_;
};

}  // namespace parser
