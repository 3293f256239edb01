#include "parser/stream/values/symbols.h"

#include <algorithm>
#include <cstddef>
#include <new>
#include <utility>

namespace parser {
namespace {

/// Memory of cells that is used again at once: macros make and leave a handful at every call. What is free lies in a
/// list within itself, so that giving it back never asks for memory.
class CellMemory {
public:
    ~CellMemory()
    {
        while (free_) ::operator delete(pop());
    }
    void* take(std::size_t size)
    {
        if (!free_) size_ = size;
        return size == size_ && free_ ? pop() : ::operator new(size);
    }
    void give(void* one, std::size_t size)
    {
        constexpr std::size_t kMost = 1024;
        if (size != size_ || count_ >= kMost) return ::operator delete(one);
        free_ = new (one) Free{free_};
        ++count_;
    }

private:
    struct Free {
        Free* next;
    };
    void* pop()
    {
        --count_;
        return std::exchange(free_, free_->next);
    }
    std::size_t size_ = 0, count_ = 0;
    Free* free_ = nullptr;
};

CellMemory& cell_memory()
{
    thread_local CellMemory memory;
    return memory;
}

template <class T>
struct CellAllocator {
    using value_type = T;
    CellAllocator() = default;
    template <class U>
    CellAllocator(const CellAllocator<U>&)
    {}
    T* allocate(std::size_t count) { return static_cast<T*>(cell_memory().take(count * sizeof(T))); }
    void deallocate(T* one, std::size_t count) { cell_memory().give(one, count * sizeof(T)); }
    template <class U>
    bool operator==(const CellAllocator<U>&) const
    {
        return true;
    }
};

}  // namespace

Cell make_cell(Value value) { return std::allocate_shared<Value>(CellAllocator<Value>(), std::move(value)); }

Cell make_number_cell(const double* numbers, int count)
{
    Cell made = std::allocate_shared<Value>(CellAllocator<Value>(), std::in_place_type<Tuple>);
    Tuple& tuple = *made->get_if<Tuple>();
    tuple.count = count;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        tuple.at[i] = count == 5 ? static_cast<float>(numbers[i]) : numbers[i];  // Tuple::stored
    return made;
}

void Symbols::grow(std::uint32_t name)
{
    slots_.resize(std::max<std::size_t>(name + 1, slots_.size() * 2));
    current_.resize(slots_.size());
}

Cell Symbols::find_global(std::uint32_t name) const
{
    const bool known = name < slots_.size() && !slots_[name].empty() && slots_[name].front().scope == 0;
    return known ? slots_[name].front().cell : nullptr;
}

bool Symbols::in_current_scope(std::uint32_t name) const
{
    return name < slots_.size() && !slots_[name].empty() && slots_[name].back().scope == depth();
}

const Cell& Symbols::declare(std::uint32_t name)
{
    auto& bindings = slot(name);
    return bindings.empty() ? global(name) : bindings.back().cell;
}

const Cell& Symbols::new_local(std::uint32_t name, std::uint32_t scope)
{
    auto& bindings = slot(name);
    auto at = bindings.end();
    while (at != bindings.begin() && (at - 1)->scope > scope) --at;
    if (at != bindings.begin() && (at - 1)->scope == scope) return (at - 1)->cell;
    if (scope > 0) opened_[scope - 1].push_back(name);
    const Cell& made = bindings.insert(at, Binding(make_cell({}), scope))->cell;
    refresh(name);
    return made;
}

const Cell& Symbols::global(std::uint32_t name)
{
    auto& bindings = slot(name);
    if (bindings.empty() || bindings.front().scope != 0) bindings.insert(bindings.begin(), Binding(make_cell({}), 0));
    refresh(name);
    return bindings.front().cell;
}

bool Symbols::undefine(std::uint32_t name)
{
    auto& bindings = slot(name);
    if (bindings.empty()) return false;
    bindings.pop_back();
    refresh(name);
    return true;
}

void Symbols::open_scope()
{
    if (opened_.size() == depth_) opened_.emplace_back();
    ++depth_;
}

void Symbols::close_scope()
{
    const std::uint32_t scope = depth();
    for (const std::uint32_t name : opened_[scope - 1])  // an undefined one is gone already
        if (auto& bindings = slots_[name]; !bindings.empty() && bindings.back().scope == scope) {
            bindings.pop_back();
            refresh(name);
        }
    opened_[scope - 1].clear();
    --depth_;
}

}  // namespace parser
