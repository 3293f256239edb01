#include "render/lint/findings.h"

#include <fmt/format.h>

#include <set>
#include <string>

// A #while whose condition nothing in its body can change. Only sure cases are told: a macro, a file or a #break in the
// body may do anything.
namespace lint {
namespace {

using parser::Kind;
using parser::Token;

bool opens_block(Kind word)
{
    return word == Kind::If || word == Kind::Ifdef || word == Kind::Ifndef || word == Kind::While ||
           word == Kind::For || word == Kind::Switch || word == Kind::Macro;
}

/// Words that give another value each time, or may.
bool changes_by_itself(Kind word)
{
    return word == Kind::Rand || word == Kind::Now || word == Kind::Defined || word == Kind::FileExists ||
           word == Kind::DimensionSize || word == Kind::Datetime;
}

std::set<std::uint32_t> macros_of(Texts& texts, const std::vector<std::string>& paths)
{
    std::set<std::uint32_t> names;
    for (const std::string& path : paths)
        if (const parser::SourceFile* file = texts.file(path))
            for (std::size_t i = 0; i + 2 < file->tokens.size(); ++i)
                if (file->tokens[i].kind == Kind::Hash && file->tokens[i + 1].kind == Kind::Macro)
                    names.insert(file->tokens[i + 2].name);
    return names;
}

struct Condition {
    std::size_t end = 0;  ///< token behind its ')'
    std::set<std::uint32_t> names;
    bool sure = true;  ///< nothing in it changes by itself
};

Condition condition_at(const std::vector<Token>& tokens, std::size_t open, const std::set<std::uint32_t>& macros)
{
    Condition out;
    int depth = 0;
    std::size_t at = open;
    for (; at < tokens.size() && tokens[at].kind != Kind::EndOfText; ++at) {
        if (tokens[at].kind == Kind::LeftParen) ++depth;
        if (tokens[at].kind == Kind::RightParen && --depth == 0) break;
        if (tokens[at].kind == Kind::Identifier) {
            out.names.insert(tokens[at].name);
            if (macros.contains(tokens[at].name)) out.sure = false;
        }
        if (changes_by_itself(tokens[at].kind)) out.sure = false;
    }
    out.sure = out.sure && at < tokens.size() && tokens[open].kind == Kind::LeftParen;
    out.end = at + 1;
    return out;
}

/// Whether the body, from a token on, may end the loop whose condition that is.
bool may_end(const std::vector<Token>& tokens, const Condition& condition, const std::set<std::uint32_t>& macros)
{
    int depth = 1, catches_break = 0;
    std::vector<bool> open;  // whether a #break inside belongs to the block
    for (std::size_t at = condition.end; at + 1 < tokens.size(); ++at) {
        const Token& token = tokens[at];
        if (token.kind == Kind::Identifier && macros.contains(token.name)) return true;
        if (token.kind != Kind::Hash) continue;
        const Kind word = tokens[at + 1].kind;
        if (opens_block(word)) {
            ++depth;
            open.push_back(word == Kind::While || word == Kind::For || word == Kind::Switch);
            catches_break += open.back();
            if (word == Kind::For && at + 3 < tokens.size() && condition.names.contains(tokens[at + 3].name))
                return true;
        } else if (word == Kind::End) {
            if (--depth == 0) return false;
            catches_break -= open.back();
            open.pop_back();
        } else if (word == Kind::Break && catches_break == 0) {
            return true;
        } else if (word == Kind::Include || word == Kind::Error || word == Kind::Fclose) {
            return true;
        } else if (word == Kind::Declare || word == Kind::Local || word == Kind::Undef || word == Kind::Read) {
            // Names up to the value; `#read (file, A, B)` and `#declare (A, B) = ...` have several.
            for (std::size_t i = at + 2; i < tokens.size(); ++i) {
                const Kind kind = tokens[i].kind;
                if (kind == Kind::Identifier && condition.names.contains(tokens[i].name)) return true;
                if (kind == Kind::Equal || kind == Kind::Hash || kind == Kind::EndOfText) break;
                if (word == Kind::Read && kind == Kind::RightParen) break;
                if (word == Kind::Undef) break;
            }
        }
    }
    return true;  // no #end: the parser says so
}

}  // namespace

void check_loops(Findings& out, const std::string& path, const std::vector<std::string>& others)
{
    if (!out.wants("endless-loop")) return;
    const parser::SourceFile* file = out.texts().file(path);
    if (!file) return;
    std::vector<std::string> all = others;
    all.push_back(path);
    const std::set<std::uint32_t> macros = macros_of(out.texts(), all);
    for (std::size_t at = 0; at + 2 < file->tokens.size(); ++at) {
        if (file->tokens[at].kind != Kind::Hash || file->tokens[at + 1].kind != Kind::While) continue;
        const Condition condition = condition_at(file->tokens, at + 2, macros);
        if (!condition.sure || condition.end >= file->tokens.size() || may_end(file->tokens, condition, macros))
            continue;
        // A constant that is 0 keeps the body from being read at all.
        const bool constant = condition.names.empty();
        out.add("endless-loop", path, file->tokens[at].offset,
                constant ? "the condition of this loop is a constant, and nothing in the loop leaves it"
                         : fmt::format("nothing in this loop changes '{}', which its condition asks for",
                                       out.texts().names().word(*condition.names.begin())));
    }
}

}  // namespace lint
