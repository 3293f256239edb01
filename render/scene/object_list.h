#pragma once

#include "render/scene/base/large_page.h"
#include "render/scene/object.h"

#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <new>
#include <stdexcept>
#include <utility>
#include <vector>

namespace scene {

/// The objects of a scene in order. They lie in blocks that never move: a million of them grows without copies and
/// without the memory of a second array.
class ObjectList {
public:
    template <class List, class Item>
    class Iterator {
    public:
        using value_type = Object;
        using difference_type = std::ptrdiff_t;
        using pointer = Item*;
        using reference = Item&;
        using iterator_category = std::forward_iterator_tag;
        Iterator() = default;
        Iterator(List* list, std::size_t at) : list_(list), at_(at) {}
        Item& operator*() const { return (*list_)[at_]; }
        Item* operator->() const { return &(*list_)[at_]; }
        Iterator& operator++()
        {
            ++at_;
            return *this;
        }
        Iterator operator++(int)
        {
            Iterator before = *this;
            ++at_;
            return before;
        }
        friend bool operator==(const Iterator&, const Iterator&) = default;

    private:
        List* list_ = nullptr;
        std::size_t at_ = 0;
    };
    ObjectList() = default;
    ~ObjectList() { clear(); }
    ObjectList(ObjectList&& other) noexcept
        : blocks_(std::move(other.blocks_)), memory_(std::move(other.memory_)), size_(std::exchange(other.size_, 0)),
          free_(std::exchange(other.free_, 0)), next_(std::exchange(other.next_, nullptr))
    {}
    ObjectList& operator=(ObjectList&& other) noexcept
    {
        std::swap(blocks_, other.blocks_);
        std::swap(memory_, other.memory_);
        std::swap(size_, other.size_);
        std::swap(free_, other.free_);
        std::swap(next_, other.next_);
        return *this;
    }
    ObjectList(const ObjectList& other)
    {
        for (const Object& one : other) push_back(one);
    }
    ObjectList& operator=(const ObjectList& other)
    {
        *this = ObjectList(other);
        return *this;
    }
    void push_back(Object object) { emplace_back(std::move(object)); }
    template <class... Arguments>
    Object& emplace_back(Arguments&&... arguments)
    {
        if (size_ == blocks_.size() * kBlock) add_block();
        Object* const made = new (&blocks_[size_ / kBlock][size_ % kBlock])
            Object(std::forward<Arguments>(arguments)...);
        ++size_;
        return *made;
    }
    void pop_back() { back().~Object(), --size_; }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    void clear()
    {
        for (std::size_t i = 0; i < size_; ++i) (*this)[i].~Object();
        blocks_.clear();
        memory_.clear();
        size_ = free_ = 0;
    }
    Object& operator[](std::size_t i) { return blocks_[i / kBlock][i % kBlock]; }
    const Object& operator[](std::size_t i) const { return blocks_[i / kBlock][i % kBlock]; }
    const Object& at(std::size_t i) const
    {
        if (i >= size()) throw std::out_of_range("no such object");
        return (*this)[i];
    }
    const Object& front() const { return (*this)[0]; }
    const Object& back() const { return (*this)[size_ - 1]; }
    Object& back() { return (*this)[size_ - 1]; }

    Iterator<ObjectList, Object> begin() { return {this, 0}; }
    Iterator<ObjectList, Object> end() { return {this, size()}; }
    Iterator<const ObjectList, const Object> begin() const { return {this, 0}; }
    Iterator<const ObjectList, const Object> end() const { return {this, size()}; }

private:
    static constexpr std::size_t kBlock = 128, kFewBlocks = 16;
    struct Free {
        bool page = false;
        void operator()(void* memory) const
        {
            if (page) ::operator delete (memory, std::align_val_t{kLargePage});
            else ::operator delete(memory);
        }
    };
    /// The first blocks by themselves, later ones many at a time where one page of the system is enough for all.
    void add_block()
    {
        constexpr std::size_t kBytes = kBlock * sizeof(Object), kMany = kLargePage / kBytes;
        if (free_ == 0) {
            const bool many = blocks_.size() >= kFewBlocks;
            void* const memory = many ? ::operator new (kLargePage, std::align_val_t{kLargePage})
                                      : ::operator new(kBytes);
            memory_.emplace_back(memory, Free{many});
            if (many && large_pages_) large_pages_ = take_large_page(memory, kLargePage);
            next_ = static_cast<Object*>(memory);
            free_ = many ? kMany : 1;
        }
        blocks_.push_back(next_);
        next_ += kBlock;
        --free_;
    }
    std::vector<Object*> blocks_;
    std::vector<std::unique_ptr<void, Free>> memory_;
    std::size_t size_ = 0, free_ = 0;  ///< free: blocks left of the memory that was asked for last
    Object* next_ = nullptr;           ///< the first of them
    bool large_pages_ = true;
};

}  // namespace scene
