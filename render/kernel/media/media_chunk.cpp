#include "render/kernel/media/media_chunk.h"

#include "numbers/random.h"

namespace trace {

bool MediaChunk::takes(const plan::Media& other) const
{
    if (count == kMost) return false;
    if (control == nullptr || control == &other) return true;
    const plan::Media& mine = *control;
    return mine.method == other.method && mine.samples_least == other.samples_least &&
           mine.samples_most == other.samples_most && mine.jitter == other.jitter && mine.aa_level == other.aa_level &&
           mine.enough == other.enough;
}

std::size_t MediaChunk::add(const MediaJob& job, const csg::Ray& ray, double at, double length)
{
    const auto i = static_cast<std::size_t>(count++);
    jobs[i] = job;
    control = job.mix->control;
    one_mix &= job.mix == jobs[0].mix;
    from[i] = at;
    step[i] = length;
    ox[i] = ray.origin.x, oy[i] = ray.origin.y, oz[i] = ray.origin.z;
    dx[i] = ray.direction.x, dy[i] = ray.direction.y, dz[i] = ray.direction.z;
    return i;
}

double MediaChunk::random(std::size_t i, std::uint32_t sample) const
{
    return numbers::random_of(jobs[i].seed, jobs[i].interval, sample);
}

}  // namespace trace
