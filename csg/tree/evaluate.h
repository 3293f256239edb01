#pragma once

// Continues program.h: evaluation along one ray, inline, since each kernel has its own.
#include "csg/bvh/traverse.h"
#include "csg/mesh/mesh_query.h"
#include "csg/tree/face_held.h"
#include "csg/tree/node_box.h"

#include <algorithm>
#include <bit>
#include <optional>

namespace csg {

/// One query: a ray, the range in which crossings matter, and the scratch it works in.
class Evaluation {
public:
    Evaluation(const Program& program, const SolidStore& store, const Ray& ray, double t_min, double t_max,
               Scratch& scratch)
        : nodes_(program.nodes.data()), sieves_(program.sieves.data()), store_(store), ray_(ray),
          inverse_(1.0 / ray.direction), t_min_(t_min), t_max_(t_max), scratch_(scratch)
    {
        scratch.prepare(program);
        reach_ = origin_reach(ray);
        if (!program.sieves.empty()) slabs_.emplace(ray);
    }

    /// The nearest visible crossing of the whole program; t is infinite when there is none. Among equal ones the last
    /// generated, as in POV-Ray (spec 5a, 2.1 and 2.2).
    Crossing nearest() { return nearest(0); }

    /// Appends all visible crossings within range, in POV-Ray's order of generation, and returns them.
    std::pair<Crossing*, Crossing*> crossings()
    {
        visible(0);
        return {scratch_.crossings_.get(), scratch_.crossings_.get() + scratch_.crossing_top_};
    }

    /// The spans of the inside that meet the range; correct within the range only.
    SpanList inside()
    {
        SpanList out = list(nodes_[0].max_spans);
        spans(0, out);
        return out;
    }

private:
    using Record = Scratch::Record;

    SpanList list(std::uint32_t size)
    {
        SpanList made(scratch_.spans_.get() + scratch_.span_top_, size);
        scratch_.span_top_ += size;
        return made;
    }

    double slack(double t) const { return kCoincidence * (std::abs(t) + reach_); }

    /// Whether the ray meets the node's box within the range.
    bool meets(const Node& node) const { return meets_box(node, ray_, inverse_, t_min_, t_max_); }

    /// Calls f(operand) for the operands of node i, in order, until it returns false; some that cannot matter for this
    /// ray are left out.
    template <class F>
    void each_operand(std::uint32_t i, F&& f)
    {
        const Node& node = nodes_[i];
        if (node.first_sieve == node.last_sieve) {
            for (std::uint32_t k = i + 1; k < node.end; k = nodes_[k].end)
                if (!f(k)) return;
            return;
        }
        const float begin = rounded_down(t_min_), end = rounded_up(t_max_);
        for (std::uint32_t s = node.first_sieve; s < node.last_sieve; ++s) {
            alignas(32) float near[8];
            for (std::uint32_t met = slabs_->intersect(sieves_[s].bounds, begin, end, near); met != 0; met &= met - 1)
                if (!f(sieves_[s].node[std::countr_zero(met)])) return;
        }
    }

    /// All spans of a leaf, its part and conventions stamped on every end.
    void leaf_spans(const Node& node, SpanList& out)
    {
        with_solid(store_, node.solid, [&](const auto& solid) {
            using T = std::decay_t<decltype(solid)>;
            if constexpr (std::is_same_v<T, Triangle>) {
                out.clear();  // bounds nothing, inverted or not
            } else {
                if constexpr (std::is_same_v<T, Freeform>)
                    if (solid.surface()) return out.clear();
                // POV-Ray negates an inverted quadric's coefficients and normal: the normal stays (spec 5a, 2.5).
                const bool normal_flipped = node.inverted && !std::is_same_v<T, Quadric>;
                const bool closed = holds_surface(solid, node.inverted);
                if constexpr (std::is_same_v<T, Mesh>) {
                    solid.spans(ray_, node.inverted, out);
                } else if (!node.inverted) {
                    plain_spans(solid, out);
                } else {
                    constexpr std::uint32_t kMost = most_plain_spans<T>();
                    Span plain[kMost];
                    SpanList list(plain, kMost);
                    plain_spans(solid, list);
                    complement(list, out);
                }
                for (Span& span : out) {
                    span.in.part = span.out.part = node.solid;
                    span.in.inverted = span.out.inverted = normal_flipped;
                    span.in.closed = span.out.closed = closed;
                }
            }
        });
    }

    template <class T>
    void plain_spans(const T& solid, SpanList& out) const
    {
        if constexpr (std::is_same_v<T, Freeform>) {
            if (!scratch_.fetched.spans(&solid, t_min_, t_max_, out)) solid.spans(ray_, t_min_, t_max_, out);
        } else if constexpr (std::is_same_v<T, Extrusion>) {
            // Wider than what coincides with an end of the range.
            solid.each_span(
                ray_,
                [&](double in, std::uint32_t in_face, double end, std::uint32_t end_face) {
                    out.push({{.t = in, .face = in_face}, {.t = end, .face = end_face}});
                },
                t_min_ - 2.0 * slack(t_min_), t_max_ + 2.0 * slack(t_max_));
        } else {
            intersect(solid, ray_, out);
        }
    }

    /// Whether the leaf may draw where it has no span.
    bool drawn_without_span(const Node& node) const
    {
        const SolidKind kind = kind_of(node.solid);
        return kind == SolidKind::Triangle || kind == SolidKind::Mesh ||
               (kind == SolidKind::Freeform && store_.all<Freeform>()[index_of(node.solid)].reports_touches());
    }

    void add(const Crossing& crossing)
    {
        if (crossing.drawn() && crossing.t >= t_min_ && crossing.t <= t_max_)
            scratch_.crossings_[scratch_.crossing_top_++] = crossing;
    }

    /// What a leaf draws: the ends of its spans, and what has no span to end.
    void leaf_crossings(const Node& node, const SpanList& spans)
    {
        if (kind_of(node.solid) == SolidKind::Mesh) return mesh_crossings(node);
        for (const Span& span : spans) {
            add(span.in);
            add(span.out);
        }
        if (kind_of(node.solid) == SolidKind::Triangle) {
            double t = 0.0;
            if (store_.all<Triangle>()[index_of(node.solid)].crossing(ray_, t))
                add({.t = t, .part = node.solid});  // a patch ignores inversion
        } else if (kind_of(node.solid) == SolidKind::Freeform) {
            const Freeform& freeform = store_.all<Freeform>()[index_of(node.solid)];
            if (!freeform.reports_touches()) return;
            IntersectionList record(t_min_, t_max_, false);
            freeform.intersect(ray_, record);
            const bool normal_flipped = node.inverted && !freeform.surface();  // a patch ignores inversion
            record.each_touching([&](double t, std::uint32_t face) {
                add({.t = t, .part = node.solid, .face = face, .inverted = normal_flipped});
            });
        } else if (kind_of(node.solid) == SolidKind::Torus) {
            const Torus& torus = store_.all<Torus>()[index_of(node.solid)];
            double t[2];
            const int n = spans.empty() ? 0 : torus.inner_sheet(ray_, t);
            for (int i = 0; i < n; ++i) add({.t = t[i], .part = node.solid, .inverted = node.inverted, .closed = true});
        }
    }

    /// Every face is drawn, whether it bounds a span or not.
    void mesh_crossings(const Node& node)
    {
        const Mesh& mesh = store_.all<Mesh>()[index_of(node.solid)];
        std::uint32_t left = mesh.most_crossings();
        csg::mesh_crossings(
            *mesh.shape, local_ray(mesh.frame, ray_), t_min_, t_max_, [&](double t, std::uint32_t face) {
                add({.t = t, .part = node.solid, .face = face, .inverted = node.inverted, .closed = !node.inverted});
                return --left > 0 ? t_max_ : -kInfinity;
            });
    }

    /// Inside spans of node i into `out`, which is empty and holds max_spans of it.
    void spans(std::uint32_t i, SpanList& out)
    {
        const Node& node = nodes_[i];
        if (!meets(node)) {
            if (node.inside_beyond) out.push(Span::everything());
            return;
        }
        if (node.op == Op::Leaf) {
            leaf_spans(node, out);
            return;
        }
        if (node.op == Op::Guard) return spans(i + 1, out);  // what is inside does not depend on the ray
        const bool both = node.op == Op::Intersection || node.op == Op::Clip;
        const std::uint32_t mark = scratch_.span_top_;
        SpanList sum = out, next = list(node.max_spans), operand = list(node.max_spans);
        SpanList* from = &sum;
        SpanList* to = &next;
        bool first = true;
        from->clear();
        each_operand(i, [&](std::uint32_t k) {
            operand.clear();
            spans(k, operand);
            if (first) {
                for (const Span& span : operand) from->push(span);
            } else if (both) {
                intersect(*from, operand, *to);
                std::swap(from, to);
            } else if (!operand.empty()) {
                unite(*from, operand, *to);
                std::swap(from, to);
            }
            first = false;
            return !both || !from->empty();
        });
        if (both && first) from->push(Span::everything());
        out.clear();
        if (from != &sum)
            for (const Span& span : *from) out.push(span);
        else out = sum;
        scratch_.span_top_ = mark;
    }

    /// Appends the visible crossings of node i. False when an intersection was found to be empty here, so that the
    /// operator above may stop: then nothing is appended.
    bool visible(std::uint32_t i)
    {
        const Node& node = nodes_[i];
        if (!meets(node)) return node.inside_beyond;
        if (node.op == Op::Leaf) {
            const std::uint32_t mark = scratch_.span_top_;
            SpanList own = list(node.max_spans);
            leaf_spans(node, own);
            leaf_crossings(node, own);
            scratch_.span_top_ = mark;
            return true;
        }
        if (node.op == Op::Union) {
            each_operand(i, [&](std::uint32_t k) {
                visible(k);
                return true;
            });
            return true;
        }
        if (node.op == Op::Guard) return !passes_guard(i) || visible(i + 1);
        return filtered(i);
    }

    /// Whether the ray meets every bound of a guard, however far, or starts inside of it.
    bool passes_guard(std::uint32_t i)
    {
        const double given = t_max_;
        t_max_ = kInfinity;
        bool all = true;
        for (std::uint32_t k = nodes_[i + 1].end; k < nodes_[i].end && all; k = nodes_[k].end) {
            const std::uint32_t span_mark = scratch_.span_top_, crossing_mark = scratch_.crossing_top_;
            SpanList within = list(nodes_[k].max_spans);
            spans(k, within);
            bool met = false;
            for (const Span& span : within) met = met || span.out.t >= t_min_;
            if (!met) {  // where there is no inside, it is drawn all the same
                visible(k);
                met = scratch_.crossing_top_ > crossing_mark;
                scratch_.crossing_top_ = crossing_mark;
            }
            scratch_.span_top_ = span_mark;
            all = met;
        }
        t_max_ = given;
        return all;
    }

    /// Merge, intersection and clip: each operand's crossings, in reverse (spec 5a, 2.2), kept where the inside spans
    /// of every other operand say so.
    bool filtered(std::uint32_t i)
    {
        const Node& node = nodes_[i];
        const bool inside = node.op != Op::Merge;
        const std::uint32_t span_mark = scratch_.span_top_, record_mark = scratch_.record_top_,
                            crossing_mark = scratch_.crossing_top_;
        bool possible = true;
        each_operand(i, [&](std::uint32_t k) {
            Record& record = scratch_.records_[scratch_.record_top_++];
            record = Record{};
            record.node = k;
            record.first = scratch_.crossing_top_;
            if (node.op == Op::Clip && k != i + 1) {
                record.last = record.first;  // a clip is not drawn
                return true;
            }
            possible = operand_crossings(k, record, node.op == Op::Intersection);
            record.last = scratch_.crossing_top_;
            std::reverse(scratch_.crossings_.get() + record.first, scratch_.crossings_.get() + record.last);
            return possible;
        });
        if (!possible) scratch_.crossing_top_ = crossing_mark;
        const std::uint32_t record_end = scratch_.record_top_;
        std::uint32_t left = scratch_.crossing_top_ - crossing_mark;
        for (std::uint32_t r = record_mark; r < record_end && left > 0; ++r)
            left = keep_where(scratch_.records_[r], crossing_mark, inside);
        if (left > 0) compact(crossing_mark);
        else scratch_.crossing_top_ = crossing_mark;
        scratch_.span_top_ = span_mark;
        scratch_.record_top_ = record_mark;
        return possible;
    }

    /// Crossings of operand k; a leaf's spans are kept for keep_where. False: nothing can be inside every operand.
    bool operand_crossings(std::uint32_t k, Record& record, bool stop_if_empty)
    {
        const Node& node = nodes_[k];
        if (node.op != Op::Leaf) return visible(k) || !stop_if_empty;
        if (!meets(node)) return node.inside_beyond || !stop_if_empty;
        record.spans = list(node.max_spans);
        record.known = true;
        leaf_spans(node, record.spans);
        leaf_crossings(node, record.spans);
        return !stop_if_empty || !record.spans.empty() || drawn_without_span(node);
    }

    /// Drops the crossings from `first` on that do not belong to the operand and are not inside (or not outside) it.
    /// Dropped ones become NaN; returns how many are left.
    std::uint32_t keep_where(Record& own, std::uint32_t first, bool inside)
    {
        Crossing* all = scratch_.crossings_.get();
        std::uint32_t left = 0;
        for (std::uint32_t c = first; c < scratch_.crossing_top_; ++c) {
            if (!(all[c].t == all[c].t)) continue;
            if (c >= own.first && c < own.last) {
                ++left;
                continue;
            }
            if (!own.known) {
                own.spans = list(nodes_[own.node].max_spans);
                spans(own.node, own.spans);
                own.known = true;
            }
            const auto holds = [&](const Crossing& end) { return holds_end(store_, ray_, end, all[c]); };
            if (own.spans.contains(all[c].t, slack(all[c].t), holds) == inside) ++left;
            else all[c].t = std::numeric_limits<double>::quiet_NaN();
        }
        return left;
    }

    /// Closes the gaps that keep_where left.
    void compact(std::uint32_t first)
    {
        Crossing* all = scratch_.crossings_.get();
        std::uint32_t kept = first;
        for (std::uint32_t c = first; c < scratch_.crossing_top_; ++c)
            if (all[c].t == all[c].t) all[kept++] = all[c];
        scratch_.crossing_top_ = kept;
    }

    Crossing nearest(std::uint32_t i)
    {
        Crossing best{.t = kInfinity};
        const Node& node = nodes_[i];
        if (node.op == Op::Union) {
            if (!meets(node)) return best;
            const double given = t_max_;
            each_operand(i, [&](std::uint32_t k) {
                const Crossing found = nearest(k);
                if (!(found.t <= best.t) || found.part == kNoPart) return true;
                best = found;
                t_max_ = found.t;  // nothing beyond it matters
                return true;
            });
            t_max_ = given;
            return best;
        }
        const std::uint32_t mark = scratch_.crossing_top_;
        visible(i);
        for (std::uint32_t c = mark; c < scratch_.crossing_top_; ++c)
            if (scratch_.crossings_[c].t <= best.t) best = scratch_.crossings_[c];
        scratch_.crossing_top_ = mark;
        return best;
    }

    const Node* nodes_;
    const OperandSieve* sieves_;
    const SolidStore& store_;
    std::optional<RaySlabs> slabs_;  ///< where there are sieves
    const Ray ray_;
    const glm::dvec3 inverse_;
    double t_min_, t_max_;
    double reach_ = 0.0;  ///< size of the origin, in units of the parameter
    Scratch& scratch_;
};

}  // namespace csg
