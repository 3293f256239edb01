#include "parser/lexer/lexer.h"
#include "parser/lexer/number_blocks.h"

#include <tao/pegtl.hpp>

#include <charconv>
#include <cstdio>
#include <cstdlib>

namespace parser {
namespace {

namespace pegtl = tao::pegtl;
using pegtl::one;
using pegtl::opt;
using pegtl::plus;
using pegtl::seq;
using pegtl::sor;
using pegtl::star;

// --- what a text is made of (spec 1, 1) -----------------------------------------------------------

// Byte 0x1A (Ctrl-Z) and 0x00 are blanks: old editors left them.
struct blanks : plus<one<' ', '\t', '\n', '\v', '\f', '\r', '\0', '\x1a'>> {};
struct line_comment : seq<pegtl::two<'/'>, star<pegtl::not_one<'\n', '\r'>>> {};
// Nests, so it is counted by hand: recursion would let a text of "/*/*/*" exhaust the stack.
struct block_comment {
    using rule_t = block_comment;
    using subs_t = pegtl::type_list<>;
    template <class Input>
    static bool match(Input& in)
    {
        const char* at = in.current();
        const char* const end = in.end();
        if (end - at < 2 || at[0] != '/' || at[1] != '*') return false;
        int depth = 0;
        while (at < end) {
            if (end - at >= 2 && at[0] == '/' && at[1] == '*') {
                ++depth;
                at += 2;
            } else if (end - at >= 2 && at[0] == '*' && at[1] == '/') {
                at += 2;
                if (--depth == 0) {
                    in.bump(static_cast<std::size_t>(at - in.current()));
                    return true;
                }
            } else {
                ++at;
            }
        }
        return false;
    }
};
struct open_comment : pegtl::string<'/', '*'> {};

struct word : seq<pegtl::identifier_first, star<pegtl::identifier_other>> {};

using digits = plus<pegtl::digit>;
struct mantissa : sor<seq<digits, opt<one<'.'>, star<pegtl::digit>>>, seq<one<'.'>, digits>> {};
// A dangling exponent, `1e` or `2e+`, is accepted and means nothing.
struct exponent : seq<one<'e', 'E'>, opt<one<'+', '-'>>, star<pegtl::digit>> {};
struct number : seq<mantissa, opt<exponent>> {};
struct number_with_two_points : seq<digits, one<'.'>, star<pegtl::digit>, one<'.'>> {};

// A backslash keeps the next character from ending the text; a line break may not follow it.
struct text_char : sor<seq<one<'\\'>, pegtl::not_one<'\n', '\r'>>, pegtl::not_one<'"', '\\'>> {};
struct text : seq<one<'"'>, star<text_char>, one<'"'>> {};
struct open_text : one<'"'> {};

struct pair : sor<pegtl::string<'<', '='>, pegtl::string<'>', '='>, pegtl::string<'!', '='>> {};
struct mark : one<'{', '}', '(', ')', '[', ']', '<', '>', '=', '!', '&', '|', '?', ':', ',', ';', '.', '+', '-', '*',
                  '/', '@', '%', '^', '$', '~', '\'', '`', '\\', '#'> {};
struct illegal : pegtl::any {};

/// A list that the last two tokens, a word and '{', may have begun.
struct number_list {
    using rule_t = number_list;
    using subs_t = pegtl::type_list<>;
    template <pegtl::apply_mode, pegtl::rewind_mode, template <class...> class, template <class...> class, class Input,
              class Build>
    static bool match(Input& in, Build& build)
    {
        const char* const end = build.take_numbers(in.current(), in.end());
        if (end == nullptr) return false;
        in.bump(static_cast<std::size_t>(end - in.current()));
        return true;
    }
};

struct item : sor<number_list, blanks, word, number_with_two_points, number, line_comment, block_comment, open_comment,
                  text, open_text, pair, mark, illegal> {};
struct whole : star<item> {};

// --- what becomes of it ------------------------------------------------------------------------------------------

constexpr std::size_t kBytesOfNumber = 8;  ///< of text, about

struct Builder {
    SourceFile& file;
    const char* text;  ///< begin
    Names& names;
    std::uint16_t file_index;
    bool lists = true;
    Kind list =
        Kind::Bad;      ///< the word that begins a list of numbers, if the last token was that or the brace behind it
    bool open = false;  ///< it was the brace

    Token& add(Kind kind, const char* at)
    {
        Token token;
        token.kind = kind;
        token.file = file_index;
        token.offset = static_cast<std::uint32_t>(at - text);
        open = list != Kind::Bad && kind == Kind::LeftBrace && !open;
        if (!open) list = lists && begins_numbers(kind) ? kind : Kind::Bad;
        return file.tokens.emplace_back(token);
    }
    /// Where the list ends that begins here; null: none does.
    const char* take_numbers(const char* at, const char* text_end)
    {
        if (!open) return nullptr;
        const Kind keyword = list;
        open = false;
        list = Kind::Bad;
        const std::size_t before = file.numbers.size();
        // A long file has many: pages that are never written to take no memory, copies of what is there do.
        if (before == 0) file.numbers.reserve(static_cast<std::size_t>(text_end - at) / kBytesOfNumber);
        NumberList found;
        const char* first = nullptr;
        const char* const list_end = read_number_list(keyword, at, text_end, file.numbers, found, first);
        if (list_end == nullptr) return nullptr;
        Token& token = add(found.stride == 0 ? Kind::Faces : Kind::Numbers, first);
        token.name = static_cast<std::uint32_t>(before);
        token.jump = found.items;
        token.number = found.stride;
        return list_end;
    }
    std::uint32_t add_string(std::string raw)
    {
        file.strings.push_back(std::move(raw));
        return static_cast<std::uint32_t>(file.strings.size() - 1);
    }
    void add_bad(const char* at, std::string message)
    {
        file.bad.push_back(static_cast<std::uint32_t>(file.tokens.size()));
        const std::uint32_t index = add_string(std::move(message));
        add(Kind::Bad, at).name = index;
    }
};

double number_value(const char* begin, const char* end)
{
    double value = 0;
    const auto result = std::from_chars(begin, end, value);
    if (result.ec == std::errc::result_out_of_range)  // from_chars leaves the value alone: inf or 0 wanted
        value = std::strtod(std::string(begin, end).c_str(), nullptr);
    return value;
}

Kind mark_kind(char c)
{
    static constexpr std::string_view kMarks = "{}()[]<>=!&|?:,;.+-*/@%^$~'`\\#";
    static constexpr Kind kKinds[] = {
        Kind::LeftBrace, Kind::RightBrace, Kind::LeftParen,  Kind::RightParen,  Kind::LeftSquare, Kind::RightSquare,
        Kind::Less,      Kind::Greater,    Kind::Equal,      Kind::Exclamation, Kind::Ampersand,  Kind::Bar,
        Kind::Question,  Kind::Colon,      Kind::Comma,      Kind::Semicolon,   Kind::Period,     Kind::Plus,
        Kind::Minus,     Kind::Star,       Kind::Slash,      Kind::At,          Kind::Percent,    Kind::Caret,
        Kind::Dollar,    Kind::Tilde,      Kind::Apostrophe, Kind::Backquote,   Kind::Backslash,  Kind::Hash};
    return kKinds[kMarks.find(c)];
}

template <class Rule>
struct action {};

template <>
struct action<word> {
    template <class Input>
    static void apply(const Input& in, Builder& build)
    {
        const std::uint32_t name = build.names.intern(in.string_view());
        Token& token = build.add(build.names.kind(name), in.begin());
        token.name = name;
        const Kind meant = build.names.new_word(name);
        if (meant == Kind::EndOfText) return;
        build.file.new_words.emplace_back(token).kind = meant;
        token.jump = static_cast<std::uint32_t>(build.file.new_words.size() - 1);
    }
};
template <>
struct action<number> {
    template <class Input>
    static void apply(const Input& in, Builder& build)
    {
        build.add(Kind::Number, in.begin()).number = number_value(in.begin(), in.end());
    }
};
template <>
struct action<number_with_two_points> {
    template <class Input>
    static void apply(const Input& in, Builder& build)
    {
        build.add_bad(in.begin(), "this number has a second decimal point");
    }
};
template <>
struct action<open_comment> {
    template <class Input>
    static void apply(const Input& in, Builder& build)
    {
        build.add_bad(in.begin(), "this comment is never closed by */");
    }
};
template <>
struct action<text> {
    template <class Input>
    static void apply(const Input& in, Builder& build)
    {
        std::string raw;
        const std::string_view body = in.string_view().substr(1, in.size() - 2);
        for (std::size_t i = 0; i < body.size(); ++i) {
            if (body[i] == '\\' && i + 1 < body.size()) {
                if (body[i + 1] != '"') raw += '\\';  // other escapes are resolved when the text is used
                ++i;
            }
            raw += body[i];
        }
        const std::uint32_t index = build.add_string(std::move(raw));
        build.add(Kind::String, in.begin()).name = index;
    }
};
template <>
struct action<open_text> {
    template <class Input>
    static void apply(const Input& in, Builder& build)
    {
        build.add_bad(in.begin(), "this text is never closed by \"");
    }
};
template <>
struct action<pair> {
    template <class Input>
    static void apply(const Input& in, Builder& build)
    {
        const char c = *in.begin();
        build.add(c == '<' ? Kind::LessEqual : c == '>' ? Kind::GreaterEqual : Kind::NotEqual, in.begin());
    }
};
template <>
struct action<mark> {
    template <class Input>
    static void apply(const Input& in, Builder& build)
    {
        build.add(mark_kind(*in.begin()), in.begin());
    }
};
template <>
struct action<illegal> {
    template <class Input>
    static void apply(const Input& in, Builder& build)
    {
        char message[64];
        std::snprintf(message, sizeof message, "a byte with the value %02X cannot stand here",
                      static_cast<unsigned>(static_cast<unsigned char>(*in.begin())));
        build.add_bad(in.begin(), message);
    }
};

/// Gives every branching directive the place of the next branch at its level.
void link_branches(std::vector<Token>& tokens)
{
    struct Open {
        std::uint32_t last;
        bool conditional, choice;
    };
    std::vector<Open> open;
    for (std::uint32_t at = 0; at + 1 < tokens.size(); ++at) {
        if (tokens[at].kind != Kind::Hash) continue;
        switch (tokens[at + 1].kind) {
        case Kind::If:
        case Kind::Ifdef:
        case Kind::Ifndef: open.push_back({at, true, false}); break;
        case Kind::Switch: open.push_back({at, true, true}); break;
        case Kind::While:
        case Kind::For:
        case Kind::Macro: open.push_back({at, false, false}); break;
        case Kind::Else:
        case Kind::Elseif:
        case Kind::Case:
        case Kind::Range: {
            const bool choice = tokens[at + 1].kind == Kind::Case || tokens[at + 1].kind == Kind::Range;
            if (open.empty() || !open.back().conditional || (choice && !open.back().choice)) break;
            tokens[open.back().last].jump = at;
            open.back().last = at;
            break;
        }
        case Kind::End:
            if (open.empty()) break;
            tokens[open.back().last].jump = at;
            open.pop_back();
            break;
        default: break;
        }
    }
}

}  // namespace

bool tokenize(SourceFile& file, std::uint16_t file_index, Names& names, bool main_text, bool lists)
{
    return tokenize(file.text, file, file_index, names, main_text, lists);
}

bool tokenize(std::string_view text, SourceFile& file, std::uint16_t file_index, Names& names, bool main_text,
              bool lists)
{
    file.tokens.clear();
    file.strings.clear();
    file.numbers.clear();
    file.new_words.clear();
    file.bad.clear();
    std::size_t skipped = 0;
    if (main_text)
        while (skipped < text.size() && static_cast<unsigned char>(text[skipped]) > 127) ++skipped;
    else if (text.starts_with("\xEF\xBB\xBF"))  // POV-Ray refuses it in an include file; editors write it
        skipped = 3;

    Builder build{file, text.data(), names, file_index, lists};
    file.tokens.reserve(text.size() / 4 + 1);
    pegtl::memory_input<pegtl::tracking_mode::lazy> in(text.data() + skipped, text.data() + text.size(), file.path);
    pegtl::parse<whole, action>(in, build);
    build.add(Kind::EndOfText, text.data() + text.size());
    link_branches(file.tokens);
    return skipped != 0;
}

}  // namespace parser
