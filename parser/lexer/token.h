#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace parser {

/// What a token is. First what words cannot be, then one enumerator for every reserved word (keywords.inc); a second
/// spelling (`colour`) is the same kind. `EndOfText` stands behind the last token of a text.
enum class Kind : std::uint16_t {
    EndOfText,
    Bad,         ///< text that is no token: `name` is the string index of the message, raised when it is met
    Hash,        ///< `#`; `jump` leads to the next branch of the same conditional, see SourceFile
    Identifier,  ///< a word that is not reserved: `name`
    Number,      ///< `number`
    String,      ///< `name` is the string index of the raw text (escapes not yet resolved, but \" is)
    Numbers,     ///< literal vectors (number_blocks.h): `name` their first value, `jump` how many, `number` values each
    Faces,  ///< literal triangles from the brace of a mesh on (number_blocks.h): `name` their first value, `jump` how
            ///< many
    LeftBrace,
    RightBrace,
    LeftParen,
    RightParen,
    LeftSquare,
    RightSquare,
    Less,
    Greater,
    LessEqual,
    GreaterEqual,
    Equal,
    NotEqual,
    Exclamation,
    Ampersand,
    Bar,
    Question,
    Colon,
    Comma,
    Semicolon,
    Period,
    Plus,
    Minus,
    Star,
    Slash,
    At,
    Percent,
    Caret,
    Dollar,
    Tilde,
    Apostrophe,
    Backquote,
    Backslash,
#define WHITTLE_KEYWORD(word, kind, lexical_class) kind,
#define WHITTLE_NEW_KEYWORD(word, kind, lexical_class) kind,
#define WHITTLE_SPELLING(word, kind)
#define WHITTLE_NEW_SPELLING(word, kind)
#include "parser/lexer/keywords.inc"
    kCount
};

inline constexpr Kind kFirstKeyword = static_cast<Kind>(static_cast<std::uint16_t>(Kind::Backslash) + 1);
inline constexpr std::size_t kKindCount = static_cast<std::size_t>(Kind::kCount);

/// How a reserved word may begin an expression.
enum class LexicalClass : std::uint8_t { None, Float, Vector, Vector2, Vector4, Color, String, Other };

constexpr bool is_keyword(Kind kind) { return kind >= kFirstKeyword; }
LexicalClass lexical_class(Kind kind);  ///< None for what is no reserved word
std::string_view spelling(Kind kind);   ///< "sphere", "{", "number", ...: for messages

inline constexpr std::uint32_t kNoIndex = 0xffffffffu;

struct Token {
    Kind kind = Kind::EndOfText;
    std::uint16_t file = 0;         ///< index among the files of the parse
    std::uint32_t name = kNoIndex;  ///< interned word (keywords too), or string index
    double number = 0;
    std::uint32_t offset = 0;       ///< byte in the file; line and column are computed when a message needs them
    std::uint32_t jump = kNoIndex;  ///< Hash and Numbers; of an Identifier that is a new word: SourceFile::new_words
};
static_assert(sizeof(Token) == 24);

/// Words seen in one parse, each with a small number. Reserved words come first, in the order of Kind.
class Names {
public:
    Names();
    std::uint32_t intern(std::string_view word);
    const std::string& word(std::uint32_t name) const { return words_[name]; }
    /// kNoIndex: it has not been seen.
    std::uint32_t find(std::string_view word) const
    {
        const auto found = index_.find(word);
        return found == index_.end() ? kNoIndex : found->second;
    }
    /// As it is lexed: of a word that only POV-Ray 3.8 reserves Identifier, for a scene may have it as a name.
    Kind kind(std::uint32_t name) const
    {
        return name < kinds_.size() && !new_[name] ? kinds_[name] : Kind::Identifier;
    }
    /// What such a word is where nothing of that name is declared; of other names EndOfText.
    Kind new_word(std::uint32_t name) const
    {
        return name < kinds_.size() && new_[name] ? kinds_[name] : Kind::EndOfText;
    }
    /// Reserved in one of the versions at least.
    bool reserved(std::uint32_t name) const { return name < kinds_.size(); }
    std::size_t size() const { return words_.size(); }

private:
    std::deque<std::string> words_;  // stable addresses: the map's keys look into them
    std::vector<Kind> kinds_;        // of the reserved words
    std::vector<bool> new_;          // by the same numbers
    std::unordered_map<std::string_view, std::uint32_t> index_;
};

/// Reserved word or Identifier.
Kind keyword_of(std::string_view word);

}  // namespace parser
