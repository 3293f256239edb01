#pragma once

#include "parser/lexer/lexer.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace language {

/// Bytes of a text.
struct Range {
    std::uint32_t begin = 0, end = 0;
    friend bool operator==(const Range&, const Range&) = default;
};

inline constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// A text with its tokens and brackets, in whatever state it is. Tokens are told by their index.
class Document {
public:
    Document(std::string path, std::string text);
    const std::string& path() const { return file_.path; }
    const std::string& text() const { return file_.text; }
    const scene::LineTable& lines() const { return file_.lines(); }
    /// The last one is EndOfText.
    const std::vector<parser::Token>& tokens() const { return file_.tokens; }
    parser::Kind kind(std::size_t at) const
    {
        return at < tokens().size() ? tokens()[at].kind : parser::Kind::EndOfText;
    }
    bool is_word(std::size_t at) const { return kind(at) == parser::Kind::Identifier || parser::is_keyword(kind(at)); }
    /// Of an identifier or a keyword, else empty.
    std::string_view word(std::size_t at) const;
    /// Whether an identifier is a member, as in `Dictionary.Name`.
    bool is_member(std::size_t at) const;
    Range range(std::size_t at) const;
    /// What stands from one token to behind another.
    std::string_view text_of(std::size_t first, std::size_t behind) const;
    /// Of a String token, without its quotes, as written.
    std::string_view string(std::size_t at) const;
    /// Of a Bad token: why it is none.
    std::string_view complaint(std::size_t at) const { return file_.strings[tokens()[at].name]; }
    /// The bracket that belongs to one; kNone: it is no bracket or has none.
    std::size_t partner(std::size_t at) const { return at < partners_.size() ? partners_[at] : kNone; }
    /// The last token that begins before a byte; kNone: there is none.
    std::size_t before(std::uint32_t offset) const;
    /// The word that holds a byte or ends there; kNone: there is none.
    std::size_t word_at(std::uint32_t offset) const;
    /// The innermost '{' that is open at a byte; kNone: there is none.
    std::size_t open_brace(std::uint32_t offset) const;

private:
    parser::SourceFile file_;
    parser::Names names_;
    std::vector<std::size_t> partners_;
};

/// Comments of a text in order, `//` to the end of the line or `/* */`. One that is not closed reaches to the end.
std::vector<Range> comments_of(const Document& document);

}  // namespace language
