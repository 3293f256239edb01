#include "language/names/outline.h"

#include <algorithm>

namespace language {
namespace {

using parser::Kind;

bool goes_on(Kind kind)
{
    switch (kind) {
    case Kind::Texture:
    case Kind::InteriorTexture:
    case Kind::Plus:
    case Kind::Minus:
    case Kind::Star:
    case Kind::Slash:
    case Kind::Question:
    case Kind::Colon:
    case Kind::Period: return true;
    default: return false;
    }
}

/// Walks over the tokens once and keeps what is open.
class Walk {
public:
    explicit Walk(const Document& document) : document_(document) {}

    Outline take()
    {
        const std::size_t count = document_.tokens().size();
        for (std::size_t at = 0; at < count; ++at) {
            while (!macros_.empty() && out_.scopes[macros_.back()].end <= at) macros_.pop_back();
            if (document_.kind(at) == Kind::Hash) directive(at);
            else if (document_.kind(at) == Kind::Function) function(at);
        }
        return std::move(out_);
    }

private:
    void directive(std::size_t hash)
    {
        const std::size_t name = hash + 2;
        switch (document_.kind(hash + 1)) {
        case Kind::Declare: return names(DeclaredBy::Declare, hash);
        case Kind::Local: return names(DeclaredBy::Local, hash);
        case Kind::Macro: return macro(hash);
        case Kind::For:
            if (document_.kind(name) == Kind::LeftParen && document_.kind(name + 1) == Kind::Identifier)
                add({DeclaredBy::Loop, name + 1, hash, end_of_list(name), kNone, inner_macro()});
            return;
        case Kind::Fopen:
            if (document_.kind(name) == Kind::Identifier)
                add({DeclaredBy::Declare, name, hash, name + 1, kNone, kNone});
            return;
        case Kind::Read: return read(hash);
        case Kind::Include:
            if (document_.kind(name) == Kind::String) out_.includes.push_back(name);
            return;
        default: return;
        }
    }

    /// `#declare A = value;` or, in version 3.8, `#declare (A, B) = ...`. An element of an array is no new name.
    void names(DeclaredBy by, std::size_t hash)
    {
        const std::size_t first = hash + 2;
        const std::size_t scope = by == DeclaredBy::Local ? inner_macro() : kNone;
        if (document_.kind(first) == Kind::Identifier && document_.kind(first + 1) == Kind::Equal) {
            add({by, first, hash, end_of_value(first + 2), first + 2, scope});
        } else if (document_.kind(first) == Kind::LeftParen) {
            const std::size_t close = document_.partner(first);
            for (std::size_t at = first + 1; close != kNone && at < close; ++at)
                if (document_.kind(at) == Kind::Identifier) add({by, at, hash, close + 1, kNone, scope});
        }
    }

    void read(std::size_t hash)
    {
        const std::size_t open = hash + 2, close = document_.partner(open);
        if (document_.kind(open) != Kind::LeftParen || close == kNone) return;
        for (std::size_t at = open + 3; at < close; ++at)  // behind the file's name
            if (document_.kind(at) == Kind::Identifier && document_.kind(at + 1) != Kind::LeftSquare)
                add({DeclaredBy::Declare, at, hash, close + 1, kNone, kNone});
    }

    void macro(std::size_t hash)
    {
        const std::size_t name = hash + 2, open = hash + 3, count = document_.tokens().size();
        if (document_.kind(name) != Kind::Identifier) return;
        const std::uint32_t jump = document_.tokens()[hash].jump;
        const std::size_t end = jump == parser::kNoIndex ? count - 1 : std::min<std::size_t>(jump + 2, count - 1);
        add({DeclaredBy::Macro, name, hash, end, open, kNone});
        out_.scopes.push_back({hash, end, true});
        macros_.push_back(out_.scopes.size() - 1);
        parameters(open);
    }

    /// `function (a, b) { ... }` has parameters; `function { ... }` none that are named.
    void function(std::size_t at)
    {
        const std::size_t open = at + 1, close = document_.partner(open);
        if (document_.kind(open) != Kind::LeftParen || close == kNone || document_.kind(close + 1) != Kind::LeftBrace)
            return;
        const std::size_t end = document_.partner(close + 1);
        if (end == kNone) return;
        out_.scopes.push_back({at, end + 1, false});
        parameters(open);
    }

    void parameters(std::size_t open)
    {
        const std::size_t close = document_.partner(open), scope = out_.scopes.size() - 1;
        if (document_.kind(open) != Kind::LeftParen || close == kNone) return;
        for (std::size_t at = open + 1; at < close; ++at)
            if (document_.kind(at) == Kind::Identifier)
                add({DeclaredBy::Parameter, at, out_.scopes[scope].begin, out_.scopes[scope].end, kNone, scope});
    }

    void add(Declaration declaration) { out_.declarations.push_back(declaration); }
    std::size_t inner_macro() const { return macros_.empty() ? kNone : macros_.back(); }
    std::size_t end_of_list(std::size_t open) const
    {
        return document_.partner(open) == kNone ? open + 1 : document_.partner(open) + 1;
    }

    /// Behind the ';', or where the next statement must begin.
    std::size_t end_of_value(std::size_t at) const
    {
        for (;; ++at) {
            const Kind kind = document_.kind(at);
            if (kind == Kind::EndOfText || kind == Kind::Hash || kind == Kind::RightBrace) return at;
            if (kind == Kind::Semicolon) return at + 1;
            if (document_.partner(at) == kNone || document_.partner(at) < at) continue;
            at = document_.partner(at);
            if (kind != Kind::LeftBrace || goes_on(document_.kind(at + 1))) continue;
            return document_.kind(at + 1) == Kind::Semicolon ? at + 2 : at + 1;
        }
    }

    const Document& document_;
    Outline out_;
    std::vector<std::size_t> macros_;  ///< that are open, among the scopes
};

}  // namespace

Outline outline_of(const Document& document) { return Walk(document).take(); }

}  // namespace language
