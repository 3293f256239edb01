#include "render/app/frames.h"

#include <algorithm>

namespace app {

namespace {

/// A subset limit: a share of the frames where it is below 1.
int limit_of(double given, int first, int last)
{
    if (given > 0.0 && given < 1.0) return static_cast<int>((last - first + 1) * given);
    return static_cast<int>(given);
}

}  // namespace

FrameList frames_of(const Settings& settings)
{
    FrameList list;
    const int given_first = settings.initial_frame.value_or(0), given_last = settings.final_frame.value_or(0);
    list.animation = !(given_first == given_last && (given_first == 0 || given_first == 1));
    list.clock_on = list.animation || settings.clock.has_value();
    if (!list.animation) {
        list.frames.push_back({0, settings.clock.value_or(0.0f)});
        return list;
    }
    const int first = std::max(settings.initial_frame.value_or(1), 0);
    const int last_written = std::max(settings.final_frame.value_or(1), first);
    const int last = last_written + (settings.cyclic ? 1 : 0);
    list.initial_frame = first;
    list.final_frame = last;
    list.digits = static_cast<int>(std::to_string(last).size());
    const auto from = static_cast<double>(settings.initial_clock), to = static_cast<double>(settings.final_clock);
    list.clock_delta = last > first ? (to - from) / (last - first) : 0.0;  // one frame: POV-Ray's clock is no number
    const int begin = std::max(first, settings.subset_start_frame > 0.0 ? limit_of(settings.subset_start_frame, first, last) : first);
    const int end = std::max(begin, settings.subset_end_frame > 0.0 ? limit_of(settings.subset_end_frame, first, last) : last_written);
    for (int number = begin; number <= end; number += std::max(settings.frame_step, 1))
        list.frames.push_back({number, static_cast<float>(list.clock_delta * (number - first) + from)});
    return list;
}

}  // namespace app
