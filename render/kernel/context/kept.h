#pragma once

#include <memory>

namespace trace {

/// What a stage keeps from tile to tile, in a scratch that knows of the stage but the name: made when it is first asked
/// for. Only the stage knows what it is, so only the stage asks.
/// \tparam Cleared false: what its constructors leave alone is anything, which is sooner for what is large
template <class T, bool Cleared = true>
class Kept {
public:
    T& operator()()
    {
        if (!kept_) make();
        return *kept_;
    }

private:
    [[gnu::noinline]] void make()
    {
        if constexpr (Cleared) kept_ = {new T(), drop};
        else kept_ = {new T, drop};
    }
    static void drop(T* kept) { delete kept; }

    std::unique_ptr<T, void (*)(T*)> kept_{nullptr, nullptr};
};

}  // namespace trace
