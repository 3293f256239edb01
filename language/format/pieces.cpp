#include "language/format/pieces.h"

#include "language/format/format.h"
#include "parser/lexer/lexer.h"
#include "parser/lexer/new_words.h"

#include <algorithm>

namespace language::format {
namespace {

using parser::Kind;

bool line_end(char c) { return c == '\n' || c == '\r'; }

/// Behind the closing quote of the text that begins at `at`.
std::uint32_t string_end(std::string_view text, std::uint32_t at)
{
    for (std::uint32_t i = at + 1; i < text.size(); ++i) {
        if (text[i] == '\\') ++i;
        else if (text[i] == '"') return i + 1;
    }
    return static_cast<std::uint32_t>(text.size());
}

/// Behind the comment that begins at `at`; such comments nest.
std::uint32_t block_comment_end(std::string_view text, std::uint32_t at)
{
    int depth = 0;
    for (std::uint32_t i = at; i + 1 < text.size(); ++i) {
        if (text[i] == '/' && text[i + 1] == '*') ++depth, ++i;
        else if (text[i] == '*' && text[i + 1] == '/' && (++i, --depth == 0)) return i + 1;
    }
    return static_cast<std::uint32_t>(text.size());
}

/// Reads blanks and comments between two tokens.
class Gap {
public:
    Gap(std::string_view text, std::vector<Piece>& out) : text_(text), out_(out) {}
    void read(std::uint32_t at, std::uint32_t end)
    {
        while (at < end) {
            const bool slash = text_[at] == '/' && at + 1 < end;
            if (slash && text_[at + 1] == '/') {
                std::uint32_t stop = at;
                while (stop < end && !line_end(text_[stop])) ++stop;
                std::uint32_t last = stop;
                while (last > at && (text_[last - 1] == ' ' || text_[last - 1] == '\t')) --last;
                add(PieceKind::LineComment, at, last);
                at = stop;
            } else if (slash && text_[at + 1] == '*') {
                const std::uint32_t stop = std::min(block_comment_end(text_, at), end);
                add(PieceKind::BlockComment, at, stop);
                at = stop;
            } else {
                blank_ = true;
                if (text_[at] == '\n' || (text_[at] == '\r' && (at + 1 == text_.size() || text_[at + 1] != '\n')))
                    ++lines_;
                ++at;
            }
        }
    }
    Piece& add(PieceKind what, std::uint32_t begin, std::uint32_t end)
    {
        Piece piece;
        piece.what = what;
        piece.begin = begin;
        piece.end = end;
        piece.blank_before = blank_;
        piece.lines_before = lines_;
        blank_ = false;
        lines_ = 0;
        return out_.emplace_back(piece);
    }

private:
    std::string_view text_;
    std::vector<Piece>& out_;
    bool blank_ = false;
    std::uint32_t lines_ = 0;
};

}  // namespace

std::uint32_t skipped_start(std::string_view text)
{
    std::uint32_t skipped = 0;
    while (skipped < text.size() && static_cast<unsigned char>(text[skipped]) > 127) ++skipped;
    return skipped;
}

std::vector<Piece> pieces_of(std::string_view text)
{
    parser::SourceFile file;
    file.text = text;
    parser::Names names;
    parser::tokenize(file, 0, names, true, false);
    parser::settle_new_words(file, names);
    if (!file.bad.empty()) {
        const parser::Token& bad = file.tokens[file.bad.front()];
        throw Refused(bad.offset, file.strings[bad.name]);
    }
    std::vector<Piece> pieces;
    pieces.reserve(file.tokens.size() + file.tokens.size() / 8);
    Gap gap(text, pieces);
    std::uint32_t at = skipped_start(text);
    for (std::size_t i = 0; i + 1 < file.tokens.size(); ++i) {
        const parser::Token& token = file.tokens[i];
        gap.read(at, token.offset);
        at = token.kind == Kind::String ? string_end(text, token.offset)
                                        : token.offset + static_cast<std::uint32_t>(file.token_text(token).size());
        at = std::min(at, file.tokens[i + 1].offset);
        gap.add(PieceKind::Token, token.offset, at).kind = token.kind;
    }
    gap.read(at, static_cast<std::uint32_t>(text.size()));
    return pieces;
}

}  // namespace language::format
