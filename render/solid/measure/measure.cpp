#include "render/solid/measure/measure.h"

#include "csg/base/cancel.h"
#include "render/solid/measure/jitter.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace solid {
namespace {

constexpr int kRuns = 8;                // independent estimates whose scatter tells the error
constexpr double kStudent = 5.408;      // 99.9 % of Student's t with kRuns - 1 degrees of freedom
constexpr std::uint64_t kOfTask = 256;  // rays
constexpr double kFalls = 0.75;         // errors fall with this power of the number of rays where outlines are curved
constexpr double kSpare = 1.2;          // as errors are themselves known to a quarter or so
constexpr int kMostClimb = 3;           // steps at once: few rays tell errors badly, and smooth ones fall faster
constexpr int kExtentCells = 64, kExtentSteps = 40;

/// Moments of order 0, 1 and 2, and the surface.
struct Sums {
    double volume = 0.0, surface = 0.0;
    glm::dvec3 first{0.0};
    glm::dvec3 square{0.0};   // of x x, y y, z z
    glm::dvec3 product{0.0};  // of y z, z x, x y
    void add(const Sums& s)
    {
        volume += s.volume;
        surface += s.surface;
        first += s.first;
        square += s.square;
        product += s.product;
    }
    Sums scaled(double by) const { return {by * volume, by * surface, by * first, by * square, by * product}; }
};

glm::dvec3 unit(int axis)
{
    glm::dvec3 d(0.0);
    d[axis] = 1.0;
    return d;
}

/// How many rays a run sends along an axis: Fibonacci's numbers from 987 on.
class Ladder {
public:
    std::uint64_t rays() const { return rays_; }
    std::uint64_t step() const { return before_; }
    /// Of all runs along all axes.
    std::uint64_t all() const { return 3 * kRuns * rays_; }
    void climb()
    {
        const std::uint64_t sum = rays_ + before_;
        before_ = rays_;
        rays_ = sum;
    }

private:
    std::uint64_t rays_ = 987, before_ = 610;
};

/// Rays that are sent together, and what they met.
struct Tile {
    csg::LineTile lines;
    csg::ChordTile chords;
};

/// Of a line through p along an axis.
void add_chord(const Body& body, const glm::dvec3& p, int axis, const Chord& chord, Sums& sums)
{
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double a = p[u], b = p[v], lo = p[axis] + chord.in.t, hi = p[axis] + chord.out.t, length = hi - lo;
    const double middle = 0.5 * (lo + hi), one = length * middle;
    sums.volume += length;
    sums.first[axis] += one;
    sums.first[u] += length * a;
    sums.first[v] += length * b;
    sums.square[axis] += length * (middle * middle + length * length / 12.0);
    sums.square[u] += length * a * a;
    sums.square[v] += length * b * b;
    sums.product[axis] += length * a * b;  // of the other two
    sums.product[v] += one * a;
    sums.product[u] += one * b;
    for (const End* end : {&chord.in, &chord.out}) {
        const glm::dvec3 n = body.normal(p + end->t * unit(axis), *end);
        sums.surface += std::abs(n[axis]);  // 1 / |n| of area, by the share n * n that this axis has in it
    }
}

/// Some rays along one axis, in the places of Fibonacci's lattice, which a run shifts by random amounts.
Sums some_rays(const Body& body, const csg::Aabb& box, int axis, int run, const Ladder& ladder, std::uint64_t first,
               Tile& tile)
{
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const glm::dvec3 size = box.upper - box.lower, direction = unit(axis);
    const std::uint64_t rays = ladder.rays(), last = std::min(rays, first + kOfTask);
    const std::uint64_t key = (static_cast<std::uint64_t>(axis * kRuns + run) << 32U) + 2U * rays;
    const double right = jitter(key), up = jitter(key + 1), one_of = 1.0 / static_cast<double>(rays);
    const auto place = [&](std::uint64_t k, double shift) {
        const double x = static_cast<double>(k) * one_of + shift;
        return x < 1.0 ? x : x - 1.0;
    };
    Sums sums;
    for (std::uint64_t start = first; start < last; start += csg::kTileRays) {
        tile.lines.count = 0;
        for (std::uint64_t i = start; i < std::min<std::uint64_t>(last, start + csg::kTileRays); ++i) {
            glm::dvec3 p = box.lower;
            p[u] += size[u] * place(i, right);
            p[v] += size[v] * place(i * ladder.step() % rays, up);
            tile.lines.add({p, direction}, -numbers::kInfinity, numbers::kInfinity);
        }
        body.lines().chords(tile.lines, tile.chords);
        for (std::size_t k = 0; k < tile.lines.count; ++k)
            for (const Chord& chord : tile.chords[k]) add_chord(body, tile.lines.lines[k].origin, axis, chord, sums);
    }
    return sums.scaled(size[u] * size[v] * one_of);
}

struct Estimate {
    std::array<std::array<Sums, 3>, kRuns> of;  // by run and axis
    Sums run(int r) const
    {
        const auto& a = of[static_cast<std::size_t>(r)];
        Sums s = a[0];
        s.add(a[1]);
        s.add(a[2]);
        Sums mean = s.scaled(1.0 / 3.0);
        mean.surface = s.surface;  // the axes have shares of it
        return mean;
    }
};

Estimate estimate(const Body& body, const csg::Aabb& box, const Ladder& ladder, const std::atomic<bool>* cancel)
{
    const std::size_t tasks = (ladder.rays() + kOfTask - 1) / kOfTask;
    std::vector<Sums> parts(3 * kRuns * tasks);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, parts.size()), [&](const auto& range) {
        const auto tile = std::make_unique<Tile>();
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            if (cancel != nullptr && *cancel) throw csg::Cancelled();
            const int k = static_cast<int>(i / tasks);
            parts[i] = some_rays(body, box, k % 3, k / 3, ladder, i % tasks * kOfTask, *tile);
        }
    });
    Estimate out;
    for (std::size_t i = 0; i < parts.size(); ++i)  // in order: the same sum whatever the threads
        out.of[i / tasks / 3][i / tasks % 3].add(parts[i]);
    return out;
}

/// Mean over the runs, and what it may be off by.
template <class F>
Bounded mean_of(const Estimate& estimate, F&& number)
{
    double sum = 0.0, squares = 0.0;
    for (int r = 0; r < kRuns; ++r) sum += number(estimate.run(r));
    const double mean = sum / kRuns;
    for (int r = 0; r < kRuns; ++r) {
        const double off = number(estimate.run(r)) - mean;
        squares += off * off;
    }
    const double deviation = std::sqrt(squares / (kRuns - 1));
    return {mean, kStudent * deviation / std::sqrt(static_cast<double>(kRuns)) + 1e-12 * std::abs(mean)};
}

void fill(const Estimate& found, Measures& out)
{
    out.volume = mean_of(found, [](const Sums& s) { return s.volume; });
    out.surface = mean_of(found, [](const Sums& s) { return s.surface; });
    for (int axis = 0; axis < 3; ++axis) {
        const Bounded c = mean_of(found, [&](const Sums& s) { return s.first[axis] / s.volume; });
        out.centre[axis] = c.value;
        out.centre_error[axis] = c.error;
    }
    out.inertia_error = 0.0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const Bounded entry = mean_of(found, [&](const Sums& s) {
                const glm::dvec3 c = s.first / s.volume;
                const int k = (i + 1) % 3, l = (i + 2) % 3;
                if (i == j) return s.square[k] + s.square[l] - s.volume * (c[k] * c[k] + c[l] * c[l]);
                return -(s.product[3 - i - j] - s.volume * c[i] * c[j]);
            });
            out.inertia[j][i] = entry.value;
            out.inertia_error = std::max(out.inertia_error, entry.error);
        }
}

/// The place of a side that was met outermost, and the box about it in which rays are sent next.
struct Outermost {
    double at = 0.0;
    glm::dvec3 point{0.0};
};

void look(const Body& body, const glm::dvec3& p, int axis, csg::Aabb& box, std::array<Outermost, 6>& far,
          std::vector<Chord>& chords)
{
    const glm::dvec3 direction = unit(axis);
    body.chords(p, direction, -numbers::kInfinity, numbers::kInfinity, chords);
    for (const Chord& chord : chords)
        for (const End* end : {&chord.in, &chord.out}) {
            const glm::dvec3 q = p + end->t * direction;
            for (int side = 0; side < 3; ++side) {
                if (q[side] < box.lower[side]) {
                    box.lower[side] = q[side];
                    far[static_cast<std::size_t>(2 * side)] = {q[side], q};
                }
                if (q[side] > box.upper[side]) {
                    box.upper[side] = q[side];
                    far[static_cast<std::size_t>(2 * side + 1)] = {q[side], q};
                }
            }
        }
}

}  // namespace

csg::Aabb met_extent(const Body& body, int cells, double& error, std::uint64_t& rays)
{
    csg::Aabb box;
    std::array<Outermost, 6> far;
    std::vector<Chord> chords;
    const csg::Aabb around = body.bounds();
    const glm::dvec3 size = around.upper - around.lower;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int j = 0; j < cells; ++j)
            for (int i = 0; i < cells; ++i) {
                glm::dvec3 p = around.lower;
                // Not quite in the middle: what is symmetric has its seams there.
                p[u] += size[u] * (i + 0.5037) / cells;
                p[v] += size[v] * (j + 0.4961) / cells;
                look(body, p, axis, box, far, chords);
            }
    }
    rays += static_cast<std::uint64_t>(3 * cells * cells);
    error = 0.0;
    if (box.empty()) return box;
    // Nearer about the outermost places: five by five rays along the side's axis, each time in half the room.
    for (std::size_t side = 0; side < 6; ++side) {
        const int axis = static_cast<int>(side / 2), u = (axis + 1) % 3, v = (axis + 2) % 3;
        glm::dvec2 room(2.0 * size[u] / cells, 2.0 * size[v] / cells);
        double gained = 0.0;
        for (int step = 0; step < kExtentSteps; ++step) {
            const glm::dvec3 about = far[side].point;
            const double before = (side & 1) != 0 ? box.upper[axis] : box.lower[axis];
            for (int j = -2; j <= 2; ++j)
                for (int i = -2; i <= 2; ++i) {
                    if (i == 0 && j == 0) continue;
                    glm::dvec3 p = about;
                    p[u] += room.x * i / 2.0;
                    p[v] += room.y * j / 2.0;
                    look(body, p, axis, box, far, chords);
                }
            rays += 24;
            const double now = (side & 1) != 0 ? box.upper[axis] : box.lower[axis];
            gained = std::max(0.5 * gained, std::abs(now - before));
            room *= far[side].point == about ? 0.5 : 0.8;
        }
        error = std::max(error, 2.0 * gained);
    }
    return box;
}

csg::Aabb require_extent(const Body& body, double& error, std::uint64_t& rays)
{
    if (body.bounds().empty()) throw NoBody("nothing is inside of it");
    if (!body.bounds().finite()) throw NoBody("it has no end");
    for (int cells = kExtentCells; cells <= 8 * kExtentCells; cells *= 2) {
        const csg::Aabb met = met_extent(body, cells, error, rays);
        if (!met.empty()) return met;
    }
    throw NoBody("no ray met anything of it");
}

Measures measure(const Body& body, const MeasureOptions& options)
{
    double error = 0.0;
    std::uint64_t rays = 0;
    const csg::Aabb extent = require_extent(body, error, rays);
    Measures out = measure_within(body, extent, error, options);
    out.rays += rays;
    return out;
}

Measures measure_within(const Body& body, const csg::Aabb& extent, double extent_error, const MeasureOptions& options)
{
    Measures out;
    out.extent = extent;
    out.extent_error = extent_error;
    out.empty = false;
    // Rays have to meet all of it: a little beyond what was met, within what is known.
    csg::Aabb box = out.extent;
    const glm::dvec3 size = box.upper - box.lower;
    const glm::dvec3 margin = glm::max(size, glm::dvec3(1e-3 * glm::max(size.x, glm::max(size.y, size.z)))) * 0.01 +
                              out.extent_error;
    box = csg::Aabb{box.lower - margin, box.upper + margin}.intersected(body.bounds());
    for (Ladder ladder;;) {
        const Estimate found = estimate(body, box, ladder, options.cancel);
        out.rays += ladder.all();
        fill(found, out);
        const double off = glm::max(out.centre_error.x, glm::max(out.centre_error.y, out.centre_error.z));
        // How many times as far off it is as it may be.
        const double times = std::max({off / (options.precision * glm::length(out.extent.upper - out.extent.lower)),
                                       out.volume.error / (options.precision * out.volume.value),
                                       out.surface.error / (options.precision * out.surface.value)});
        if (times <= 1.0) return out;
        // As many rays at once as shall be enough, of those that there are.
        const double enough = std::pow(kSpare * times, 1.0 / kFalls) * static_cast<double>(ladder.rays());
        Ladder next = ladder;
        for (int k = 0; k < kMostClimb && static_cast<double>(next.rays()) < enough; ++k) {
            Ladder higher = next;
            higher.climb();
            if (out.rays + higher.all() > options.most_rays) break;
            next = higher;
        }
        if (next.rays() == ladder.rays()) return out;
        ladder = next;
    }
}

}  // namespace solid
