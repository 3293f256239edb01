#include "render/solid/mesh/deviation.h"

#include "csg/base/cancel.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace solid {
namespace {

double distance2(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    // By the region of the triangle that is nearest (Ericson, Real-Time Collision Detection, 5.1.5).
    const glm::dvec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap), d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp),
                 d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    const auto square = [](const glm::dvec3& v) { return glm::dot(v, v); };
    if (d1 <= 0.0 && d2 <= 0.0) return square(ap);
    if (d3 >= 0.0 && d4 <= d3) return square(bp);
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return square(ap - d1 / (d1 - d3) * ab);
    if (d6 >= 0.0 && d5 <= d6) return square(cp);
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return square(ap - d2 / (d2 - d6) * ac);
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
        return square(bp - (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b));
    const double sum = 1.0 / (va + vb + vc);
    return square(ap - ab * (vb * sum) - ac * (vc * sum));
}

/// Triangles by the cells of a grid that their boxes meet.
class TriangleGrid {
public:
    TriangleGrid(const TriangleMesh& mesh, const csg::Aabb& box) : mesh_(mesh)
    {
        const glm::dvec3 size = box.upper - box.lower;
        const double longest = glm::max(size.x, glm::max(size.y, size.z));
        const double cells = std::clamp(std::sqrt(static_cast<double>(mesh.triangles.size()) / 3.0), 4.0, 160.0);
        step_ = longest / cells;
        origin_ = box.lower - 0.5 * step_;
        for (int k = 0; k < 3; ++k) count_[k] = static_cast<int>(size[k] / step_) + 2;
        const auto all = static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]) *
                         static_cast<std::size_t>(count_[2]);
        first_.assign(all + 1, 0);
        for (int pass = 0; pass < 2; ++pass) {
            for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
                glm::ivec3 low, high;
                range(i, low, high);
                for (int z = low.z; z <= high.z; ++z)
                    for (int y = low.y; y <= high.y; ++y)
                        for (int x = low.x; x <= high.x; ++x) {
                            const std::size_t cell = at(x, y, z);
                            if (pass == 0) ++first_[cell + 1];
                            else items_[first_[cell] + filled_[cell]++] = i;
                        }
            }
            if (pass != 0) break;
            for (std::size_t i = 0; i < all; ++i) first_[i + 1] += first_[i];
            items_.resize(first_[all]);
            filled_.assign(all, 0);
        }
    }

    double distance(const glm::dvec3& p) const
    {
        const glm::ivec3 here = cell(p);
        double best = numbers::kInfinity;
        const int most = std::max(count_[0], std::max(count_[1], count_[2]));
        const glm::dvec3 within = p - (origin_ + step_ * glm::dvec3(here));
        const double border = std::max(0.0, std::min(least(within), step_ - most_of(within)));
        for (int ring = 0; ring <= most; ++ring) {
            // What lies in rings beyond is farther than the room up to them.
            const double room = border + (ring - 1) * step_;
            if (ring > 0 && best <= room * room) break;
            for (int z = here.z - ring; z <= here.z + ring; ++z)
                for (int y = here.y - ring; y <= here.y + ring; ++y)
                    for (int x = here.x - ring; x <= here.x + ring; ++x) {
                        if (std::max(std::abs(x - here.x), std::max(std::abs(y - here.y), std::abs(z - here.z))) !=
                            ring)
                            continue;
                        if (x < 0 || y < 0 || z < 0 || x >= count_[0] || y >= count_[1] || z >= count_[2]) continue;
                        if (ring > 0 && room_to({x, y, z}, p) >= best) continue;
                        const std::size_t c = at(x, y, z);
                        for (std::size_t i = first_[c]; i < first_[c + 1]; ++i) {
                            const auto& t = mesh_.triangles[items_[i]];
                            best = std::min(
                                best, distance2(p, mesh_.vertices[t[0]], mesh_.vertices[t[1]], mesh_.vertices[t[2]]));
                        }
                    }
        }
        return std::sqrt(best);
    }

private:
    static double least(const glm::dvec3& v) { return glm::min(v.x, glm::min(v.y, v.z)); }
    static double most_of(const glm::dvec3& v) { return glm::max(v.x, glm::max(v.y, v.z)); }
    /// The square of the distance between a cell and a place.
    double room_to(const glm::ivec3& at, const glm::dvec3& p) const
    {
        const glm::dvec3 low = origin_ + step_ * glm::dvec3(at);
        const glm::dvec3 off = p - glm::clamp(p, low, low + step_);
        return glm::dot(off, off);
    }
    glm::ivec3 cell(const glm::dvec3& p) const
    {
        glm::ivec3 out;
        for (int k = 0; k < 3; ++k)
            out[k] = std::clamp(static_cast<int>(std::floor((p[k] - origin_[k]) / step_)), 0, count_[k] - 1);
        return out;
    }
    void range(std::uint32_t i, glm::ivec3& low, glm::ivec3& high) const
    {
        const auto& t = mesh_.triangles[i];
        const glm::dvec3 a = mesh_.vertices[t[0]], b = mesh_.vertices[t[1]], c = mesh_.vertices[t[2]];
        low = cell(glm::min(a, glm::min(b, c)));
        high = cell(glm::max(a, glm::max(b, c)));
    }
    std::size_t at(int x, int y, int z) const
    {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(count_[1]) + static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(count_[0]) +
               static_cast<std::size_t>(x);
    }
    const TriangleMesh& mesh_;
    double step_ = 1.0;
    glm::dvec3 origin_{0.0};
    int count_[3] = {1, 1, 1};
    std::vector<std::size_t> first_;
    std::vector<std::uint32_t> items_, filled_;
};

/// An upper bound of the distance of a place from the body's boundary: along the normal and the axes.
double off_body(const Body& body, const glm::dvec3& p, const glm::dvec3& normal, double reach, double wanted,
                std::vector<Chord>& chords)
{
    constexpr double kNear = 4.0;
    double best = reach;
    const auto look = [&](const glm::dvec3& along) {
        body.chords(p, along, -best, best, chords);
        for (const Chord& chord : chords)
            for (const End* end : {&chord.in, &chord.out})
                if (std::abs(end->t) < best) best = std::abs(end->t);
    };
    best = std::min(reach, kNear * wanted);  // mostly it is near, and a short part of a line is followed sooner
    look(normal);
    if (best < reach && best >= kNear * wanted) {
        best = reach;
        look(normal);
    }
    for (int axis = 0; axis < 3 && best > wanted; ++axis) {
        glm::dvec3 along(0.0);
        along[axis] = 1.0;
        look(along);
    }
    // Just beyond a sharp edge all of these may pass by: lines in all directions, evenly (the golden angle).
    constexpr int kLines = 160;
    for (int k = 0; k < kLines && best > wanted; ++k) {
        const double z = (k + 0.5) / kLines, around = 2.399963229728653 * k, r = std::sqrt(1.0 - z * z);
        look({r * std::cos(around), r * std::sin(around), z});
    }
    return best;
}

struct Worst {
    double most = 0.0, squares = 0.0;
    std::size_t count = 0;
    glm::dvec3 where{0.0};
    void add(double off, const glm::dvec3& p)
    {
        if (off > most) {
            most = off;
            where = p;
        }
        squares += off * off;
        ++count;
    }
    void add(const Worst& other)
    {
        if (other.most > most) {
            most = other.most;
            where = other.where;
        }
        squares += other.squares;
        count += other.count;
    }
    double rms() const { return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0.0; }
};

/// The sum over runs of indices, in order: the same whatever the threads.
template <class F>
Worst worst_of(std::size_t count, const std::atomic<bool>* cancel, F&& each)
{
    constexpr std::size_t kRun = 256;
    std::vector<Worst> parts((count + kRun - 1) / kRun);
    tbb::parallel_for(std::size_t(0), parts.size(), [&](std::size_t r) {
        if (cancel != nullptr && *cancel) throw csg::Cancelled();
        for (std::size_t i = r * kRun; i < std::min(count, (r + 1) * kRun); ++i) each(i, parts[r]);
    });
    Worst all;
    for (const Worst& part : parts) all.add(part);
    return all;
}

}  // namespace

Deviation deviation(const Body& body, const csg::Aabb& extent, const TriangleMesh& mesh, std::size_t most,
                    double wanted, const std::atomic<bool>* cancel)
{
    Deviation out;
    const double reach = glm::length(extent.upper - extent.lower);
    const std::size_t every = std::max<std::size_t>(1, mesh.triangles.size() / std::max<std::size_t>(1, most));
    const Worst of_mesh = worst_of(mesh.triangles.size() / every, cancel, [&](std::size_t i, Worst& worst) {
        thread_local std::vector<Chord> chords;
        const auto& t = mesh.triangles[i * every];
        const glm::dvec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
        const glm::dvec3 n = glm::cross(b - a, c - a);
        const double area = glm::length(n);
        const glm::dvec3 normal = area > 0.0 ? n / area : glm::dvec3(1, 0, 0);
        // A place within that depends on the triangle's number.
        const double u = static_cast<double>((i * 2654435761u) % 1024u) / 1024.0,
                     v = static_cast<double>((i * 40503u) % 1021u) / 1021.0;
        const double su = std::sqrt(u);
        for (const glm::dvec3& p : {(a + b + c) / 3.0, (1.0 - su) * a + su * (1.0 - v) * b + su * v * c, 0.5 * (a + b)})
            worst.add(off_body(body, p, normal, reach, 0.5 * wanted, chords), p);
    });
    out.from_mesh = of_mesh.most;
    out.from_mesh_rms = of_mesh.rms();
    csg::Aabb box = extent;
    for (const glm::vec3& v : mesh.vertices) box.include(glm::dvec3(v));
    const TriangleGrid grid(mesh, box);
    const auto rows = static_cast<std::size_t>(std::sqrt(static_cast<double>(most) / 3.0)) + 1;
    const Worst of_body = worst_of(3 * rows * rows, cancel, [&](std::size_t i, Worst& worst) {
        thread_local std::vector<Chord> chords;
        const int axis = static_cast<int>(i / (rows * rows)), u = (axis + 1) % 3, v = (axis + 2) % 3;
        const std::size_t in_grid = i % (rows * rows);
        const auto share = [&](std::size_t k, std::size_t key) {
            return (static_cast<double>(k) + static_cast<double>((key * 2654435761u) % 4093u) / 4093.0) /
                   static_cast<double>(rows);
        };
        glm::dvec3 p = extent.lower, along(0.0);
        along[axis] = 1.0;
        p[u] += (extent.upper - extent.lower)[u] * share(in_grid / rows, i);
        p[v] += (extent.upper - extent.lower)[v] * share(in_grid % rows, i + 7919);
        body.chords(p, along, -numbers::kInfinity, numbers::kInfinity, chords);
        for (const Chord& chord : chords)
            for (const End* end : {&chord.in, &chord.out}) {
                const glm::dvec3 q = p + end->t * along;
                worst.add(grid.distance(q), q);
            }
    });
    out.from_body = of_body.most;
    out.from_body_rms = of_body.rms();
    out.worst_of_body = of_body.where;
    out.samples = of_mesh.count + of_body.count;
    return out;
}

}  // namespace solid
