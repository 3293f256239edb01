#pragma once

#include "language/names/document.h"

#include <vector>

namespace language {

enum class DeclaredBy : std::uint8_t {
    Declare,    ///< and #fopen, #read: a name for all texts
    Local,      ///< of a macro or, outside of one, of its text and those that it includes
    Macro,      ///< a name for all texts
    Parameter,  ///< of a macro or function
    Loop        ///< the variable of a #for
};

/// Part of a text that has names of its own.
struct Scope {
    std::size_t begin = 0, end = 0;  ///< tokens
    bool macro = true;               ///< else a function
};

struct Declaration {
    DeclaredBy by = DeclaredBy::Declare;
    std::size_t name = 0;            ///< token
    std::size_t begin = 0, end = 0;  ///< tokens of the whole statement
    std::size_t value = kNone;       ///< token behind '=', '(' of a macro
    std::size_t scope = kNone;       ///< whose name it is; kNone: of the text or of all
    bool everywhere() const { return by == DeclaredBy::Declare || by == DeclaredBy::Macro; }
};

/// What a text declares, in order.
struct Outline {
    std::vector<Scope> scopes;
    std::vector<Declaration> declarations;
    std::vector<std::size_t> includes;  ///< String tokens behind #include
};

/// Reads a document's declarations from its tokens; text that is wrong or half written gives what can be told.
Outline outline_of(const Document& document);

}  // namespace language
