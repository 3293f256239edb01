#include "language/places/structure.h"

#include <algorithm>
#include <set>

namespace language {

using parser::Kind;

namespace {

constexpr std::size_t kMostEntries = 5000, kMostFolds = 20'000;

/// What a value is, by its first word: "sphere", "texture", "" for an expression.
std::string_view value_word(const Document& document, const Declaration& one)
{
    if (one.value == kNone || one.by == DeclaredBy::Macro) return {};
    if (!parser::is_keyword(document.kind(one.value))) return {};
    const Kind next = document.kind(one.value + 1);
    const bool block = next == Kind::LeftBrace || document.kind(one.value) == Kind::Function ||
                       document.kind(one.value) == Kind::Array;
    return block ? document.word(one.value) : std::string_view();
}

Entry entry_of(const Document& document, const Declaration& one)
{
    Entry entry;
    entry.name = document.word(one.name);
    entry.word = document.range(one.name);
    entry.whole = {document.range(one.begin).begin, document.range(std::max(one.end, one.name + 1) - 1).end};
    entry.detail = value_word(document, one);
    if (one.by == DeclaredBy::Macro) entry.kind = Entry::Kind::Function, entry.detail = "macro";
    else if (entry.detail == "function") entry.kind = Entry::Kind::Function;
    else if (!entry.detail.empty()) entry.kind = Entry::Kind::Object;
    else if (one.everywhere()) entry.kind = Entry::Kind::Constant;
    return entry;
}

/// Words with a block that stand outside of everything else.
void add_objects(const Document& document, const Outline& outline, std::vector<Entry>& entries)
{
    std::vector<std::pair<std::size_t, std::size_t>> taken;
    for (const Declaration& one : outline.declarations)
        if (one.by != DeclaredBy::Parameter && one.by != DeclaredBy::Loop) taken.emplace_back(one.begin, one.end);
    std::size_t next = 0;
    for (std::size_t at = 0; at + 1 < document.tokens().size() && entries.size() < kMostEntries; ++at) {
        while (next < taken.size() && taken[next].second <= at) ++next;
        if (next < taken.size() && taken[next].first <= at) {
            at = taken[next].second - 1;
            continue;
        }
        if (document.kind(at) == Kind::LeftBrace && document.partner(at) != kNone) {
            if (at > 0 && parser::is_keyword(document.kind(at - 1)) && document.kind(at - 2) != Kind::Hash) {
                Entry entry;
                entry.name = document.word(at - 1);
                entry.kind = Entry::Kind::Object;
                entry.word = document.range(at - 1);
                entry.whole = {entry.word.begin, document.range(document.partner(at)).end};
                if (document.kind(at + 1) == Kind::Identifier) entry.detail = document.word(at + 1);
                entries.push_back(std::move(entry));
            }
            at = document.partner(at);
        }
    }
}

bool takes_branches(Kind word)
{
    switch (word) {
    case Kind::If:
    case Kind::Ifdef:
    case Kind::Ifndef:
    case Kind::Else:
    case Kind::Elseif:
    case Kind::Switch:
    case Kind::Case:
    case Kind::Range:
    case Kind::While:
    case Kind::For:
    case Kind::Macro: return true;
    default: return false;
    }
}

}  // namespace

std::vector<Entry> entries_of(const Document& document, const Outline& outline)
{
    std::vector<Entry> entries;
    std::set<std::pair<std::size_t, std::string_view>> seen;  // a name that is given again is listed once
    std::vector<Entry*> macros(outline.scopes.size(), nullptr);
    entries.reserve(std::min(outline.declarations.size(), kMostEntries) + 1);  // pointers into it stay
    for (const Declaration& one : outline.declarations) {
        if (one.by == DeclaredBy::Parameter || one.by == DeclaredBy::Loop) continue;
        if (!seen.emplace(one.scope, document.word(one.name)).second) continue;
        if (one.scope != kNone) {
            if (macros[one.scope] != nullptr) macros[one.scope]->inner.push_back(entry_of(document, one));
            continue;
        }
        if (entries.size() >= kMostEntries) break;
        entries.push_back(entry_of(document, one));
        if (one.by != DeclaredBy::Macro) continue;
        for (std::size_t scope = 0; scope < outline.scopes.size(); ++scope)
            if (outline.scopes[scope].macro && outline.scopes[scope].begin == one.begin)
                macros[scope] = &entries.back();
    }
    add_objects(document, outline, entries);
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return a.whole.begin < b.whole.begin; });
    return entries;
}

std::vector<Fold> folds_of(const Document& document)
{
    std::vector<Fold> folds;
    const auto line = [&](std::uint32_t offset) { return document.lines().place(offset).line; };
    const auto add = [&](std::uint32_t first, std::uint32_t last, bool comment) {
        if (first < last && folds.size() < kMostFolds) folds.push_back({first, last, comment});
    };
    for (std::size_t at = 0; at < document.tokens().size(); ++at) {
        const parser::Token& token = document.tokens()[at];
        // The closing line stays in sight.
        if (token.kind == Kind::LeftBrace && document.partner(at) != kNone)
            add(line(token.offset), line(document.range(document.partner(at)).begin) - 1, false);
        else if (token.kind == Kind::Hash && token.jump != parser::kNoIndex && takes_branches(document.kind(at + 1)))
            add(line(token.offset), line(document.range(token.jump).begin) - 1, false);
    }
    std::uint32_t first = 0, last = 0;  // of line comments below each other
    for (const Range& comment : comments_of(document)) {
        const std::uint32_t begin = line(comment.begin), end = line(comment.end);
        if (document.text()[comment.begin + 1] == '*') {
            add(begin, end, true);
            continue;
        }
        if (first != 0 && begin == last + 1) {
            last = begin;
            continue;
        }
        add(first, last, true);
        first = last = begin;
    }
    if (first != 0) add(first, last, true);
    return folds;
}

}  // namespace language
