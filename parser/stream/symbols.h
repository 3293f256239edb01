#pragma once

#include "parser/stream/value.h"

#include <vector>

namespace parser {

/// Dynamic scoping: one stack of bindings per interned name, a scope is only a number. Scope 0 is the global table;
/// every open include file and every active macro adds one (reference manual 3.3.1.8; spec of the language 7).
class Symbols {
public:
    /// The binding in force, null if there is none.
    Value* find(std::uint32_t name) const
    {
        return name < slots_.size() && !slots_[name].empty() ? slots_[name].back().cell.get() : nullptr;
    }
    Cell find_cell(std::uint32_t name) const;
    bool in_current_scope(std::uint32_t name) const;

    /// `#declare`: the nearest symbol, else a new global one. The new one is unset.
    Cell declare(std::uint32_t name);
    /// `#local` that began in `scope` (reading its value may have entered a macro that is not left yet): the symbol of
    /// that scope, else a new one there.
    Cell local(std::uint32_t name, std::uint32_t scope);
    Cell global(std::uint32_t name);
    /// A macro parameter: `name` in the current scope means `cell` from now on.
    void bind(std::uint32_t name, Cell cell);
    /// Removes the nearest binding; false if there was none.
    bool undefine(std::uint32_t name);

    void open_scope();
    void close_scope();
    std::uint32_t depth() const { return static_cast<std::uint32_t>(opened_.size()); }

private:
    struct Binding { Cell cell; std::uint32_t scope; };
    std::vector<Binding>& slot(std::uint32_t name);
    std::vector<std::vector<Binding>> slots_;
    std::vector<std::vector<std::uint32_t>> opened_;  // names bound in each scope above the global one
};

}  // namespace parser
