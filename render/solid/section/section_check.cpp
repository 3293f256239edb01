#include "render/solid/section/section_check.h"

#include "csg/base/cancel.h"
#include "render/solid/measure/jitter.h"
#include "render/solid/section/contour.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace solid {
namespace {

constexpr int kSectionRuns = 8, kLinesOfRun = 256;  // lines of a run along each of the two directions
constexpr double kStudentOfRuns = 4.073;            // 99.9 % of Student's t with 2 kSectionRuns - 1 degrees of freedom
constexpr std::size_t kMostSides = 30'000;          // of the loops that are looked at
constexpr int kDirectionsRound = 64;

struct LoopSide {
    glm::dvec2 a, b;
};

std::vector<LoopSide> sides_in(const std::vector<Loop>& loops)
{
    std::vector<LoopSide> out;
    for (const Loop& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) out.push_back({loop[i], loop[(i + 1) % loop.size()]});
    return out;
}

/// Sides by the cells of a grid that their boxes meet.
class SideGrid {
public:
    explicit SideGrid(const std::vector<LoopSide>& sides) : sides_(sides)
    {
        glm::dvec2 lower(numbers::kInfinity), upper(-numbers::kInfinity);
        for (const LoopSide& s : sides) {
            lower = glm::min(lower, glm::min(s.a, s.b));
            upper = glm::max(upper, glm::max(s.a, s.b));
        }
        if (sides.empty()) return;
        const double longest = std::max(upper.x - lower.x, upper.y - lower.y);
        step_ = longest / std::clamp(std::sqrt(static_cast<double>(sides.size())), 4.0, 300.0);
        origin_ = lower;
        for (int k = 0; k < 2; ++k) count_[k] = static_cast<int>((upper[k] - lower[k]) / step_) + 1;
        cells_.resize(static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]));
        for (std::uint32_t i = 0; i < sides.size(); ++i) {
            const glm::ivec2 low = cell(glm::min(sides[i].a, sides[i].b)),
                             high = cell(glm::max(sides[i].a, sides[i].b));
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x) cells_[at(x, y)].push_back(i);
        }
    }

    double distance(const glm::dvec2& p) const
    {
        const glm::ivec2 here = cell(p);
        double best = numbers::kInfinity;
        for (int ring = 0; ring <= std::max(count_[0], count_[1]); ++ring) {
            // What lies in rings beyond is farther than the room up to them.
            if (ring > 0 && best <= (ring - 1) * step_) break;
            for (int y = here.y - ring; y <= here.y + ring; ++y)
                for (int x = here.x - ring; x <= here.x + ring; ++x) {
                    if (std::max(std::abs(x - here.x), std::abs(y - here.y)) != ring) continue;
                    if (x < 0 || y < 0 || x >= count_[0] || y >= count_[1]) continue;
                    for (const std::uint32_t i : cells_[at(x, y)])
                        best = std::min(best, distance_to_side(p, sides_[i].a, sides_[i].b));
                }
        }
        return best;
    }

private:
    glm::ivec2 cell(const glm::dvec2& p) const
    {
        glm::ivec2 out;
        for (int k = 0; k < 2; ++k)
            out[k] = static_cast<int>(std::clamp(std::floor((p[k] - origin_[k]) / step_), 0.0, count_[k] - 1.0));
        return out;
    }
    std::size_t at(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(count_[0]) + static_cast<std::size_t>(x);
    }
    const std::vector<LoopSide>& sides_;
    double step_ = 1.0;
    glm::dvec2 origin_{0.0};
    int count_[2] = {1, 1};
    std::vector<std::vector<std::uint32_t>> cells_ = std::vector<std::vector<std::uint32_t>>(1);
};

/// An upper bound of the distance of a place from the boundary in the plane: along the loop's normal, then in
/// directions all round.
double off_body_in_plane(const Body& body, const CuttingPlane& plane, const glm::dvec2& p, const glm::dvec2& normal,
                         double reach, double wanted, std::vector<Chord>& chords)
{
    double best = reach;
    const auto look = [&](const glm::dvec2& along) {
        body.chords(plane.point(p), plane.direction(along), -best, best, chords);
        for (const Chord& chord : chords)
            for (const End* end : {&chord.in, &chord.out}) best = std::min(best, std::abs(end->t));
    };
    look(normal);
    for (int k = 0; k < kDirectionsRound && best > wanted; ++k) {
        const double angle = 3.14159265358979323846 * (k + 0.5) / kDirectionsRound;
        look({std::cos(angle), std::sin(angle)});
    }
    return best;
}

/// What lines of one run along one direction found.
struct Lines {
    double area = 0.0, worst = 0.0;
    std::size_t samples = 0;
};

}  // namespace

SectionCheck check_section(const Body& body, const csg::Aabb& extent, const CuttingPlane& plane,
                           const std::vector<Loop>& loops, double wanted, const std::atomic<bool>* cancel)
{
    SectionCheck out;
    const std::vector<LoopSide> sides = sides_in(loops);
    const SideGrid grid(sides);
    const glm::dvec2 lower = plane.flat(extent.lower), size = plane.flat(extent.upper) - lower;
    const double reach = glm::length(size);
    std::vector<Lines> runs(2 * kSectionRuns);
    tbb::parallel_for(std::size_t(0), runs.size(), [&](std::size_t run) {
        std::vector<Chord> chords;
        const int k = static_cast<int>(run % 2);
        glm::dvec2 along(0.0);
        along[k] = 1.0;
        for (int i = 0; i < kLinesOfRun; ++i) {
            if (cancel != nullptr && *cancel) throw csg::Cancelled();
            glm::dvec2 p = lower;
            p[1 - k] += size[1 - k] * (i + jitter(run * kLinesOfRun + static_cast<std::uint64_t>(i))) / kLinesOfRun;
            body.chords(plane.point(p), plane.direction(along), -numbers::kInfinity, numbers::kInfinity, chords);
            for (const Chord& chord : chords) {
                runs[run].area += chord.length() * size[1 - k] / kLinesOfRun;
                for (const End* end : {&chord.in, &chord.out}) {
                    runs[run].worst = std::max(runs[run].worst, std::min(reach, grid.distance(p + end->t * along)));
                    ++runs[run].samples;
                }
            }
        }
    });
    double sum = 0.0, squares = 0.0;
    for (const Lines& run : runs) {
        sum += run.area / static_cast<double>(runs.size());
        out.from_body = std::max(out.from_body, run.worst);
        out.samples += run.samples;
    }
    for (const Lines& run : runs) squares += (run.area - sum) * (run.area - sum);
    const auto count = static_cast<double>(runs.size());
    out.area = {sum, kStudentOfRuns * std::sqrt(squares / (count * (count - 1.0)))};

    const std::size_t every = sides.size() / kMostSides + 1, looked = (sides.size() + every - 1) / every;
    std::vector<double> off(looked);
    tbb::parallel_for(std::size_t(0), looked, [&](std::size_t i) {
        if (cancel != nullptr && *cancel) throw csg::Cancelled();
        thread_local std::vector<Chord> chords;
        const LoopSide& side = sides[i * every];
        const glm::dvec2 along = side.b - side.a;
        const double length = glm::length(along);
        if (!(length > 0.0)) return;
        for (const double share : {0.5, 0.8 * jitter(i) + 0.1})
            off[i] = std::max(off[i],
                              off_body_in_plane(body, plane, side.a + share * along,
                                                glm::dvec2(-along.y, along.x) / length, reach, 0.5 * wanted, chords));
    });
    for (const double here : off) out.from_loops = std::max(out.from_loops, here);
    out.samples += 2 * looked;
    return out;
}

}  // namespace solid
