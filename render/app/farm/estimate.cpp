#include "render/app/farm/estimate.h"

#include "numbers/functions/functions.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using Known = std::vector<std::pair<std::size_t, double>>;

/// Processor seconds of a coarse pass that nobody minds, and the share of the job that it may take where that is more.
constexpr double kCheap = 2.0, kShare = 0.02;
constexpr std::size_t kSampledFrames = 12;

double cost_of(const SizedCost& cost) { return cost.reading + cost.rest + cost.passes + cost.picture + cost.writing; }

/// Sizes of one frame: an eighth as wide, a quarter, and larger ones as long as they cost little.
std::vector<SizedCost> sizes_of(const FarmJob& job, const Frame& frame, double budget, const Cancellation& cancel)
{
    std::vector<SizedCost> sizes;
    for (double scale = 0.125; scale <= 1.0 && !cancel.requested; scale *= 2.0) {
        const double next = sizes.empty() ? 0.0 : 4.0 * sizes.back().picture + sizes.back().passes;
        if (scale > 0.25 && next > budget) break;
        sizes.push_back(measure_frame(job, frame, scale, cancel));
    }
    return sizes;
}

Known with_values(const std::vector<std::pair<std::size_t, FrameCost>>& known, double (*value)(const FrameCost&))
{
    Known out;
    for (const auto& [place, cost] : known) out.emplace_back(place, value(cost));
    return out;
}

/// Nothing is guessed of a size that was measured itself.
double off(const SizedCost& measured, const SizeModel& model, double pixels)
{
    return measured.pixels < pixels ? model.error() : 0.0;
}

/// Frames of which some are known.
JobEstimate filled_in(const std::vector<std::pair<std::size_t, FrameCost>>& known, std::size_t count,
                      std::optional<double> error)
{
    const auto all = [&](double (*value)(const FrameCost&)) { return between(with_values(known, value), count); };
    const auto reading = all([](const FrameCost& c) { return c.reading; });
    const auto passes = all([](const FrameCost& c) { return c.passes; });
    const auto picture = all([](const FrameCost& c) { return c.picture; });
    const auto memory = all([](const FrameCost& c) { return c.memory; });
    JobEstimate out;
    for (std::size_t i = 0; i < count; ++i) out.frames.push_back({reading[i], passes[i], picture[i], memory[i]});
    for (const auto& [place, cost] : known) out.frames[place] = cost;
    if (count > known.size()) {
        const auto uneven = unevenness(with_values(known, [](const FrameCost& c) { return c.seconds(); }));
        error = error && uneven ? std::optional(numbers::hypot(*error, *uneven)) : std::nullopt;
    }
    out.error = error;
    out.measured = static_cast<int>(known.size());
    return out;
}

}  // namespace

std::vector<double> between(const Known& known, std::size_t count)
{
    std::vector<double> out(count, known.front().second);
    for (std::size_t k = 0; k < known.size(); ++k) {
        const auto [place, value] = known[k];
        const bool last = k + 1 == known.size();
        const std::size_t end = last ? count : known[k + 1].first;
        const double slope = last ? 0.0
                                  : (known[k + 1].second - value) / static_cast<double>(known[k + 1].first - place);
        for (std::size_t i = place; i < end; ++i) out[i] = value + slope * static_cast<double>(i - place);
    }
    return out;
}

std::optional<double> unevenness(const Known& known)
{
    if (known.size() < 3) return std::nullopt;
    double off = 0.0, sum = 0.0;
    for (std::size_t k = 1; k + 1 < known.size(); ++k) {
        const auto &before = known[k - 1], &after = known[k + 1];
        const double share = static_cast<double>(known[k].first - before.first) /
                             static_cast<double>(after.first - before.first);
        const double said = before.second + share * (after.second - before.second);
        off += (said - known[k].second) * (said - known[k].second);
        sum += known[k].second;
    }
    // Frames between the known ones are off to either side: their sum is off by less than each.
    return sum > 0.0 ? std::sqrt(off) / sum : 0.0;
}

JobEstimate estimate_job(const FarmJob& job, const Cancellation& cancel)
{
    const std::size_t count = job.list.frames.size();
    std::vector<std::pair<std::size_t, FrameCost>> known;
    if (!job.from.empty()) {
        const std::map<int, FrameCost> finished = finished_frames(job.from);
        for (std::size_t i = 0; i < count; ++i)
            if (const auto found = finished.find(job.list.frames[i].number); found != finished.end())
                known.emplace_back(i, found->second);
        if (!known.empty()) return filled_in(known, count, 0.0);
    }
    const double pixels = static_cast<double>(job.settings.width) * job.settings.height;
    const std::size_t step = std::max<std::size_t>(1, (count + kSampledFrames - 1) / kSampledFrames);
    const std::vector<SizedCost> sizes = sizes_of(job, job.list.frames[count / 2 / step * step], kCheap, cancel);
    if (cancel.requested) return {};
    double spent = 0.0;
    for (const SizedCost& size : sizes) spent += cost_of(size);
    const SizeModel model(sizes);
    if (count == 1) {
        JobEstimate out = filled_in({{0, model.at(pixels, sizes.back())}}, 1, off(sizes.back(), model, pixels));
        out.spent = spent;
        return out;
    }
    // The frames in between as large as they may be: a share of the whole, or what nobody minds.
    const double whole = model.at(pixels, sizes.back()).seconds() * static_cast<double>(count);
    const double sampled = static_cast<double>((count + step - 1) / step) + 1.0;
    std::size_t size = 1;
    while (size + 1 < sizes.size() && sampled * cost_of(sizes[size + 1]) < std::max(kCheap, kShare * whole)) ++size;
    const double scale = 0.125 * numbers::pow(2.0, static_cast<double>(std::min(size, sizes.size() - 1)));
    for (std::size_t i = 0; i < count; i = i + step < count || i + 1 == count ? i + step : count - 1) {
        const SizedCost cost = measure_frame(job, job.list.frames[i], scale, cancel);
        if (cancel.requested) return {};
        spent += cost_of(cost);
        known.emplace_back(i, model.at(pixels, cost));
    }
    JobEstimate out = filled_in(known, count, off(sizes[std::min(size, sizes.size() - 1)], model, pixels));
    out.spent = spent;
    return out;
}

}  // namespace app
