#pragma once

#include "parser/stream/values/value.h"

#include <vector>

namespace parser {

/// A cell of its own that holds `value`.
Cell make_cell(Value value);
/// The same of `count` components, without a Value on the way: macros make one for each number that they get.
Cell make_number_cell(const double* numbers, int count);

/// Dynamic scoping: one stack of bindings per interned name, a scope is only a number. Scope 0 is the global table;
/// every open include file and every active macro adds one (reference manual 3.3.1.8; spec 1, 7).
class Symbols {
public:
    /// The binding in force, null if there is none.
    /// The same of a name that was bound once.
    Value* find_known(std::uint32_t name) const { return current_[name]; }
    Value* find(std::uint32_t name) const { return name < current_.size() ? current_[name] : nullptr; }
    Cell find_cell(std::uint32_t name) const
    {
        const Cell* const found = bound_cell(name);
        return found ? *found : nullptr;
    }
    /// The same where it lies; null: there is none.
    const Cell* bound_cell(std::uint32_t name) const
    {
        return name < slots_.size() && !slots_[name].empty() ? &slots_[name].back().cell : nullptr;
    }
    bool in_current_scope(std::uint32_t name) const;
    /// Of the binding in force.
    std::uint32_t scope_of(std::uint32_t name) const { return slots_[name].back().scope; }
    Cell find_global(std::uint32_t name) const;

    /// `#declare`: the nearest symbol, else a new global one. The new one is unset.
    const Cell& declare(std::uint32_t name);
    /// `#local` that began in `scope` (reading its value may have entered a macro that is not left yet): the symbol of
    /// that scope, else a new one there.
    const Cell& local(std::uint32_t name, std::uint32_t scope)
    {
        const auto& bindings = slot(name);
        return !bindings.empty() && bindings.back().scope == scope ? bindings.back().cell : new_local(name, scope);
    }
    const Cell& global(std::uint32_t name);
    /// A macro parameter: `name` in the current scope means `cell` from now on.
    void bind(std::uint32_t name, Cell cell)
    {
        auto& bindings = slot(name);
        current_[name] = cell.get();
        if (!bindings.empty() && bindings.back().scope == depth_) {
            bindings.back().cell = std::move(cell);
            return;
        }
        bindings.emplace_back(std::move(cell), depth_);
        if (depth_ > 0) opened_[depth_ - 1].push_back(name);
    }
    /// Removes the nearest binding; false if there was none.
    bool undefine(std::uint32_t name);

    void open_scope();
    void close_scope();
    std::uint32_t depth() const { return depth_; }

private:
    struct Binding {
        Binding(Cell what, std::uint32_t where) : cell(std::move(what)), scope(where) {}
        Cell cell;
        std::uint32_t scope;
    };
    std::vector<Binding>& slot(std::uint32_t name)
    {
        if (name >= slots_.size()) grow(name);
        return slots_[name];
    }
    void grow(std::uint32_t name);
    const Cell& new_local(std::uint32_t name, std::uint32_t scope);
    void refresh(std::uint32_t name)
    {
        const auto& bindings = slots_[name];
        current_[name] = bindings.empty() ? nullptr : bindings.back().cell.get();
    }
    std::vector<std::vector<Binding>> slots_;
    std::vector<Value*> current_;  // the last of each slot
    std::vector<std::vector<std::uint32_t>>
        opened_;  // names bound in each scope above the global one; the rest is kept for later
    std::uint32_t depth_ = 0;
};

}  // namespace parser
