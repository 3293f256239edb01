#pragma once

#include "csg/base/hit.h"
#include "csg/tree/contains.h"
#include "csg/tree/front.h"

#include <array>
#include <vector>

namespace csg {

/// Where rays of a tile pass drawn ends of a merge's solids (Program::merged), and which of them is seen: the nearest
/// that lies in no other solid. The others are asked for that place alone, so a solid that goes on for ever, as a
/// height field does, costs nothing of the ray elsewhere.
class MergedEnds {
public:
    /// `ends`: memory.
    MergedEnds(const Program& program, const SolidStore& store, std::vector<MergedEnd>& ends)
        : program_(program), store_(store), ends_(ends)
    {
        ends_.clear();
        first_.fill(kNone);
    }

    /// Ray k passes an end of a solid, its place in Program::merged.
    void add(std::size_t k, std::uint32_t solid, double t, std::uint32_t face)
    {
        std::uint32_t* link = &first_[k];
        while (*link != kNone && !(t < ends_[*link].t)) link = &ends_[*link].next;
        const std::uint32_t next = *link;
        *link = static_cast<std::uint32_t>(ends_.size());
        ends_.push_back({t, face, solid, next});
    }

    enum class Answer { Nothing, Seen, Unclear };
    /// Unclear: rounding would decide, which ends of one place Evaluation tells apart.
    Answer nearest(std::size_t k, const Ray& ray, Crossing& out) const
    {
        if (first_[k] == kNone) return Answer::Nothing;
        const double reach = origin_reach(ray);
        for (std::uint32_t i = first_[k]; i != kNone; i = ends_[i].next) {
            const MergedEnd& end = ends_[i];
            const double apart = kApart * (std::abs(end.t) + reach);
            if (end.next != kNone && ends_[end.next].t - end.t <= apart) return Answer::Unclear;
            bool hidden = false;
            if (!find_hidden(end, ray, apart, hidden)) return Answer::Unclear;
            if (hidden) continue;
            const Node& node = program_.nodes[program_.merged[end.solid].node];
            out = {end.t, node.solid, end.face, node.normal_flipped, node.closed};
            return Answer::Seen;
        }
        return Answer::Nothing;
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffffu;
    /// Of two places so far apart, relative as kCoincidence, rounding does not say which comes first: that moves ends
    /// by a millionth of it.
    static constexpr double kApart = 1e-9;

    /// Whether another solid holds the place of an end. False: one of them ends there.
    bool find_hidden(const MergedEnd& end, const Ray& ray, double apart, bool& hidden) const
    {
        const glm::dvec3 at = ray.origin + end.t * ray.direction, step = apart * ray.direction;
        const double length = glm::length(step);
        for (std::uint32_t s = 0; s < program_.merged.size(); ++s) {
            const MergedSolid& other = program_.merged[s];
            if (s == end.solid || !other.comes_near(at, length)) continue;
            const PartId solid = program_.nodes[other.node].solid;
            const bool before = holds(store_, solid, false, at - step, true);
            if (before != holds(store_, solid, false, at + step, true)) return false;
            hidden = hidden || before;
        }
        return true;
    }

    const Program& program_;
    const SolidStore& store_;
    std::vector<MergedEnd>& ends_;
    std::array<std::uint32_t, kTileRays> first_;  ///< of a ray, the nearest; each leads to the next
};

}  // namespace csg
