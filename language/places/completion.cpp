#include "language/places/completion.h"

#include "language/places/place_words.h"
#include "parser/lexer/color_word.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace language {

namespace fs = std::filesystem;
using parser::Kind;

namespace {

constexpr std::size_t kMostItems = 2000;
constexpr std::size_t kMostFiles = 5000;  // of a folder that are looked at

bool word_char(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// The word in front of a byte and what follows of it.
Range word_around(const std::string& text, std::uint32_t offset)
{
    std::uint32_t begin = offset, end = offset;
    while (begin > 0 && word_char(text[begin - 1])) --begin;
    while (end < text.size() && word_char(text[end])) ++end;
    return {begin, end};
}

ItemKind kind_of(Kind keyword)
{
    switch (parser::lexical_class(keyword)) {
    case parser::LexicalClass::Float:
    case parser::LexicalClass::String: return ItemKind::Function;
    case parser::LexicalClass::Vector:
    case parser::LexicalClass::Vector2:
    case parser::LexicalClass::Vector4: return ItemKind::Constant;
    default: return ItemKind::Keyword;
    }
}

std::string_view words_of(DeclaredBy by)
{
    switch (by) {
    case DeclaredBy::Local: return "local";
    case DeclaredBy::Macro: return "macro";
    case DeclaredBy::Parameter: return "parameter";
    case DeclaredBy::Loop: return "loop variable";
    default: return "declared";
    }
}

/// The keyword whose block a '{' opens: the word before it, lists in parentheses or brackets passed over.
Kind block_of(const Document& document, std::size_t brace)
{
    for (std::size_t at = brace; at-- > 0;) {
        if (document.kind(at) == Kind::RightParen || document.kind(at) == Kind::RightSquare) {
            if (document.partner(at) == kNone) return Kind::EndOfText;
            at = document.partner(at);
            continue;
        }
        return document.kind(at);
    }
    return Kind::EndOfText;
}

/// Whether a number, a vector or a text has to begin behind the token: an operator, a comma, an opening bracket.
bool asks_for_number(Kind kind)
{
    switch (kind) {
    case Kind::LeftParen:
    case Kind::LeftSquare:
    case Kind::Less:
    case Kind::LessEqual:
    case Kind::GreaterEqual:
    case Kind::NotEqual:
    case Kind::Comma:
    case Kind::Plus:
    case Kind::Minus:
    case Kind::Star:
    case Kind::Slash:
    case Kind::Question:
    case Kind::Ampersand:
    case Kind::Bar:
    case Kind::Exclamation:
    case Kind::Rotate:
    case Kind::Translate:
    case Kind::Scale: return true;
    default: return parser::color_word(kind).components > 0;
    }
}

void add_words(Completion& out, const std::vector<std::string>& words, int rank, bool directives = false)
{
    for (const std::string& word : words) {
        const Kind kind = parser::keyword_of(word);
        out.items.push_back(
            {word, directives ? ItemKind::Directive : kind_of(kind), std::string(keyword_line(kind)), rank});
    }
}

/// What `#include "part` may go on with: folders and files in all places that are searched.
void add_files(Completion& out, Files& files, const std::string& path, std::string_view written)
{
    const std::size_t slash = written.rfind('/');
    const std::string folder(written.substr(0, slash == std::string_view::npos ? 0 : slash + 1));
    if (folder.find('\0') != std::string::npos) return;
    std::set<std::string> seen;
    const auto add = [&](const fs::path& place) {
        std::error_code error;
        std::size_t looked_at = 0;
        for (fs::directory_iterator entry(place.empty() ? "." : place, error), end;
             !error && entry != end && ++looked_at < kMostFiles; entry.increment(error)) {
            const std::string name = entry->path().filename().string();
            std::error_code gone;
            const bool is_folder = entry->is_directory(gone);
            const std::string extension = entry->path().extension().string();
            if (name.starts_with('.') || (!is_folder && extension != ".inc" && extension != ".INC")) continue;
            if (seen.insert(name).second)
                out.items.push_back({name, is_folder ? ItemKind::Folder : ItemKind::File, place.string(), is_folder});
        }
    };
    std::vector<std::string> roots{path};
    for (const std::string& root : files.open_paths()) {
        const std::vector<std::string> reached = files.reached(root);
        if (root != path && std::find(reached.begin(), reached.end(), path) != reached.end()) roots.push_back(root);
    }
    for (const std::string& root : roots)
        for (const std::string& place : files.folders(path, root)) add(fs::path(place) / folder);
}

void add_names(Completion& out, Files& files, const std::string& path, std::uint32_t offset, std::string_view prefix)
{
    for (const auto& [word, found] : names_at(files, path, offset)) {
        if (out.items.size() >= kMostItems) {
            out.complete = false;
            if (!word.starts_with(prefix)) continue;
        }
        if (out.items.size() >= 2 * kMostItems) return;
        const DeclaredBy by = found.declaration.by;
        const bool near = found.declaration.scope != kNone;
        Item item{word, ItemKind::Variable, std::string(words_of(by)), near ? 0 : 2};
        if (by == DeclaredBy::Macro) item.kind = ItemKind::Macro;
        if (by == DeclaredBy::Parameter) item.kind = ItemKind::Parameter;
        if (found.known->document.path() != path)
            item.detail += " in " + fs::path(found.known->document.path()).filename().string();
        out.items.push_back(std::move(item));
    }
}

/// The text whose inside holds a byte, one without an end included; kNone: there is none.
std::size_t text_around(const Document& document, std::uint32_t offset)
{
    const std::size_t last = document.before(offset);
    if (last == kNone) return kNone;
    if (document.kind(last) == Kind::String) return offset < document.range(last).end ? last : kNone;
    // A text that is not closed: as the author sees it, it ends with the line. What stands in it are tokens by
    // themselves.
    const std::size_t line = document.text().find_last_of("\r\n", offset == 0 ? 0 : offset - 1);
    for (std::size_t at = last + 1; at-- > 0;) {
        const std::uint32_t begin = document.tokens()[at].offset;
        if (line != std::string::npos && begin <= line) break;
        if (document.kind(at) == Kind::Bad && document.text()[begin] == '"') return at;
    }
    return kNone;
}

}  // namespace

Completion completion_at(Files& files, const std::string& path, std::uint32_t offset)
{
    Completion out;
    const KnownPtr known = files.find(path);
    if (!known) return out;
    const Document& document = known->document;
    offset = std::min(offset, static_cast<std::uint32_t>(document.text().size()));
    for (const Range& comment : comments_of(document)) {
        const bool line = document.text()[comment.begin + 1] == '/';
        const bool open = comment.end == document.text().size() && !line;
        if (offset > comment.begin + 1 && (offset < comment.end || (line && offset == comment.end) || open)) return out;
    }
    if (const std::size_t text = text_around(document, offset); text != kNone) {
        if (text < 2 || document.kind(text - 1) != Kind::Include || document.kind(text - 2) != Kind::Hash) return out;
        const std::uint32_t begin = document.range(text).begin + 1;
        const std::string_view written = std::string_view(document.text()).substr(begin, offset - begin);
        const std::size_t slash = written.rfind('/');
        out.replaced = {slash == std::string_view::npos ? begin : begin + static_cast<std::uint32_t>(slash) + 1,
                        offset};
        add_files(out, files, path, written);
        return out;
    }
    out.replaced = word_around(document.text(), offset);
    const std::string prefix = document.text().substr(out.replaced.begin, offset - out.replaced.begin);
    if (!prefix.empty() && prefix[0] >= '0' && prefix[0] <= '9') return out;
    const std::size_t last = document.before(out.replaced.begin);
    const Kind behind = last == kNone ? Kind::EndOfText : document.kind(last);
    if (behind == Kind::Hash) {
        add_words(out, directive_words(), 0, true);
        return out;
    }
    const Kind before = last == kNone || last == 0 ? Kind::EndOfText : document.kind(last - 1);
    const bool names_new = before == Kind::Hash &&
                           (behind == Kind::Declare || behind == Kind::Local || behind == Kind::Macro ||
                            behind == Kind::Undef || behind == Kind::Ifdef || behind == Kind::Ifndef);
    if (!names_new) {
        const std::size_t brace = document.open_brace(out.replaced.begin);
        const Kind block = brace == kNone ? Kind::EndOfText : block_of(document, brace);
        const std::size_t outer_brace = brace == kNone ? kNone : document.open_brace(document.range(brace).begin);
        const Kind outer = outer_brace == kNone ? Kind::EndOfText : block_of(document, outer_brace);
        if (behind == Kind::Equal) add_words(out, value_words(), 3);
        else if (asks_for_number(behind)) add_words(out, number_words(), 3);
        else if (brace == kNone) add_words(out, scene_words(), 1);
        else {
            add_words(out, words_behind(behind, block, outer), 0);
            add_words(out, block_words(block, outer), 1);
        }
    }
    add_names(out, files, path, offset, prefix);
    return out;
}

}  // namespace language
