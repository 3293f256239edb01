#include "render/solid/remesh/half_edges.h"

#include <algorithm>
#include <map>
#include <utility>

namespace solid {

bool HalfEdges::take(const TriangleMesh& mesh)
{
    places.assign(mesh.vertices.begin(), mesh.vertices.end());
    facing.assign(mesh.triangles.size(), glm::dvec3(0.0));
    alive_ = mesh.triangles.size();
    tails_.clear();
    for (const auto& t : mesh.triangles) tails_.insert(tails_.end(), t.begin(), t.end());
    twins_.assign(tails_.size(), kNone);
    sharp_.assign(tails_.size(), 0);
    outs_.assign(places.size(), kNone);
    std::vector<std::pair<std::uint64_t, Index>> sides;
    sides.reserve(tails_.size());
    for (Index h = 0; h < tails_.size(); ++h) {
        const std::uint64_t a = tail(h), b = head(h);
        sides.emplace_back(std::min(a, b) << 32 | std::max(a, b), h);
        outs_[tail(h)] = h;
    }
    std::sort(sides.begin(), sides.end());
    if (sides.size() % 2 != 0) return false;
    for (std::size_t i = 0; i < sides.size(); i += 2) {
        const Index a = sides[i].second, b = sides[i + 1].second;
        if (sides[i].first != sides[i + 1].first || tail(a) != head(b)) return false;
        if (i + 2 < sides.size() && sides[i].first == sides[i + 2].first) return false;
        join(a, b);
    }
    return true;
}

TriangleMesh HalfEdges::mesh() const
{
    TriangleMesh out;
    std::vector<Index> number(places.size(), kNone);
    for (Index f = 0; f < triangles(); ++f) {
        if (!has_triangle(f)) continue;
        std::array<std::uint32_t, 3> t{};
        for (Index k = 0; k < 3; ++k) {
            const Index v = tails_[3 * f + k];
            if (number[v] == kNone) {
                number[v] = static_cast<Index>(out.vertices.size());
                out.vertices.push_back(glm::vec3(places[v]));
            }
            t[k] = number[v];
        }
        out.triangles.push_back(t);
    }
    return out;
}

int HalfEdges::neighbours(Index v) const
{
    int count = 0;
    each_out(v, [&](Index) { ++count; });
    return count;
}

bool HalfEdges::can_flip(Index h) const
{
    const Index w = tail(before(h)), x = tail(before(twin(h)));
    if (w == x || neighbours(tail(h)) <= 3 || neighbours(head(h)) <= 3) return false;
    bool joined = false;
    each_out(w, [&](Index o) { joined = joined || head(o) == x; });
    return !joined;
}

void HalfEdges::flip(Index h)
{
    const Index t = twin(h), hn = next(h), hp = before(h), tn = next(t), tp = before(t);
    const Index u = tail(h), v = head(h), w = tail(hp), x = tail(tp);
    const Index of_hn = twin(hn), of_hp = twin(hp), of_tn = twin(tn), of_tp = twin(tp);
    const std::uint8_t s_hn = sharp_[hn], s_hp = sharp_[hp], s_tn = sharp_[tn], s_tp = sharp_[tp];
    // x -> w -> u and w -> x -> v.
    tails_[h] = x, tails_[hn] = w, tails_[hp] = u;
    tails_[t] = w, tails_[tn] = x, tails_[tp] = v;
    join(hn, of_hp), join(hp, of_tn), join(tn, of_tp), join(tp, of_hn);
    sharp_[hn] = s_hp, sharp_[hp] = s_tn, sharp_[tn] = s_tp, sharp_[tp] = s_hn;
    sharp_[h] = sharp_[t] = 0;
    outs_[x] = h, outs_[w] = t, outs_[u] = hp, outs_[v] = tp;
}

HalfEdges::Index HalfEdges::split(Index h, const glm::dvec3& place)
{
    const Index t = twin(h), hn = next(h), tn = next(t);
    const Index u = tail(h), v = head(h), w = tail(before(h)), x = tail(before(t));
    const Index of_hn = twin(hn), of_tn = twin(tn);
    const std::uint8_t s_h = sharp_[h], s_hn = sharp_[hn], s_tn = sharp_[tn];
    const auto m = static_cast<Index>(places.size());
    const auto f = static_cast<Index>(tails_.size()), g = f + 3;  // m v w and m u x
    places.push_back(place);
    tails_.insert(tails_.end(), {m, v, w, m, u, x});
    twins_.resize(tails_.size());
    sharp_.resize(tails_.size());
    facing.push_back(facing[h / 3]);
    facing.push_back(facing[t / 3]);
    tails_[hn] = tails_[tn] = m;
    join(h, g), join(t, f), join(hn, f + 2), join(tn, g + 2), join(f + 1, of_hn), join(g + 1, of_tn);
    sharp_[f] = sharp_[g] = s_h;
    sharp_[hn] = sharp_[tn] = sharp_[f + 2] = sharp_[g + 2] = 0;
    sharp_[f + 1] = s_hn, sharp_[g + 1] = s_tn;
    outs_.push_back(f);
    outs_[u] = h, outs_[v] = t, outs_[w] = f + 2, outs_[x] = g + 2;
    alive_ += 2;
    return m;
}

bool HalfEdges::can_collapse(Index h) const
{
    const Index u = tail(h), v = head(h), w = tail(before(h)), x = tail(before(twin(h)));
    if (w == x || neighbours(w) <= 3 || neighbours(x) <= 3) return false;
    int common = 0;
    each_out(u, [&](Index o) { each_out(v, [&](Index p) { common += head(o) == head(p) ? 1 : 0; }); });
    return common == 2;
}

void HalfEdges::collapse(Index h)
{
    const Index t = twin(h), u = tail(h), v = head(h);
    const Index a = twin(next(h)), b = twin(before(h)), c = twin(next(t)), d = twin(before(t));
    const Index w = tail(a), x = tail(c);
    std::vector<Index> outs;
    each_out(u, [&](Index o) { outs.push_back(o); });
    for (const Index o : outs) tails_[o] = v;
    join(a, b), join(c, d);
    sharp_[a] = sharp_[b] = sharp_[a] | sharp_[b];
    sharp_[c] = sharp_[d] = sharp_[c] | sharp_[d];
    for (const Index first : {h - h % 3, t - t % 3}) tails_[first] = tails_[first + 1] = tails_[first + 2] = kNone;
    alive_ -= 2;
    outs_[u] = kNone;
    outs_[v] = b, outs_[w] = a, outs_[x] = c;
}


void HalfEdges::add_vertex(const glm::dvec3& place)
{
    places.push_back(place);
    outs_.push_back(kNone);
}

HalfEdges::Index HalfEdges::replace(const std::vector<Index>& old, const std::vector<std::array<Index, 3>>& made,
                                    const std::vector<glm::dvec3>& looks)
{
    using Ends = std::pair<Index, Index>;
    std::map<Ends, Index> about, within;  // half-edges that wait for their twin
    for (const Index f : old)
        for (Index h = 3 * f; h < 3 * f + 3; ++h) about[{tail(h), head(h)}] = twin(h);
    for (const Index f : old)
        for (Index h = 3 * f; h < 3 * f + 3; ++h) outs_[tails_[h]] = kNone;
    for (const Index f : old) tails_[3 * f] = tails_[3 * f + 1] = tails_[3 * f + 2] = kNone;
    const auto first = static_cast<Index>(triangles());
    for (std::size_t i = 0; i < made.size(); ++i) {
        const auto f = static_cast<Index>(tails_.size());
        tails_.insert(tails_.end(), made[i].begin(), made[i].end());
        twins_.resize(tails_.size(), kNone);
        sharp_.resize(tails_.size(), 0);
        facing.push_back(looks[i]);
        for (Index h = f; h < f + 3; ++h) {
            outs_[tail(h)] = h;
            if (const auto own = about.find({tail(h), head(h)}); own != about.end() && has_triangle(own->second / 3)) {
                sharp_[h] = sharp_[own->second];
                join(h, own->second);
            } else if (const auto other = within.find({head(h), tail(h)}); other != within.end()) {
                join(h, other->second);
            } else {
                within[{tail(h), head(h)}] = h;
            }
        }
    }
    alive_ = alive_ + made.size() - old.size();
    return first;
}

}  // namespace solid
