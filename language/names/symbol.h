#pragma once

#include "language/names/files.h"

#include <optional>

namespace language {

/// A place in one of several texts.
struct At {
    std::string path;
    Range range;
    friend bool operator==(const At&, const At&) = default;
};

/// What a name means at a place: of a macro or function, of a text and what that includes, or of all texts.
struct Symbol {
    enum class Reach { Scope, Text, All };
    std::string word;
    Reach reach = Reach::All;
    std::string path;           ///< of the text where it was asked for
    std::size_t scope = kNone;  ///< of that text's outline
};

/// The name that holds a byte or ends there; nothing where a keyword, a member or none stands.
std::optional<Symbol> symbol_at(const Known& known, std::uint32_t offset);
/// The same of an identifier token.
Symbol symbol_of(const Known& known, std::size_t token);

/// Where a declaration stands.
struct Found {
    KnownPtr known;
    Declaration declaration;
    At at() const { return {known->document.path(), known->document.range(declaration.name)}; }
};

/// The declaration that is in force at a byte of the symbol's text: the nearest before it, else the last of the texts
/// that are included, else the first behind it.
std::optional<Found> declaration_of(Files& files, const Symbol& symbol, std::uint32_t offset);

/// All places of a name, declarations included, texts in the order of Files::related().
std::vector<At> places_of(Files& files, const Symbol& symbol);
/// The declarations among them.
std::vector<At> declarations_of(Files& files, const Symbol& symbol);

/// Names that may be used at a byte of a text, each once, with the declaration in force.
std::map<std::string, Found> names_at(Files& files, const std::string& path, std::uint32_t offset);

}  // namespace language
