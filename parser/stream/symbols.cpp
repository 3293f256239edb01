#include "parser/stream/symbols.h"

#include <algorithm>

namespace parser {

std::vector<Symbols::Binding>& Symbols::slot(std::uint32_t name)
{
    if (name >= slots_.size()) slots_.resize(std::max<std::size_t>(name + 1, slots_.size() * 2));
    return slots_[name];
}

Cell Symbols::find_cell(std::uint32_t name) const
{
    return name < slots_.size() && !slots_[name].empty() ? slots_[name].back().cell : nullptr;
}

bool Symbols::in_current_scope(std::uint32_t name) const
{
    return name < slots_.size() && !slots_[name].empty() && slots_[name].back().scope == depth();
}

Cell Symbols::declare(std::uint32_t name)
{
    auto& bindings = slot(name);
    return bindings.empty() ? global(name) : bindings.back().cell;
}

Cell Symbols::local(std::uint32_t name, std::uint32_t scope)
{
    auto& bindings = slot(name);
    auto at = bindings.end();
    while (at != bindings.begin() && (at - 1)->scope > scope) --at;
    if (at != bindings.begin() && (at - 1)->scope == scope) return (at - 1)->cell;
    if (scope > 0) opened_[scope - 1].push_back(name);
    return bindings.insert(at, {std::make_shared<Value>(), scope})->cell;
}

Cell Symbols::global(std::uint32_t name)
{
    auto& bindings = slot(name);
    if (bindings.empty() || bindings.front().scope != 0) bindings.insert(bindings.begin(), {std::make_shared<Value>(), 0});
    return bindings.front().cell;
}

void Symbols::bind(std::uint32_t name, Cell cell)
{
    auto& bindings = slot(name);
    if (in_current_scope(name)) {
        bindings.back().cell = std::move(cell);
        return;
    }
    bindings.push_back({std::move(cell), depth()});
    if (!opened_.empty()) opened_.back().push_back(name);
}

bool Symbols::undefine(std::uint32_t name)
{
    auto& bindings = slot(name);
    if (bindings.empty()) return false;
    bindings.pop_back();
    return true;
}

void Symbols::open_scope()
{
    opened_.emplace_back();
}

void Symbols::close_scope()
{
    const std::uint32_t scope = depth();
    for (const std::uint32_t name : opened_.back())  // an undefined one is gone already
        if (!slots_[name].empty() && slots_[name].back().scope == scope) slots_[name].pop_back();
    opened_.pop_back();
}

}  // namespace parser
