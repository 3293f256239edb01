#pragma once

#include "csg/base/types.h"

#include <bit>
#include <cstdint>
#include <functional>
#include <unordered_map>

/// Keys of things by where they stand, so that copies share what is made of them.
namespace plan {

inline bool same(const csg::Transform& a, const csg::Transform& b)
{
    return a.linear == b.linear && a.offset == b.offset && a.inverse_linear == b.inverse_linear &&
           a.inverse_offset == b.inverse_offset;
}

/// Of a thing and where it stands; equal transformations have equal ones.
inline std::size_t key_of(const void* thing, const csg::Transform& t)
{
    std::size_t key = std::hash<const void*>()(thing);
    const auto add = [&key](const double* numbers, int count) {
        for (int i = 0; i < count; ++i)  // + 0.0: both zeros are equal
            key = (key ^ (key >> 29)) * 0x9e3779b97f4a7c15u + std::bit_cast<std::uint64_t>(numbers[i] + 0.0);
    };
    add(&t.linear[0][0], 9);
    add(&t.offset[0], 3);
    return key;
}

/// What is known of things by where they stand.
template <class Value>
class ByPlace {
public:
    struct Entry {
        const void* thing;
        csg::Transform at;
        Value value{};
    };
    /// The one of equal transformations, which stays where it is; a new one's value is a Value{}.
    Entry& operator()(const void* thing, const csg::Transform& at)
    {
        const std::size_t key = key_of(thing, at);
        const auto [begin, end] = known_.equal_range(key);
        for (auto known = begin; known != end; ++known)
            if (known->second.thing == thing && same(known->second.at, at)) return known->second;
        return known_.emplace(key, Entry{thing, at})->second;
    }
    void clear()
    {
        if (!known_.empty()) known_ = {};  // its buckets too, which each clearing goes through
    }

private:
    std::unordered_multimap<std::size_t, Entry> known_;
};

}  // namespace plan
