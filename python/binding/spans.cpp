#include "csg/base/cancel.h"
#include "python/binding/scene_bodies.h"
#include "render/app/run/stage_options.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

namespace python {
namespace {

constexpr std::size_t kRun = 1024;  // rays that a thread takes at a time

/// A body as rays are tried against it.
struct Target {
    std::unique_ptr<const solid::Body> body;
    csg::Aabb box;  ///< with some slack; without end where the body has none
};

/// Spans of some rays that follow each other.
struct Run {
    std::vector<std::uint32_t> counts;  ///< by ray
    std::vector<std::array<double, 2>> ends;
    std::vector<std::int32_t> object;
};

/// A ray as it is given, as lines are asked: along a unit vector.
struct Given {
    csg::Ray line;
    double length;  ///< of the direction that was given
};

Given given(const Rays& rays, std::size_t i)
{
    const csg::Ray ray = rays[i];
    const double length = glm::length(ray.direction);
    if (!(length > 0.0) || !std::isfinite(length) || !std::isfinite(glm::length(ray.origin)))
        throw app::OptionError(fmt::format("ray {} has no direction or is no number", i));
    return {{ray.origin, ray.direction / length}, length};
}

/// What a tile asks of one target: the lines that come to its box.
struct Asking {
    csg::LineTile lines;
    csg::ChordTile chords;
    std::array<std::int8_t, csg::kTileRays> place;  ///< by ray: in the tile of lines; -1: it passes by

    void ask(const trace::KernelTable& kernel, const Target& target, const std::vector<Given>& rays)
    {
        lines.count = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto [first, last] = csg::line_in_box(target.box, rays[i].line);
            place[i] = -1;
            if (!(first <= last) || last < 0.0) continue;
            place[i] = static_cast<std::int8_t>(lines.count);
            lines.add(rays[i].line, target.box.finite() ? first : 0.0, last);
        }
        if (lines.count > 0) kernel.chords(target.body->lines(), lines, chords);
    }
};

Run run_of(const trace::KernelTable& kernel, const std::vector<Target>& targets, const Rays& rays, std::size_t from,
           std::size_t to)
{
    Run out;
    std::vector<Given> tile;
    std::vector<Asking> asked(targets.size());
    for (std::size_t first = from; first < to; first += csg::kTileRays) {
        tile.clear();
        for (std::size_t i = first; i < std::min<std::size_t>(to, first + csg::kTileRays); ++i)
            tile.push_back(given(rays, i));
        for (std::size_t k = 0; k < targets.size(); ++k) asked[k].ask(kernel, targets[k], tile);
        for (std::size_t i = 0; i < tile.size(); ++i) {
            const std::size_t before = out.ends.size();
            for (std::size_t k = 0; k < targets.size(); ++k) {
                if (asked[k].place[i] < 0) continue;
                for (const csg::Chord& chord : asked[k].chords[static_cast<std::size_t>(asked[k].place[i])]) {
                    if (!(chord.out.t > 0.0)) continue;
                    out.ends.push_back({chord.in.t / tile[i].length, chord.out.t / tile[i].length});
                    out.object.push_back(static_cast<std::int32_t>(k));
                }
            }
            out.counts.push_back(static_cast<std::uint32_t>(out.ends.size() - before));
        }
    }
    return out;
}

/// One after the other, as one.
std::shared_ptr<Spans> joined(const std::vector<Run>& runs, std::size_t rays)
{
    auto out = std::make_shared<Spans>();
    out->first.reserve(rays + 1);
    std::int64_t so_far = 0;
    for (const Run& run : runs) {
        for (const std::uint32_t count : run.counts) {
            out->first.push_back(so_far);
            so_far += count;
        }
        out->ends.insert(out->ends.end(), run.ends.begin(), run.ends.end());
        out->object.insert(out->object.end(), run.object.begin(), run.object.end());
    }
    out->first.push_back(so_far);
    return out;
}

}  // namespace

std::shared_ptr<Spans> spans(const std::shared_ptr<Source>& source, const Asked& asked, Rays rays)
{
    return result_of<std::shared_ptr<Spans>>([source, asked, rays = std::move(rays)](Job& job) {
        const SceneBodies bodies(*source, asked, job.cancel);
        std::vector<Target> targets;
        constexpr double kSlack = 1e-6;  // of the size of a box
        for (const SceneBodies::Named& named : bodies.objects()) {
            auto body = bodies.kept_body(named);
            csg::Aabb box = body->bounds();
            const glm::dvec3 slack = kSlack * (box.upper - box.lower);
            if (!box.finite()) box = csg::Aabb::everything();
            else box = {box.lower - slack, box.upper + slack};
            targets.push_back({std::move(body), box});
        }
        std::vector<Run> runs((rays.size() + kRun - 1) / kRun);
        tbb::task_arena arena(app::threads_of(bodies.settings()));
        arena.execute([&] {
            tbb::parallel_for(std::size_t{0}, runs.size(), [&](std::size_t i) {
                if (job.cancel) throw csg::Cancelled();
                runs[i] = run_of(bodies.kernel(), targets, rays, i * kRun, std::min((i + 1) * kRun, rays.size()));
            });
        });
        auto out = joined(runs, rays.size());
        for (const SceneBodies::Named& named : bodies.objects()) out->names.push_back(named.name);
        return out;
    });
}

}  // namespace python
