#pragma once

#include "csg/base/hit.h"
#include "numbers/lanes.h"
#include "csg/freeform/field/field.h"
#include "csg/base/fused_at.h"

#include <array>
#include <bit>

namespace csg {

/// How max_gradient grows with `evaluate`: above `from` by `factor` a search, and to `room` squared of a slope.
struct GradientGrowth {
    double from, room, factor;
};

/// The ways of eight rays through a field, a lane each, halved as IsosurfaceSearch::bisect() does it: in the same
/// places, with the same bits.
class EightWays {
public:
    static constexpr std::size_t kWide = 8;
    struct Sample {
        double t, f;
    };

    /// A ray for a lane. is_far: points are rounded once. Nothing beyond `to` matters.
    void begin(std::size_t lane, const Ray& ray, bool is_far, double accuracy, double gradient, double to)
    {
        for (std::size_t k = 0; k < 3; ++k) {
            origin_[k].v[lane] = ray.origin[static_cast<int>(k)];
            direction_[k].v[lane] = ray.direction[static_cast<int>(k)];
        }
        far_ = (far_ & ~(1u << lane)) | std::uint32_t{is_far} << lane;
        speed_.v[lane] = std::sqrt(glm::dot(ray.direction, ray.direction));
        accuracy_.v[lane] = accuracy;
        gradient_.v[lane] = gradient;
        to_.v[lane] = to;
    }

    /// What is looked for: where sign * field falls below 0 between two places of the ray.
    void part(std::size_t lane, const Sample& near, const Sample& far, double sign)
    {
        near_t_.v[lane] = near.t;
        near_f_.v[lane] = sign * near.f;
        far_t_.v[lane] = far.t;
        far_f_.v[lane] = sign * far.f;
        sign_.v[lane] = sign;
        waiting_[lane] = 0;
    }
    void grow(std::size_t lane, const GradientGrowth& growth)
    {
        if (gradient_.v[lane] > growth.from) gradient_.v[lane] *= growth.factor;
    }

    /// What a lane asks for.
    double& at(std::size_t lane) { return at_.v[lane]; }
    double crossing(std::size_t lane) const { return far_t_.v[lane]; }

    /// Where `busy` lanes ask. The others have the place of one of these: a ray that is through may be anywhere.
    void points(std::uint32_t busy, EightPoints& out) const
    {
        const auto one = static_cast<std::size_t>(std::countr_zero(busy));
        Eight* const to[3] = {&out.x, &out.y, &out.z};
        for (std::size_t k = 0; k < 3; ++k) {
            const double instead = origin_[k].v[one] + at_.v[one] * direction_[k].v[one];
            for (std::size_t i = 0; i < kWide; i += lanes::kDoubles)
                xsimd::select(lanes::lanes_of(busy >> i), get(origin_[k], i) + get(at_, i) * get(direction_[k], i),
                              lanes::Double(instead))
                    .store_aligned(to[k]->v + i);
        }
        for (std::uint32_t left = far_ & busy; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            const glm::dvec3 p = fused_at(ray(lane), at_.v[lane]);
            out.x.v[lane] = p.x, out.y.v[lane] = p.y, out.z.v[lane] = p.z;
        }
    }

    /// `field` is what these lanes asked for at the middle of a piece: the halves take its place, the nearer one first.
    void take_middles(std::uint32_t asked, const Eight& field)
    {
        for (std::uint32_t left = asked; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            ends_[lane][waiting_[lane]++] = {far_t_.v[lane], far_f_.v[lane]};
        }
        for (std::size_t i = 0; i < kWide; i += lanes::kDoubles) {
            const auto here = lanes::lanes_of(asked >> i);
            put(far_t_, i, xsimd::select(here, get(at_, i), get(far_t_, i)));
            put(far_f_, i, xsimd::select(here, get(sign_, i) * get(field, i), get(far_f_, i)));
        }
    }

    /// Which of these lanes ask for the middle of a piece. `crossed`: for which crossing() is found; there is none for
    /// the others. growth: null without `evaluate`.
    std::uint32_t search(std::uint32_t searching, const GradientGrowth* growth, std::uint32_t& crossed)
    {
        std::uint32_t asking = 0, beyond = 0;
        crossed = 0;
        if (searching == 0) return 0;
        for (std::size_t i = 0; i < kWide; i += lanes::kDoubles) {
            const Found found = look(i, searching >> i & kAll, growth);
            asking |= found.asking << i;
            crossed |= found.crossed << i;
            beyond |= found.beyond << i;
        }
        // The pieces behind: seldom many, of few lanes.
        for (std::uint32_t left = searching & ~(asking | crossed | beyond); left != 0; left &= left - 1) {
            const std::uint32_t bit = left & (0u - left);
            switch (go_on(static_cast<std::size_t>(std::countr_zero(left)), growth, false)) {
            case Piece::Asks: asking |= bit; break;
            case Piece::Crossed: crossed |= bit; break;
            case Piece::None: break;
            }
        }
        return asking;
    }

    enum class Piece { Asks, Crossed, None };
    // The same for one lane while no other is busy.
    glm::dvec3 point(std::size_t lane) const
    {
        const Ray along = ray(lane);
        return (far_ >> lane & 1u) != 0 ? fused_at(along, at_.v[lane]) : along.at(at_.v[lane]);
    }
    void take_middle(std::size_t lane, double field)
    {
        ends_[lane][waiting_[lane]++] = {far_t_.v[lane], far_f_.v[lane]};
        far_t_.v[lane] = at_.v[lane];
        far_f_.v[lane] = sign_.v[lane] * field;
    }
    Piece search_alone(std::size_t lane, const GradientGrowth* growth) { return go_on(lane, growth, true); }

private:
    using Double = lanes::Double;
    static constexpr std::uint32_t kAll = (1u << lanes::kDoubles) - 1;
    // Halves are no shorter than 2^-40 of the way: of each length one piece waits.
    static constexpr std::size_t kMostPieces = 64;

    static Double get(const Eight& from, std::size_t i) { return Double::load_aligned(from.v + i); }
    static void put(Eight& to, std::size_t i, const Double& v) { v.store_aligned(to.v + i); }

    Ray ray(std::size_t lane) const
    {
        return {{origin_[0].v[lane], origin_[1].v[lane], origin_[2].v[lane]},
                {direction_[0].v[lane], direction_[1].v[lane], direction_[2].v[lane]}};
    }

    /// Bits of a vector's lanes.
    struct Found {
        std::uint32_t asking, crossed, beyond;
    };

    /// The nearest piece of the lanes `here` of the vector at i.
    Found look(std::size_t i, std::uint32_t here, const GradientGrowth* growth)
    {
        const Double near_t = get(near_t_, i), near_f = get(near_f_, i), far_t = get(far_t_, i), far_f = get(far_f_, i),
                     length = far_t - near_t, world = get(speed_, i) * length;
        const std::uint32_t beyond = here & lanes::mask(near_t > get(to_, i)), seen = here & ~beyond;
        Double gradient = get(gradient_, i);
        if (growth != nullptr) {
            const Double least = xsimd::abs(far_f - near_f) / world * Double(growth->room);
            const auto grows = lanes::lanes_of(seen & lanes::mask(gradient < least));
            gradient = xsimd::select(grows, least * Double(growth->room), gradient);
            put(gradient_, i, gradient);
        }
        const Double t = near_t + Double(0.5) * length;
        // From far off no number may lie between, however long the accuracy.
        const std::uint32_t whole = seen & lanes::mask((length < get(accuracy_, i)) | (t == near_t) | (t == far_t)),
                            below = lanes::mask(near_f + far_f - gradient * world < Double(0.0)),
                            asking = seen & ~whole & below;
        put(at_, i, xsimd::select(lanes::lanes_of(asking), t, get(at_, i)));
        return {asking, whole & lanes::mask(far_f < Double(0.0)), beyond};
    }

    /// look() at the nearest piece of one lane if it is `new_near`, and at what waits behind, as far as need be: each
    /// piece begins where the last one ended.
    Piece go_on(std::size_t lane, const GradientGrowth* growth, bool new_near)
    {
        const double speed = speed_.v[lane], accuracy = accuracy_.v[lane], to = to_.v[lane];
        double gradient = gradient_.v[lane];
        Sample near{near_t_.v[lane], near_f_.v[lane]}, far{far_t_.v[lane], far_f_.v[lane]};
        std::size_t waiting = waiting_[lane];
        Piece found = Piece::None;
        for (bool known = !new_near;; known = true) {
            if (known) {
                if (waiting == 0) break;
                near = far;
                far = ends_[lane][--waiting];
            }
            if (near.t > to) break;
            const double length = far.t - near.t, world = speed * length;
            if (growth != nullptr) {
                const double least = std::abs(far.f - near.f) / world * growth->room;
                if (gradient < least) gradient = least * growth->room;
            }
            const double t = near.t + 0.5 * length;
            if (length < accuracy || t == near.t || t == far.t) {
                if (!(far.f < 0.0)) continue;
                found = Piece::Crossed;
            } else {
                if (!(near.f + far.f - gradient * world < 0.0)) continue;
                found = Piece::Asks;
                at_.v[lane] = t;
            }
            near_t_.v[lane] = near.t, near_f_.v[lane] = near.f;
            far_t_.v[lane] = far.t, far_f_.v[lane] = far.f;
            break;
        }
        gradient_.v[lane] = gradient;
        waiting_[lane] = waiting;
        return found;
    }

    Eight origin_[3], direction_[3], speed_, accuracy_, gradient_, to_, sign_;
    Eight near_t_, near_f_, far_t_, far_f_;  ///< of the nearest piece; values times sign
    Eight at_;
    std::uint32_t far_ = 0;
    std::array<std::size_t, kWide> waiting_;  ///< how many ends
    std::array<std::array<Sample, kMostPieces>, kWide> ends_;
};

}  // namespace csg
