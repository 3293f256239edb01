#pragma once

#include "render/scene/object.h"

#include <cstddef>
#include <iterator>
#include <memory>
#include <stdexcept>
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
    ObjectList(ObjectList&&) = default;
    ObjectList& operator=(ObjectList&&) = default;
    ObjectList(const ObjectList& other)
    {
        for (const Object& one : other) push_back(one);
    }
    ObjectList& operator=(const ObjectList& other)
    {
        *this = ObjectList(other);
        return *this;
    }
    void push_back(Object object)
    {
        if (blocks_.empty() || blocks_.back().size() == kBlock) blocks_.emplace_back().reserve(kBlock);
        blocks_.back().push_back(std::move(object));
    }
    std::size_t size() const { return blocks_.empty() ? 0 : (blocks_.size() - 1) * kBlock + blocks_.back().size(); }
    bool empty() const { return blocks_.empty(); }
    void clear() { blocks_.clear(); }
    Object& operator[](std::size_t i) { return blocks_[i / kBlock][i % kBlock]; }
    const Object& operator[](std::size_t i) const { return blocks_[i / kBlock][i % kBlock]; }
    const Object& at(std::size_t i) const
    {
        if (i >= size()) throw std::out_of_range("no such object");
        return (*this)[i];
    }
    const Object& front() const { return (*this)[0]; }
    const Object& back() const { return blocks_.back().back(); }
    Object& back() { return blocks_.back().back(); }

    Iterator<ObjectList, Object> begin() { return {this, 0}; }
    Iterator<ObjectList, Object> end() { return {this, size()}; }
    Iterator<const ObjectList, const Object> begin() const { return {this, 0}; }
    Iterator<const ObjectList, const Object> end() const { return {this, size()}; }

private:
    static constexpr std::size_t kBlock = 128;
    std::vector<std::vector<Object>> blocks_;
};

}  // namespace scene
