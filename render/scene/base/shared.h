#pragma once

#include <atomic>
#include <cstdint>
#include <utility>

namespace scene {

/// A T that copies share until one of them is changed (copy on write). One that was never given is a T{} and takes no
/// memory beyond the handle. Copies may be made and dropped by several threads; one handle is changed by one at a time.
template <class T>
class Shared {
public:
    Shared() = default;
    Shared(T value) : node_(new Node(std::move(value))) {}
    Shared(const Shared& other) noexcept : node_(other.node_)
    {
        if (node_) node_->holders.fetch_add(1, std::memory_order_relaxed);
    }
    Shared(Shared&& other) noexcept : node_(std::exchange(other.node_, nullptr)) {}
    Shared& operator=(const Shared& other) noexcept
    {
        Shared copy(other);
        std::swap(node_, copy.node_);
        return *this;
    }
    Shared& operator=(Shared&& other) noexcept
    {
        std::swap(node_, other.node_);
        return *this;
    }
    ~Shared() { release(); }

    const T& operator*() const { return node_ ? node_->value : usual(); }
    const T* operator->() const { return &**this; }
    /// Whether a value was given or changed; it may still equal a T{}.
    bool given() const { return node_ != nullptr; }
    /// The same memory.
    bool same(const Shared& other) const { return node_ == other.node_; }
    /// To change it: no other handle sees that.
    T& edit()
    {
        if (!node_) node_ = new Node(T{});
        else if (node_->holders.load(std::memory_order_acquire) != 1) *this = Shared(T(node_->value));
        return node_->value;
    }

private:
    struct Node {
        explicit Node(T v) : value(std::move(v)) {}
        std::atomic<std::uint32_t> holders{1};
        T value;
    };
    static const T& usual()
    {
        static const T value{};
        return value;
    }
    void release()
    {
        if (!node_) return;
        // The last holder needs no exclusive access to see that it is the last.
        if (node_->holders.load(std::memory_order_acquire) == 1 ||
            node_->holders.fetch_sub(1, std::memory_order_acq_rel) == 1)
            delete node_;
    }
    Node* node_ = nullptr;
};

}  // namespace scene
