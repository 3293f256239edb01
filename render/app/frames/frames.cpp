#include "render/app/frames/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace app {

namespace {

constexpr int kMostFrames = 10'000'000;  // of an animation: days of film, and a list that fits the memory
constexpr int kLargestNumber = 1'000'000'000;

/// A subset limit: a share of the frames where it is below 1.
int limit_of(double given, int first, int last)
{
    if (given > 0.0 && given < 1.0) return static_cast<int>((last - first + 1) * given);
    return static_cast<int>(std::min(given, static_cast<double>(kLargestNumber)));
}

/// The frames of --frames, each once, in order.
std::set<int> listed_frames(const Settings& settings, int first, int last)
{
    std::set<int> numbers;
    for (const FrameRange& range : settings.frame_list) {
        if (range.first < first || range.last > last)
            throw OptionError(fmt::format("--frames: {} is not a frame of the animation, which has {} to {}",
                                          range.first < first ? range.first : range.last, first, last));
        if ((range.last - range.first) / range.step >= kMostFrames)
            throw OptionError(
                fmt::format("--frames: {}-{} are more frames than {}", range.first, range.last, kMostFrames));
        for (long long number = range.first; number <= range.last; number += range.step)
            numbers.insert(static_cast<int>(number));
    }
    return numbers;
}

}  // namespace

FrameList frames_of(const Settings& settings)
{
    FrameList list;
    const int given_first = settings.initial_frame.value_or(0), given_last = settings.final_frame.value_or(0);
    list.animation = !(given_first == given_last && (given_first == 0 || given_first == 1));
    list.clock_on = list.animation || settings.clock.has_value();
    if (!list.animation) {
        if (!settings.frame_list.empty())
            throw OptionError("--frames is for an animation, whose last frame +KFF or Final_Frame names");
        list.frames.push_back({0, settings.clock.value_or(0.0f)});
        return list;
    }
    if (std::max(given_first, given_last) > kLargestNumber)
        throw OptionError(fmt::format("frames have numbers up to {}", kLargestNumber));
    const int first = std::max(settings.initial_frame.value_or(1), 0);
    const int last_written = std::max(settings.final_frame.value_or(1), first);
    const int last = last_written + (settings.cyclic ? 1 : 0);
    list.initial_frame = first;
    list.final_frame = last;
    list.last_frame = last_written;
    list.digits = static_cast<int>(std::to_string(last).size());
    const auto from = static_cast<double>(settings.initial_clock), to = static_cast<double>(settings.final_clock);
    list.clock_delta = last > first ? (to - from) / (last - first) : 0.0;  // one frame: POV-Ray's clock is no number
    const int begin =
        std::max(first, settings.subset_start_frame > 0.0 ? limit_of(settings.subset_start_frame, first, last) : first);
    const int end = std::max(begin, settings.subset_end_frame > 0.0 ? limit_of(settings.subset_end_frame, first, last)
                                                                    : last_written);
    const int step = std::clamp(settings.frame_step, 1, kLargestNumber);
    const auto add = [&](int number) {
        list.frames.push_back({number, static_cast<float>(list.clock_delta * (number - first) + from)});
    };
    if (!settings.frame_list.empty()) {
        for (const int number : listed_frames(settings, first, last_written)) add(number);
        return list;
    }
    if ((end - begin) / step >= kMostFrames)
        throw OptionError(
            fmt::format("an animation has at most {} frames, these are {}", kMostFrames, (end - begin) / step + 1));
    for (int number = begin; number <= end; number += step) add(number);
    return list;
}

}  // namespace app
