#pragma once

#include "parser/stream/values/symbols.h"
#include "parser/stream/values/value.h"

#include <cstdint>
#include <optional>

/// Statements of the grammar in text that is read again and again: the grammar looks at their tokens once, a block
/// works their expressions out, and the grammar makes of the values what it would make of the tokens (docs/blocks.md).
namespace parser {

/// A statement of the grammar as blocks keep it.
class ReadyStatement {
public:
    virtual ~ReadyStatement() = default;
    /// Does what reading its tokens would do. `values`: of the expressions, by the places that StatementReader gave
    /// them. False: nothing was done, the tokens have to be read - they say something, or a name has another meaning.
    virtual bool run(const double* values, const Symbols& symbols) = 0;
};

/// The tokens of a statement, only looked at.
class StatementReader {
public:
    virtual ~StatementReader() = default;
    /// Of the next token; EndOfText: none of this statement.
    virtual Kind kind() const = 0;
    virtual const Token& take() = 0;
    /// To try another form of what comes next.
    struct Mark {
        std::uint32_t token = 0, operations = 0;
        std::size_t values = 0;
    };
    virtual Mark mark() const = 0;
    virtual void back_to(const Mark& mark) = 0;
    bool accept(Kind wanted)
    {
        if (kind() != wanted) return false;
        take();
        return true;
    }
    virtual scene::SourceRef place(const Token& token) const = 0;
    scene::SourceRef here() const { return place(ahead()); }
    virtual const Token& ahead() const = 0;
    /// What a name means, or will mean where the statement stands.
    virtual const Value* meaning(const Token& name) const = 0;
    /// The expression that is next, read with `requested` components (see requested_expr): the place of the first
    /// among the values; components that are missing are 0. Nothing: it is not known, or has more components.
    virtual std::optional<std::uint32_t> expression(int requested, bool full) = 0;
    /// The values of the Numbers token that is next.
    virtual std::optional<std::uint32_t> numbers(std::size_t count) = 0;
};

}  // namespace parser
