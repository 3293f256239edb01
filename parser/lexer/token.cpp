#include "parser/lexer/token.h"

#include <array>

namespace parser {
namespace {

struct Word {
    std::string_view text;
    Kind kind;
    bool is_new = false;
};

constexpr Word kWords[] = {
#define WHITTLE_KEYWORD(word, kind, lexical_class) {word, Kind::kind},
#define WHITTLE_NEW_KEYWORD(word, kind, lexical_class) {word, Kind::kind, true},
#define WHITTLE_SPELLING(word, kind) {word, Kind::kind},
#define WHITTLE_NEW_SPELLING(word, kind) {word, Kind::kind, true},
#include "parser/lexer/keywords.inc"
};

constexpr LexicalClass kClasses[] = {
#define WHITTLE_KEYWORD(word, kind, lexical_class) LexicalClass::lexical_class,
#define WHITTLE_NEW_KEYWORD(word, kind, lexical_class) LexicalClass::lexical_class,
#define WHITTLE_SPELLING(word, kind)
#define WHITTLE_NEW_SPELLING(word, kind)
#include "parser/lexer/keywords.inc"
};

// clang-format off
constexpr std::string_view kPlain[] = {
    "end of text", "illegal text", "#", "identifier", "number", "string", "numbers", "faces",
    "{", "}", "(", ")", "[", "]", "<", ">", "<=", ">=", "=", "!=", "!", "&", "|", "?", ":", ",", ";", ".",
    "+", "-", "*", "/", "@", "%", "^", "$", "~", "'", "`", "\\",
};
// clang-format on
static_assert(std::size(kPlain) == static_cast<std::size_t>(kFirstKeyword));

std::unordered_map<std::string_view, Kind> keyword_table()
{
    std::unordered_map<std::string_view, Kind> table;
    for (const Word& word : kWords) table.emplace(word.text, word.kind);
    return table;
}

}  // namespace

LexicalClass lexical_class(Kind kind)
{
    if (!is_keyword(kind)) return LexicalClass::None;
    return kClasses[static_cast<std::size_t>(kind) - static_cast<std::size_t>(kFirstKeyword)];
}

std::string_view spelling(Kind kind)
{
    const auto index = static_cast<std::size_t>(kind);
    if (index < std::size(kPlain)) return kPlain[index];
    return kWords[index - std::size(kPlain)].text;  // enumerators and words stand in the same order
}

Kind keyword_of(std::string_view word)
{
    static const std::unordered_map<std::string_view, Kind> table = keyword_table();
    const auto found = table.find(word);
    return found == table.end() ? Kind::Identifier : found->second;
}

Names::Names()
{
    index_.reserve(4096);
    for (const Word& word : kWords) {
        index_.emplace(words_.emplace_back(word.text), static_cast<std::uint32_t>(kinds_.size()));
        kinds_.push_back(word.kind);
        new_.push_back(word.is_new);
    }
}

std::uint32_t Names::intern(std::string_view word)
{
    const auto found = index_.find(word);
    if (found != index_.end()) return found->second;
    const auto name = static_cast<std::uint32_t>(words_.size());
    index_.emplace(words_.emplace_back(word), name);
    return name;
}

}  // namespace parser
