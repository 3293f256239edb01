#include "csg/base/cancel.h"
#include "python/binding/scene_bodies.h"
#include "render/app/run/allocation.h"

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

Run run_of(const std::vector<Target>& targets, const Rays& rays, std::size_t from, std::size_t to)
{
    Run out;
    std::vector<solid::Chord> chords;
    for (std::size_t i = from; i < to; ++i) {
        const std::size_t before = out.ends.size();
        const csg::Ray given = rays[i];
        const double length = glm::length(given.direction);
        if (!(length > 0.0) || !std::isfinite(length) || !std::isfinite(glm::length(given.origin)))
            throw app::OptionError(fmt::format("ray {} has no direction or is no number", i));
        const csg::Ray ray{given.origin, given.direction / length};
        for (std::size_t k = 0; k < targets.size(); ++k) {
            const auto [first, last] = solid::line_in_box(targets[k].box, ray);
            if (!(first <= last) || last < 0.0) continue;
            targets[k].body->chords(ray.origin, ray.direction, targets[k].box.finite() ? first : 0.0, last, chords);
            for (const solid::Chord& chord : chords) {
                if (!(chord.out.t > 0.0)) continue;
                out.ends.push_back({chord.in.t / length, chord.out.t / length});
                out.object.push_back(static_cast<std::int32_t>(k));
            }
        }
        out.counts.push_back(static_cast<std::uint32_t>(out.ends.size() - before));
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
        const int threads = app::threads_for(bodies.settings().threads);
        tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
        arena.execute([&] {
            tbb::parallel_for(std::size_t{0}, runs.size(), [&](std::size_t i) {
                if (job.cancel) throw csg::Cancelled();
                runs[i] = run_of(targets, rays, i * kRun, std::min((i + 1) * kRun, rays.size()));
            });
        });
        auto out = joined(runs, rays.size());
        for (const SceneBodies::Named& named : bodies.objects()) out->names.push_back(named.name);
        return out;
    });
}

}  // namespace python
