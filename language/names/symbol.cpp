#include "language/names/symbol.h"

#include <algorithm>

namespace language {
namespace {

using parser::Kind;

/// The innermost scope that declares the word and holds the token; kNone: none does.
std::size_t scope_of(const Known& known, std::string_view word, std::size_t token)
{
    std::size_t found = kNone;
    for (const Declaration& one : known.outline.declarations) {
        if (one.scope == kNone || known.document.word(one.name) != word) continue;
        const Scope& scope = known.outline.scopes[one.scope];
        if (token < scope.begin || token >= scope.end) continue;
        if (found == kNone || known.outline.scopes[found].begin < scope.begin) found = one.scope;
    }
    return found;
}

/// Whether the word is a text's own: declared by #local outside of macros, or by #for alone.
bool of_text(const Known& known, std::string_view word)
{
    bool local = false, loop = false, global = false;
    for (const Declaration& one : known.outline.declarations) {
        if (one.scope != kNone || known.document.word(one.name) != word) continue;
        local = local || one.by == DeclaredBy::Local;
        loop = loop || one.by == DeclaredBy::Loop;
        global = global || one.everywhere();
    }
    return local || (loop && !global);
}

bool declares(const Declaration& one, const Known& known, const Symbol& symbol)
{
    return one.scope == symbol.scope && known.document.word(one.name) == symbol.word;
}

/// The texts in which a name may stand for the symbol.
std::vector<KnownPtr> texts_of(Files& files, const Symbol& symbol)
{
    std::vector<std::string> paths{symbol.path};
    if (symbol.reach == Symbol::Reach::Text) paths = files.reached(symbol.path);
    if (symbol.reach == Symbol::Reach::All) paths = files.related(symbol.path);
    std::vector<KnownPtr> texts;
    for (const std::string& path : paths) {
        KnownPtr known = files.find(path);
        if (!known) continue;
        // A text that keeps the name to itself means another thing by it, unless it includes the one that asks.
        if (path != symbol.path && of_text(*known, symbol.word)) {
            const std::vector<std::string> reached = files.reached(path);
            if (std::find(reached.begin(), reached.end(), symbol.path) == reached.end()) continue;
        }
        texts.push_back(std::move(known));
    }
    return texts;
}

}  // namespace

Symbol symbol_of(const Known& known, std::size_t token)
{
    Symbol symbol{std::string(known.document.word(token)), Symbol::Reach::All, known.document.path(), kNone};
    symbol.scope = scope_of(known, symbol.word, token);
    if (symbol.scope != kNone) symbol.reach = Symbol::Reach::Scope;
    else if (of_text(known, symbol.word)) symbol.reach = Symbol::Reach::Text;
    return symbol;
}

std::optional<Symbol> symbol_at(const Known& known, std::uint32_t offset)
{
    const std::size_t token = known.document.word_at(offset);
    if (token == kNone || known.document.kind(token) != Kind::Identifier || known.document.is_member(token)) return {};
    return symbol_of(known, token);
}

std::optional<Found> declaration_of(Files& files, const Symbol& symbol, std::uint32_t offset)
{
    const std::vector<KnownPtr> texts = texts_of(files, symbol);
    std::optional<Found> before, behind;
    for (const KnownPtr& known : texts) {
        const bool here = known->document.path() == symbol.path;
        for (const Declaration& one : known->outline.declarations) {
            if (!declares(one, *known, symbol)) continue;
            if (here && known->document.range(one.name).begin > offset) {
                if (!behind) behind = Found{known, one};
            } else {
                before = Found{known, one};
            }
        }
        if (here && before) return before;
    }
    return before ? before : behind;
}

std::vector<At> places_of(Files& files, const Symbol& symbol)
{
    std::vector<At> places;
    for (const KnownPtr& known : texts_of(files, symbol)) {
        const Document& document = known->document;
        const bool scoped = symbol.scope != kNone;
        const std::size_t begin = scoped ? known->outline.scopes[symbol.scope].begin : 0;
        const std::size_t end = scoped ? known->outline.scopes[symbol.scope].end : document.tokens().size();
        for (std::size_t at = begin; at < end; ++at) {
            if (document.kind(at) != Kind::Identifier || document.word(at) != symbol.word || document.is_member(at))
                continue;
            if (scope_of(*known, symbol.word, at) == symbol.scope)
                places.push_back({document.path(), document.range(at)});
        }
    }
    return places;
}

std::vector<At> declarations_of(Files& files, const Symbol& symbol)
{
    std::vector<At> places;
    for (const KnownPtr& known : texts_of(files, symbol))
        for (const Declaration& one : known->outline.declarations)
            if (declares(one, *known, symbol))
                places.push_back({known->document.path(), known->document.range(one.name)});
    return places;
}

std::map<std::string, Found> names_at(Files& files, const std::string& path, std::uint32_t offset)
{
    std::map<std::string, Found> names;
    const auto add = [&](const KnownPtr& known, const Declaration& one) {
        names.insert_or_assign(std::string(known->document.word(one.name)), Found{known, one});
    };
    const KnownPtr here = files.find(path);
    if (!here) return names;
    for (const std::string& other : files.related(path)) {
        const KnownPtr known = other == path ? nullptr : files.find(other);
        if (!known) continue;
        for (const Declaration& one : known->outline.declarations)
            if (one.everywhere()) add(known, one);
    }
    const std::size_t token = here->document.before(offset);
    for (const bool scoped : {false, true})
        for (const Declaration& one : here->outline.declarations) {
            if ((one.scope != kNone) != scoped) continue;
            // What is written behind the place is not known there, but for macros and functions that are called later.
            if (one.by != DeclaredBy::Macro && one.scope == kNone && here->document.range(one.name).begin > offset)
                continue;
            if (scoped) {
                const Scope& scope = here->outline.scopes[one.scope];
                if (token == kNone || token < scope.begin || token >= scope.end) continue;
            }
            // A word that is being written is no name of its own.
            if (here->document.range(one.name).end == offset) continue;
            add(here, one);
        }
    return names;
}

}  // namespace language
