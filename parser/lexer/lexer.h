#pragma once

#include "parser/lexer/token.h"
#include "render/scene/base/line_table.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace parser {

/// One text, read as bytes, and its tokens. Made once however often the text is included or looped over.
///
/// The `jump` of a Hash before if/ifdef/ifndef/while/for/switch/macro/else/elseif/case/range is the index of the Hash
/// of the next branch at the same level (at last of `#end`), kNoIndex where the file ends first: a false branch is
/// left in one step. For Hash tokens before other words it is kNoIndex.
struct SourceFile {
    std::string path;                  ///< as told in messages
    std::string text;                  ///< empty once it was given back: whole_text() has it
    std::vector<Token> tokens;         ///< ends with EndOfText
    std::vector<std::string> strings;  ///< raw text of String tokens, messages of Bad tokens
    std::vector<double> numbers;       ///< of Numbers tokens
    std::vector<Token> new_words;      ///< Identifiers that POV-Ray 3.8 reserves, as the words that they are there
    std::vector<std::uint32_t> bad;    ///< indices of Bad tokens, ascending: skipped text must be well-formed too

    /// Frees the text of a long file, which only messages ask for from now on. `reread` reads it again; empty: it is
    /// not what it was.
    void give_text_back(std::function<std::string()> reread);
    /// The same of a text that it never had.
    void do_without(std::string_view whole, std::function<std::string()> reread);
    const std::string& whole_text() const;
    bool can_read_again() const { return reread_ != nullptr; }

    using Place = scene::LineAndColumn;
    Place locate(std::uint32_t offset) const { return lines().place(offset); }
    const scene::LineTable& lines() const;                 ///< made when it is asked for
    std::string_view line_text(std::uint32_t line) const;  ///< without its line end
    /// The text of a token as the author wrote it (a word, a number, a string with its quotes).
    std::string_view token_text(const Token& token) const;

private:
    std::function<std::string()> reread_;
    mutable std::string again_;
    mutable scene::LineTable lines_;
};

/// Turns file.text into tokens (spec 1, 1: comments nest, signs are never part of a number, ...).
/// Never throws for any bytes: what is no token becomes a Bad token. `main_text`: a byte-order mark and other bytes
/// above 127 at the very start are skipped; returns whether there were any.
/// `lists`: literal lists of meshes become Numbers tokens.
bool tokenize(SourceFile& file, std::uint16_t file_index, Names& names, bool main_text, bool lists = true);
/// The same of a text that lies elsewhere: the file does not get it.
bool tokenize(std::string_view text, SourceFile& file, std::uint16_t file_index, Names& names, bool main_text,
              bool lists = true);

}  // namespace parser
