#include "parser/lexer/new_words.h"

#include <unordered_set>

namespace parser {
namespace {

/// Identifiers from `at` up to the bracket that closes; `optional` before one is no name.
void add_names(const std::vector<Token>& tokens, std::size_t at, const Names& names,
               std::unordered_set<std::uint32_t>& declared)
{
    for (; at + 1 < tokens.size(); ++at) {
        const Kind kind = tokens[at].kind;
        if (kind == Kind::RightParen || kind == Kind::RightBrace || kind == Kind::Hash) return;
        if (kind != Kind::Identifier) continue;
        const bool before_name = tokens[at + 1].kind == Kind::Identifier;
        if (!before_name || names.new_word(tokens[at].name) != Kind::Optional) declared.insert(tokens[at].name);
    }
}

/// All names that a text gives a meaning to, wherever that holds.
std::unordered_set<std::uint32_t> declared_names(const std::vector<Token>& tokens, const Names& names)
{
    std::unordered_set<std::uint32_t> declared;
    for (std::size_t at = 0; at + 2 < tokens.size(); ++at) {
        const Token& next = tokens[at + 1];
        const bool named = next.kind == Kind::Identifier;
        switch (tokens[at].kind) {
        case Kind::Declare:
        case Kind::Local:
            if (named) declared.insert(next.name);
            else if (next.kind == Kind::LeftParen || next.kind == Kind::LeftBrace)
                add_names(tokens, at + 2, names, declared);
            break;
        case Kind::Macro:
            if (named) declared.insert(next.name), add_names(tokens, at + 2, names, declared);
            break;
        case Kind::Fopen:
            if (named) declared.insert(next.name);
            break;
        case Kind::For:
        case Kind::Function:
        case Kind::Read:
            if (next.kind == Kind::LeftParen) add_names(tokens, at + 2, names, declared);
            break;
        default: break;
        }
    }
    return declared;
}

}  // namespace

void settle_new_words(SourceFile& file, const Names& names)
{
    if (file.new_words.empty()) return;
    const std::unordered_set<std::uint32_t> declared = declared_names(file.tokens, names);
    for (std::size_t at = 0; at < file.tokens.size(); ++at) {
        Token& token = file.tokens[at];
        if (token.kind != Kind::Identifier || token.jump == kNoIndex || declared.contains(token.name)) continue;
        const Token& word = file.new_words[token.jump];
        const bool member = at > 0 && file.tokens[at - 1].kind == Kind::Period;
        if (!member || word.kind == Kind::Gray) token = word;
    }
}

}  // namespace parser
