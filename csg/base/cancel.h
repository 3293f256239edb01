#pragma once

#include <atomic>

namespace csg {

/// Thrown out of a question to a World when the flag that its Scratch watches is set: nobody wants the answer any more.
struct Cancelled {};

/// A flag that the kernel looks at once for each single ray and once for each tile of rays, so at most milliseconds
/// pass between two looks.
class CancelWatch {
public:
    /// \param flag outlives the watch; null: nothing is watched
    explicit CancelWatch(const std::atomic<bool>* flag = nullptr) : flag_(flag != nullptr ? flag : &kNever) {}
    void look() const
    {
        if (flag_->load(std::memory_order_relaxed)) [[unlikely]]
            leave();
    }

private:
    [[noreturn, gnu::cold, gnu::noinline]] static void leave() { throw Cancelled(); }
    static inline const std::atomic<bool> kNever{false};
    const std::atomic<bool>* flag_;
};

}  // namespace csg
