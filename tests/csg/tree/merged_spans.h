#pragma once

#include "csg/tree/program.h"

#include <algorithm>
#include <vector>

/// The law that evaluation is held to: spans of whole operands are merged, and each crossing is held against those of
/// every other operand. No boxes, no order, nothing left out.
namespace csg_test {

class MergedSpans {
public:
    MergedSpans(const csg::Program& program, const csg::SolidStore& store, const csg::Ray& ray)
        : nodes_(program.nodes), store_(store), ray_(ray), reach_(csg::origin_reach(ray))
    {}

    /// What is drawn, in POV-Ray's order of generation.
    std::vector<csg::Crossing> crossings(double t_min, double t_max)
    {
        std::vector<csg::Crossing> out = nodes_.empty() ? std::vector<csg::Crossing>{} : drawn(0, t_min);
        std::erase_if(out, [&](const csg::Crossing& c) { return !(c.t >= t_min && c.t <= t_max); });
        return out;
    }

    csg::Crossing nearest(double t_min, double t_max)
    {
        csg::Crossing best{.t = numbers::kInfinity};
        for (const csg::Crossing& c : crossings(t_min, t_max))
            if (c.t <= best.t) best = c;
        return best;
    }

    std::vector<csg::Span> inside() { return nodes_.empty() ? std::vector<csg::Span>{} : inside(0); }

private:
    using Spans = std::vector<csg::Span>;
    using Crossings = std::vector<csg::Crossing>;

    static csg::SpanList listed(Spans& memory, const Spans& from)
    {
        memory.resize(from.size() + 1);
        csg::SpanList list(memory.data(), static_cast<std::uint32_t>(memory.size()));
        for (const csg::Span& span : from) list.push(span);
        return list;
    }

    template <class Merge>
    static Spans merged(const Spans& a, const Spans& b, Merge&& merge)
    {
        Spans first, second, memory(a.size() + b.size() + 1);
        csg::SpanList out(memory.data(), static_cast<std::uint32_t>(memory.size()));
        merge(listed(first, a), listed(second, b), out);
        return {out.begin(), out.end()};
    }

    Spans leaf(const csg::Node& node)
    {
        Spans memory(node.max_spans + 1), other(node.max_spans + 2);
        csg::SpanList plain(memory.data(), node.max_spans), turned(other.data(), node.max_spans + 2);
        const bool turn = node.inverted && csg::kind_of(node.solid) != csg::SolidKind::Mesh;
        bool bounds = true;
        csg::with_solid(store_, node.solid, [&](const auto& solid) {
            using T = std::decay_t<decltype(solid)>;
            if constexpr (std::is_same_v<T, csg::Mesh>) solid.spans(ray_, node.inverted, plain);
            else if constexpr (std::is_same_v<T, csg::Triangle>) bounds = false;
            else if constexpr (std::is_same_v<T, csg::Freeform>) {
                bounds = !solid.surface();
                if (bounds) solid.spans(ray_, -numbers::kInfinity, numbers::kInfinity, plain);
            } else csg::intersect(solid, ray_, plain);
        });
        if (turn && bounds) csg::complement(plain, turned);
        Spans out(turn && bounds ? turned.begin() : plain.begin(), turn && bounds ? turned.end() : plain.end());
        for (csg::Span& span : out) {
            span.in.part = span.out.part = node.solid;
            span.in.inverted = span.out.inverted = node.normal_flipped;
            span.in.closed = span.out.closed = node.closed;
        }
        return out;
    }

    Spans inside(std::uint32_t i)
    {
        const csg::Node& node = nodes_[i];
        if (node.op == csg::Op::Leaf) return leaf(node);
        if (node.op == csg::Op::Guard) return inside(i + 1);
        const bool both = node.op == csg::Op::Intersection || node.op == csg::Op::Clip;
        Spans sum = both ? Spans{csg::Span::everything()} : Spans{};
        bool first = true;
        for (std::uint32_t k = i + 1; k < node.end; k = nodes_[k].end) {
            const Spans operand = inside(k);
            if (first) sum = operand;
            else if (both)
                sum = merged(sum, operand, [](const auto& a, const auto& b, auto& out) { csg::intersect(a, b, out); });
            else sum = merged(sum, operand, [](const auto& a, const auto& b, auto& out) { csg::unite(a, b, out); });
            first = false;
        }
        return sum;
    }

    Crossings drawn(std::uint32_t i, double t_min)
    {
        const csg::Node& node = nodes_[i];
        Crossings out;
        if (node.op == csg::Op::Leaf) {
            if (csg::kind_of(node.solid) != csg::SolidKind::Mesh)
                for (const csg::Span& span : leaf(node)) out.insert(out.end(), {span.in, span.out});
            if (node.draws_alone && (!out.empty() || csg::kind_of(node.solid) != csg::SolidKind::Torus))
                csg::each_touch_of(store_, node.solid, ray_, -numbers::kInfinity, numbers::kInfinity,
                                   [&](double t, std::uint32_t face) {
                                       out.push_back({t, node.solid, face, node.normal_flipped, node.closed});
                                   });
            std::erase_if(out, [](const csg::Crossing& c) { return !c.drawn(); });
            return out;
        }
        if (node.op == csg::Op::Guard) {
            for (std::uint32_t k = nodes_[i + 1].end; k < node.end; k = nodes_[k].end) {
                const Spans within = inside(k);
                const Crossings seen = drawn(k, t_min);
                const auto ahead = [&](const csg::Crossing& c) { return c.t >= t_min; };
                if (std::none_of(within.begin(), within.end(), [&](const csg::Span& s) { return ahead(s.out); }) &&
                    std::none_of(seen.begin(), seen.end(), ahead))
                    return {};
            }
            return drawn(i + 1, t_min);
        }
        for (std::uint32_t k = i + 1; k < node.end; k = nodes_[k].end) {
            if (node.op == csg::Op::Clip && k != i + 1) break;
            Crossings own = drawn(k, t_min);
            if (node.op != csg::Op::Union) {
                if (node.op != csg::Op::Clip) std::reverse(own.begin(), own.end());
                for (std::uint32_t other = i + 1; other < node.end; other = nodes_[other].end)
                    if (other != k) keep(own, inside(other), node.op != csg::Op::Merge);
            }
            out.insert(out.end(), own.begin(), own.end());
        }
        return out;
    }

    void keep(Crossings& own, const Spans& other, bool within) const
    {
        Spans memory;
        const csg::SpanList list = listed(memory, other);
        std::erase_if(own, [&](const csg::Crossing& c) {
            return list.contains(c.t, csg::kCoincidence * (std::abs(c.t) + reach_), [&](const csg::Crossing& end) {
                return csg::holds_end(store_, ray_, end, c);
            }) != within;
        });
    }

    const std::vector<csg::Node>& nodes_;
    const csg::SolidStore& store_;
    const csg::Ray ray_;
    double reach_;
};

}  // namespace csg_test
