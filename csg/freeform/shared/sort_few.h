#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

/// A few numbers in order, with what belongs to them, without a branch that depends on them.
namespace csg {

/// Bitonic sorting (Batcher, "Sorting networks and their applications", 1968) of 4 x `rows` numbers; number i stands in
/// row i % rows, so that those which are compared mostly stand in two rows.
template <std::size_t rows>
class Bitonic {
public:
    typedef double Four __attribute__((vector_size(32)));

    static void sort(std::array<Four, rows>& v)
    {
        for (std::size_t size = 2; size <= rows; size *= 2) {
            for (std::size_t first = 0; first < rows; first += size)
                for (std::size_t i = 0; i < size / 2; ++i) order(v[first + i], v[first + size - 1 - i]);
            merge(v, size / 4);
        }
        order_lanes<true, true>(v);
        merge(v, rows / 2);
        order_lanes<false, true>(v);
        order_lanes<true, false>(v);
        merge(v, rows / 2);
    }

private:
    static void order(Four& a, Four& b)
    {
        const Four low = b < a ? b : a, high = b < a ? a : b;
        a = low;
        b = high;
    }

    static void merge(std::array<Four, rows>& v, std::size_t distance)
    {
        for (; distance > 0; distance /= 2)
            for (std::size_t i = 0; i < rows; ++i)
                if ((i & distance) == 0) order(v[i], v[i + distance]);
    }

    /// Lanes with those next to them, or with those on the other side; the rows from the first on with themselves or,
    /// mirrored, with those from the last on.
    template <bool next, bool mirrored>
    static void order_lanes(std::array<Four, rows>& v)
    {
        const std::array<Four, rows> from = v;
        for (std::size_t i = 0; i < rows; ++i) {
            const Four &a = from[i], &other = from[mirrored ? rows - 1 - i : i];
            Four b;
            if constexpr (next) b = __builtin_shufflevector(other, other, 1, 0, 3, 2);
            else b = __builtin_shufflevector(other, other, 3, 2, 1, 0);
            const Four low = b < a ? b : a, high = b < a ? a : b;
            if constexpr (next) v[i] = __builtin_shufflevector(low, high, 0, 5, 2, 7);
            else v[i] = __builtin_shufflevector(low, high, 0, 1, 6, 7);
        }
    }
};

/// Puts up to 32 items in order by their member `t`, a finite number; those that are equal stay as they are. Each
/// number takes the item's place in its last bits on its way, so that numbers that differ there are put right behind.
template <class Item>
class SortFew {
public:
    static constexpr std::size_t kMost = 32;
    static_assert(sizeof(Item) == 16 && offsetof(Item, t) == 0);

    static void sort(Item* items, std::size_t count)
    {
        if (count > 16) by_network<8>(items, count);
        else if (count > 8) by_network<4>(items, count);
        else if (count > 5) by_network<2>(items, count);
        one_by_one(items, count);
    }

private:
    typedef double Four __attribute__((vector_size(32)));
    typedef long long Words __attribute__((vector_size(32)));

    template <std::size_t rows>
    [[gnu::always_inline]] static inline void by_network(Item* items, std::size_t count)
    {
        constexpr std::size_t kRoom = 4 * rows;
        constexpr long long kPlaces = 2 * kMost - 1;  // from 1 on, so that no two numbers are both zeros
        alignas(32) std::array<Item, kRoom> from;
        std::memcpy(from.data(), items, count * sizeof(Item));
        std::array<Four, rows> keys;
        const Words whole = {static_cast<long long>(count), static_cast<long long>(count),
                             static_cast<long long>(count), static_cast<long long>(count)};
        for (std::size_t i = 0; i < rows; ++i) {
            Four a, b;
            std::memcpy(&a, &from[4 * i], sizeof a);
            std::memcpy(&b, &from[4 * i + 2], sizeof b);
            const Four t = __builtin_shufflevector(a, b, 0, 2, 4, 6) + 0.0;  // one zero
            const long long at = static_cast<long long>(4 * i);
            const Words place = {at + 1, at + 2, at + 3, at + 4};
            Words bits;
            std::memcpy(&bits, &t, sizeof bits);
            // Below zero what has more bits is less.
            bits = (bits & ~kPlaces) | ((place ^ (bits >> 63)) & kPlaces);
            Four key;
            std::memcpy(&key, &bits, sizeof key);
            keys[i] = place <= whole ? key : Four{} + kBeyond;
        }
        Bitonic<rows>::sort(keys);
        alignas(32) std::array<long long, kRoom> places;
        for (std::size_t i = 0; i < rows; ++i) {
            Words bits;
            std::memcpy(&bits, &keys[i], sizeof bits);
            bits = (bits ^ (bits >> 63)) & kPlaces;
            std::memcpy(&places[4 * i], &bits, sizeof bits);
        }
        for (std::size_t i = 0; i < count; ++i)
            items[i] = from[static_cast<std::size_t>(places[4 * (i % rows) + i / rows]) - 1];
    }

    static void one_by_one(Item* items, std::size_t count)
    {
        for (std::size_t i = 1; i < count; ++i) {
            if (!(items[i].t < items[i - 1].t)) continue;
            const Item item = items[i];
            std::size_t k = i;
            for (; k > 0 && item.t < items[k - 1].t; --k) items[k] = items[k - 1];
            items[k] = item;
        }
    }

    static constexpr double kBeyond = 1.7e308;
};

}  // namespace csg
