#include "language/format/lines.h"

#include <algorithm>
#include <array>
#include <optional>

namespace language::format {
namespace {

/// Directives that an `#end` belongs to.
bool has_end(parser::Kind word)
{
    using parser::Kind;
    constexpr std::array kOpening{Kind::If,    Kind::Ifdef, Kind::Ifndef, Kind::Switch,
                                  Kind::While, Kind::For,   Kind::Macro};
    return std::find(kOpening.begin(), kOpening.end(), word) != kOpening.end();
}

using parser::Kind;

/// A directive whose `#end` is still to come.
struct Directive {
    Kind word = Kind::If;
    int braces = 0;             ///< open where it began
    std::optional<int> behind;  ///< braces open behind its first branch
    bool in_case = false;
    bool whole_text = false;  ///< `#ifndef ... #end` around a whole include file: nothing is gained by a level
};

/// What is open at a place of the text.
class Nesting {
public:
    /// Both branches of an #if may open the same brace; the text behind it is in one.
    void take(const std::vector<Piece>& pieces, std::size_t at, bool whole_text)
    {
        const Piece& piece = pieces[at];
        if (piece.what != PieceKind::Token) return;
        switch (piece.kind) {
        case Kind::LeftBrace:
            ++braces_;
            outer_.push_back(marks_);
            marks_ = 0;
            break;
        case Kind::RightBrace:
            braces_ = std::max(braces_ - 1, 0);
            marks_ = outer_.empty() ? 0 : outer_.back();
            if (!outer_.empty()) outer_.pop_back();
            break;
        case Kind::LeftParen:
        case Kind::LeftSquare: ++marks_; break;
        case Kind::RightParen:
        case Kind::RightSquare: marks_ = std::max(marks_ - 1, 0); break;
        case Kind::Less: marks_ += piece.role == Role::OpensVector; break;
        case Kind::Greater: marks_ = std::max(marks_ - (piece.role == Role::ClosesVector), 0); break;
        default:
            if (at > 0 && pieces[at - 1].kind == Kind::Hash) directive(piece.kind, whole_text);
            break;
        }
    }
    int level() const
    {
        int sum = braces_;
        for (const Directive& d : directives_) sum += !d.whole_text + d.in_case;
        return sum;
    }
    bool in_marks() const { return marks_ > 0; }

private:
    void directive(Kind word, bool whole_text)
    {
        if (has_end(word)) return directives_.push_back({word, braces_, {}, false, whole_text});
        switch (word) {
        case Kind::Else:
        case Kind::Elseif:
        case Kind::Case:
        case Kind::Range: {
            if (directives_.empty()) break;
            Directive& d = directives_.back();
            if (d.word == Kind::While || d.word == Kind::For || d.word == Kind::Macro) break;
            if (!d.behind && (d.word != Kind::Switch || d.in_case)) d.behind = braces_;
            d.in_case = d.word == Kind::Switch;
            braces_ = d.braces;
            break;
        }
        case Kind::End:
            if (directives_.empty()) break;
            braces_ = directives_.back().behind.value_or(braces_);
            directives_.pop_back();
            break;
        default: break;
        }
    }
    int braces_ = 0;
    int marks_ = 0;           ///< parentheses, brackets and vectors open since the last brace
    std::vector<int> outer_;  ///< the same outside of each brace
    std::vector<Directive> directives_;

    friend int level_of(const Nesting&, const std::vector<Piece>&, const Line&);
};

/// Level of a line that begins in this state: what it closes first counts no more.
int level_of(const Nesting& before, const std::vector<Piece>& pieces, const Line& line)
{
    const Piece& first = pieces[line.begin];
    if (first.what != PieceKind::Token) return before.level() + before.in_marks();
    if (first.kind == Kind::Hash && line.begin + 1 < line.end && !before.directives_.empty()) {
        const Kind word = pieces[line.begin + 1].kind;
        const Directive& d = before.directives_.back();
        const int outside = before.level() - !d.whole_text - d.in_case - before.braces_ + d.braces;
        if (word == Kind::End || word == Kind::Else || word == Kind::Elseif)
            return outside + (word != Kind::End && d.word == Kind::Switch);
        if ((word == Kind::Case || word == Kind::Range) && d.word == Kind::Switch) return outside + 1;
    }
    Nesting state = before;
    std::size_t at = line.begin;
    const auto closing = [&](const Piece& p) {
        return p.kind == Kind::RightBrace || p.kind == Kind::RightParen || p.kind == Kind::RightSquare ||
               p.role == Role::ClosesVector;
    };
    while (at < line.end && pieces[at].what == PieceKind::Token && closing(pieces[at])) state.take(pieces, at++, false);
    return state.level() + state.in_marks();
}

bool joins_operands(const Piece& piece)
{
    switch (piece.kind) {
    case Kind::Equal:
    case Kind::NotEqual:
    case Kind::Ampersand:
    case Kind::Bar:
    case Kind::Question:
    case Kind::Colon:
    case Kind::LessEqual:
    case Kind::GreaterEqual: return true;
    case Kind::Plus:
    case Kind::Minus:
    case Kind::Star:
    case Kind::Slash: return piece.role != Role::Sign && piece.role != Role::AsWritten;
    case Kind::Less:
    case Kind::Greater: return piece.role == Role::Plain;
    default: return false;
    }
}

/// The line goes on with an expression that the line before began.
bool goes_on(const std::vector<Piece>& pieces, const Line& line, std::optional<std::size_t> last_token)
{
    for (std::size_t i = line.begin; i < line.end; ++i)
        if (pieces[i].kind == Kind::LeftBrace || pieces[i].kind == Kind::RightBrace) return false;
    if (pieces[line.begin].what != PieceKind::Token || pieces[line.begin].kind == Kind::Hash) return false;
    return joins_operands(pieces[line.begin]) || (last_token && joins_operands(pieces[*last_token]));
}

/// An `#ifndef` at the start of a text whose `#end` is the last that stands in it.
bool guards_whole_text(const std::vector<Piece>& pieces)
{
    std::vector<std::size_t> tokens;
    for (std::size_t i = 0; i < pieces.size() && tokens.size() < 2; ++i)
        if (pieces[i].what == PieceKind::Token) tokens.push_back(i);
    if (tokens.size() < 2 || pieces[tokens[1]].kind != Kind::Ifndef || pieces[tokens[0]].kind != Kind::Hash)
        return false;
    int depth = 0;
    for (std::size_t i = tokens[1]; i < pieces.size(); ++i) {
        if (pieces[i].what != PieceKind::Token || pieces[i - 1].kind != Kind::Hash) continue;
        depth += has_end(pieces[i].kind);
        switch (pieces[i].kind) {
        case Kind::Else:
        case Kind::Elseif:
            if (depth == 1) return false;
            break;
        case Kind::End:
            if (--depth == 0)
                return std::none_of(pieces.begin() + static_cast<std::ptrdiff_t>(i) + 1, pieces.end(),
                                    [](const Piece& p) { return p.what == PieceKind::Token; });
            break;
        default: break;
        }
    }
    return false;
}

}  // namespace

void indent(std::vector<Line>& lines, const std::vector<Piece>& pieces)
{
    constexpr int kDeepest = 40;
    bool guard = guards_whole_text(pieces);
    Nesting nesting;
    std::optional<std::size_t> last_token;
    for (Line& line : lines) {
        line.level = level_of(nesting, pieces, line);
        if (!nesting.in_marks() && goes_on(pieces, line, last_token)) ++line.level;
        line.level = std::clamp(line.level, 0, kDeepest);
        for (std::size_t at = line.begin; at < line.end; ++at) {
            if (pieces[at].what != PieceKind::Token) continue;
            nesting.take(pieces, at, guard && pieces[at].kind == Kind::Ifndef);
            if (pieces[at].kind == Kind::Ifndef) guard = false;
            last_token = at;
        }
    }
}

}  // namespace language::format
