#pragma once

#include "csg/base/roundings.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace csg {

/// Which of several objects POV-Ray asks first for a ray: of faces in one place that one's is seen (spec 5a, 2.2 and
/// 11.3). The order is that in which the ray comes to the boxes of POV-Ray's hierarchy, which is built again here for
/// its shape; nothing else is looked for in it.
class TestOrder {
public:
    /// As POV-Ray keeps an object's box.
    struct Box {
        glm::vec3 lower{0.0f}, edges{0.0f};
        bool infinite = false;  ///< or so large that it is taken for it: asked before all others

        static Box of(const Aabb& box);
        glm::vec3 upper() const { return lower + edges; }
    };

    /// \param items  boxes of all objects, as they are declared
    /// \param by     whose hierarchy it is; ours is 3.7's
    /// \param whole  of each item the place of the box that it lies in, where boxes hold several; empty: its own
    explicit TestOrder(std::span<const Box> items, Roundings by = Roundings::V37,
                       std::vector<std::uint32_t> whole = {});

    /// Of these items (places in the list), which the ray all meets, the one that is asked first.
    std::uint32_t first(const Ray& ray, std::span<const std::uint32_t> items) const;

    /// Puts such items in the order in which they are asked.
    void arrange(const Ray& ray, std::span<std::uint32_t> items) const;

    /// Puts items (places in the list) in the order in which all that hold a point are found (spec 5a, 11.5): that of
    /// the hierarchy, from its root down.
    void arrange(std::vector<std::uint32_t>& items) const;

private:
    struct Node {
        Box box;
        std::uint32_t first_child = 0, child_count = 0;  ///< in children_
        std::uint32_t item = kNone;
    };
    static constexpr std::uint32_t kNone = 0xffffffffu;
    using Numbers = std::vector<std::uint32_t>;

    /// A node while parts of all nodes are sorted.
    struct Placed {
        Box box;
        std::uint32_t node;
        float middle;
    };

    /// f(object) for those whose boxes the ray meets, in that order, until it is true.
    template <class F>
    void visit(const Ray& ray, F&& f) const;
    std::uint32_t whole_of(std::uint32_t item) const { return whole_.empty() ? item : whole_[item]; }
    Numbers gather(const Numbers& nodes);
    std::size_t divided(std::span<Placed> nodes, std::vector<float>& areas) const;
    int widest_axis(std::span<const Placed> nodes) const;
    std::uint32_t add_parent(std::span<const std::uint32_t> nodes);
    Box hull(std::span<const std::uint32_t> nodes) const;

    std::vector<Node> nodes_;
    Numbers children_;
    std::uint32_t root_ = kNone;  ///< none: the first of the items is the first
    Roundings by_;
    Numbers whole_;
    std::size_t work_left_ = 0;  ///< boxes that may still be looked at
};

/// The order, made when a ray first needs it.
class LazyTestOrder {
public:
    /// Of more the boxes would take a sixth of the time that a scene is planned in, and as a rule no two lie in one
    /// place: then the object declared first is seen.
    static constexpr std::size_t kMostItems = 1u << 16;
    /// Boxes that are not an item's drawn bounds (drawn_bounds()), by item.
    std::vector<std::pair<std::uint32_t, TestOrder::Box>> boxes;
    /// Items that are one object there: a bounded union, whose parts are asked together.
    struct Whole {
        std::uint32_t first, end;
        TestOrder::Box box;
    };
    std::vector<Whole> wholes;
    Roundings by = Roundings::V37;

    template <class Make>
    const TestOrder& made(Make&& make) const
    {
        std::call_once(once_, [&] { order_ = std::make_unique<const TestOrder>(make()); });
        return *order_;
    }

private:
    mutable std::once_flag once_;
    mutable std::unique_ptr<const TestOrder> order_;
};

}  // namespace csg
