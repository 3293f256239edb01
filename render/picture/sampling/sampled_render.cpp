#include "render/picture/sampling/sampled_render.h"

#include "render/picture/kernel_module.h"
#include "render/picture/workers.h"
#include "render/picture/sampling/denoise.h"
#include "render/picture/sampling/find_sources.h"
#include "numbers/random.h"
#include "render/picture/sampling/path_spread.h"
#include "render/picture/sampling/sharing.h"
#include "render/kernel/tile/sobol.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace trace {
namespace {

constexpr int kSide = 8;     // of the squares whose samples make tiles of rays
constexpr int kWidest = 32;  // of those whose pixels are not all asked
constexpr std::size_t kAtOnce = 16 * csg::kTileRays;
constexpr std::uint32_t kFirst = 8;        // samples of each pixel before its spread is believed
constexpr std::uint32_t kMost = 1u << 16;  // of a pixel
constexpr double kBreath = 0.01;           // seconds of a thread between two looks at the clock, where time is given
constexpr double kGrowth = 4.0;            // most samples of a pixel after a pass, by those before it
constexpr double kAim = 0.95;              // of the error asked for, as it is but estimated

std::uint32_t seed_of(int x, int y, std::uint32_t seed)
{
    const std::uint64_t place = static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32 |
                                static_cast<std::uint32_t>(x);
    return static_cast<std::uint32_t>(numbers::stirred(numbers::stirred(place + 0x9e3779b97f4a7c15u) + seed));
}

/// What a thread asks of paths, and what they find.
struct PathBuffers {
    std::vector<PathSample> samples;
    std::vector<PathFound> found;
};

class SampledRender {
public:
    SampledRender(const plan::CompiledScene& scene, const RenderOptions& options, const SamplingGoal& goal,
                  const ShownLevel& shown, SampledPicture& picture, PathFeatures* features)
        : features_(features), scene_(scene), options_(options), goal_(goal), shown_(shown), picture_(picture),
          kernel_(load_kernel(options.isa)),
          sources_(scene.options.paths ? path::find_sources(scene, options.threads) : path::Sources()),
          tracers_(
              options, [this] { return kernel_.make(scene_, options_.indirect, options_.cancel); }, kernel_.free),
          paths_(
              options, [this] { return kernel_.make_paths(scene_, sources_, options_.cancel); }, kernel_.free_paths),
          blocks_(scene.options),
          wanted_(static_cast<std::size_t>(picture.width()) * static_cast<std::size_t>(picture.height()), 0)
    {
        for (std::size_t i = 0; i < blocks_.size(); ++i) {
            if (!options_.asks_for(i)) continue;
            const Block block = blocks_[i];
            for (int row = 0; row < block.height; ++row)
                for (int column = 0; column < block.width; ++column)
                    window_.push_back(index(block.left + column, block.top + row));
        }
    }

    RenderStatistics run(const std::function<void(double)>& after_pass)
    {
        RenderStatistics out;
        want_first();
        while (true) {
            const double begun = seconds();
            const std::uint64_t before = taken_;
            pass();
            ++passes_;
            const double ended = seconds(), took = ended - begun;
            if (took > 0.0) rate_ = static_cast<double>(taken_ - before) / took;
            out.error = judge();
            if (after_pass) after_pass(met(out.error));
            afterwards_ = seconds() - ended;
            if (stopped_ || !want_more(out.error)) break;
        }
        if (fewest() < 2) out.error = std::numeric_limits<double>::quiet_NaN();
        out.samples = picture_.samples();
        out.broken = broken_;
        out.rays = tracers_.counts(kernel_.counts);
        out.rays += paths_.counts(kernel_.path_counts);
        out.threads = tracers_.threads();
        out.isa = kernel_.isa;
        out.cancelled = stopped_;
        out.seconds_trace = seconds();
        return out;
    }

private:
    /// What the picture is expected to be off by; fills variances_.
    double judge()
    {
        if (!scene_.options.paths) {
            variances_ = picture_.variances(shown_, scene_.options);
            return picture_.expected_error(variances_, shown_, scene_.options);
        }
        const PathSpread spread(picture_, shown_, scene_.options);
        variances_ = spread.variances();
        return spread.expected_error();
    }

    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width()) + static_cast<std::size_t>(x);
    }
    std::pair<int, int> place(std::size_t at) const
    {
        const auto width = static_cast<std::size_t>(picture_.width());
        return {static_cast<int>(at % width), static_cast<int>(at / width)};
    }
    SampledPicture::Pixel& pixel(std::size_t at)
    {
        const auto [x, y] = place(at);
        return picture_.at(x, y);
    }
    double now() const
    {
        if (goal_.clock) return goal_.clock();
        return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    }
    double seconds() const { return now() - start_; }
    /// Where the time is over, whatever is still wanted. The first pass is taken whatever it costs: there has to be a
    /// picture.
    bool late() const { return ends_ && left() <= 0.0; }
    double left() const { return goal_.seconds > 0.0 ? goal_.seconds - seconds() - afterwards_ : 0.0; }

    /// Share of the goal, for those who wait.
    double met(double error) const
    {
        double share = 0.0;
        if (goal_.samples > 0)
            share = std::max(share, static_cast<double>(taken_) /
                                        (static_cast<double>(goal_.samples) * static_cast<double>(window_.size())));
        if (goal_.error > 0.0) share = std::max(share, error > 0.0 ? goal_.error * goal_.error / (error * error) : 1.0);
        if (goal_.seconds > 0.0) share = std::max(share, seconds() / goal_.seconds);
        return std::min(share, 1.0);
    }

    void want_first()
    {
        before_ = fewest();
        if (goal_.seconds > 0.0 && before_ == 0) return want_coarse();
        std::uint32_t first = goal_.seconds > 0.0 ? 1 : kFirst;
        if (goal_.samples > 0) first = std::min(first, goal_.samples);
        for (const std::size_t at : window_) wanted_[at] = first;
    }

    /// Whether some pixels have no sample yet, as time may not allow that.
    bool coarse() const { return goal_.seconds > 0.0 && before_ == 0 && steps_ <= SampledPicture::kCoarse.size(); }

    /// A sample for each pixel of the next finer grid that has none; for all, where there seems to be time for that.
    void want_coarse()
    {
        constexpr double kSure = 0.5;  // of the time that is left
        const std::size_t grids = SampledPicture::kCoarse.size();
        if (steps_ > 0 && rate_ * kSure * left() > static_cast<double>(window_.size())) steps_ = grids;
        const int step = steps_ < grids ? SampledPicture::kCoarse[steps_] : 1;
        side_ = step > 1 ? kWidest : kSide;
        ++steps_;
        for (const std::size_t at : window_) {
            const auto [x, y] = place(at);
            const bool asked = (x - scene_.options.start_column) % step == 0 &&
                               (y - scene_.options.start_row) % step == 0;
            wanted_[at] = asked && pixel(at).count == 0 ? 1 : 0;
        }
    }

    /// What the next pass takes, in wanted_. False: nothing.
    bool want_more(double error)
    {
        const std::uint32_t now = fewest(), taken = now - before_;
        if (goal_.error > 0.0 && now >= kFirst && error <= kAim * goal_.error) return false;
        const double room = room_left();
        if (room < 1.0 || now >= kMost) return false;
        if (coarse()) {
            want_coarse();
            return true;
        }
        side_ = kSide;
        if (goal_.samples > 0) return want_evenly(std::min(taken, goal_.samples - taken), room);
        return goal_.even || now < kFirst ? want_evenly(now, room) : want_by_spread(error, room);
    }

    /// Samples that the next pass may take: half of what the time allows, as what a pass costs is better known after
    /// it.
    double room_left() const
    {
        constexpr double kLast = 0.05;  // of the time: then all of it
        if (!(goal_.seconds > 0.0)) return std::numeric_limits<double>::infinity();
        const double rest = std::max(left(), 0.0);
        return rate_ * (rest < kLast * goal_.seconds ? rest : 0.5 * rest);
    }

    std::uint32_t fewest()
    {
        std::uint32_t least = kMost;
        for (const std::size_t at : window_) least = std::min(least, pixel(at).count);
        return least;
    }

    /// As many for each pixel; where there is no room for that, one for each of some, scattered over the picture.
    bool want_evenly(std::uint32_t each, double room)
    {
        const double pixels = static_cast<double>(window_.size());
        const double all = std::min(static_cast<double>(each), room / pixels);
        if (!(all > 0.0)) return false;
        const auto sure = static_cast<std::uint32_t>(all);
        for (const std::size_t at : window_) {
            const double place = owen_scrambled(reversed_bits(static_cast<std::uint32_t>(at)), passes_) * 0x1p-32;
            wanted_[at] = sure > 0 ? sure : place < all ? 1 : 0;
        }
        return true;
    }

    bool want_by_spread(double error, double room)
    {
        return Sharing{picture_, window_, variances_, kGrowth, double{kMost}}.share_out(
            goal_.error > 0.0 ? kAim * goal_.error / error : 0.0, room, wanted_);
    }

    void pass()
    {
        std::uint64_t all = 0;
        for (const std::size_t at : window_) all += wanted_[at];
        std::atomic<std::uint64_t> done = 0;
        ends_ = goal_.seconds > 0.0 && taken_ > 0;
        at_once_ = kAtOnce;
        if (goal_.seconds > 0.0)  // tiles stay whole
            at_once_ = csg::kTileRays * static_cast<std::size_t>(
                                            std::clamp(kBreath * rate_ / (tracers_.threads() * double{csg::kTileRays}),
                                                       1.0, double{kAtOnce} / csg::kTileRays));
        const auto each_block = [&](auto& workers) {
            return workers.each(0, blocks_.size(), [&](std::size_t i, auto& worker) {
                if (!options_.asks_for(i)) return true;
                const Block block = blocks_[i];
                for (int top = 0; top < block.height; top += side_)
                    for (int column = 0; column < block.width; column += side_) {
                        if (late()) return true;
                        const Block square{block.left + column, block.top + top, std::min(side_, block.width - column),
                                           std::min(side_, block.height - top)};
                        if (!take(worker, square, done)) return late();
                    }
                if (options_.progress && all > 0 && goal_.samples > 0)
                    options_.progress(
                        std::min(1.0, static_cast<double>(taken_ + done) /
                                          (static_cast<double>(goal_.samples) * static_cast<double>(window_.size()))));
                return true;
            });
        };
        stopped_ = !(scene_.options.paths ? each_block(paths_) : each_block(tracers_));
        taken_ += done;
    }

    /// The samples that the pixels of a square want: the first of each, the second of each, and so on, so that tiles of
    /// rays are as wide as the square.
    bool take(Workers<BlockTracer, std::vector<scene::Color>>::Worker& worker, const Block& square,
              std::atomic<std::uint64_t>& done)
    {
        std::array<SamplePosition, kAtOnce> positions;
        std::array<SampledPicture::Pixel*, kAtOnce> owners;
        std::size_t count = 0;
        worker.kept.resize(kAtOnce);
        const auto flush = [&] {
            if (late() || !kernel_.sample(*worker.tracer, {positions.data(), count}, worker.kept.data())) return false;
            for (std::size_t i = 0; i < count; ++i)
                if (!owners[i]->add(worker.kept[i])) ++broken_;
            done += count;
            count = 0;
            return true;
        };
        return each_wanted(square,
                           [&](int x, int y, std::uint32_t seed, std::uint32_t index) {
                               const std::array<double, 2> at = sobol_point(seed, index);
                               positions[count] = {x - 0.5 + at[0], y - 0.5 + at[1]};
                               owners[count++] = &picture_.at(x, y);
                               return count < at_once_ || flush();
                           }) &&
               (count == 0 || flush());
    }

    /// The same of paths.
    bool take(Workers<PathTracer, PathBuffers>::Worker& worker, const Block& square, std::atomic<std::uint64_t>& done)
    {
        std::vector<PathSample>& samples = worker.kept.samples;
        std::vector<PathFound>& found = worker.kept.found;
        std::array<SampledPicture::Pixel*, kAtOnce> owners;
        std::array<std::array<int, 2>, kAtOnce> places;
        samples.clear();
        found.resize(kAtOnce);
        const auto flush = [&] {
            if (late() || !kernel_.trace_paths(*worker.tracer, samples, found.data())) return false;
            for (std::size_t i = 0; i < samples.size(); ++i) {
                if (!owners[i]->add(found[i].color)) ++broken_;
                if (features_ != nullptr) features_->add(places[i][0], places[i][1], found[i]);
            }
            done += samples.size();
            samples.clear();
            return true;
        };
        return each_wanted(square,
                           [&](int x, int y, std::uint32_t seed, std::uint32_t index) {
                               const std::array<double, 2> at = sobol_point(seed, index);
                               owners[samples.size()] = &picture_.at(x, y);
                               places[samples.size()] = {x, y};
                               samples.push_back({x - 0.5 + at[0], y - 0.5 + at[1], seed, index});
                               return samples.size() < at_once_ || flush();
                           }) &&
               (samples.empty() || flush());
    }

    /// f(x, y, seed, index) for each sample that the pixels of a square want, until it is false.
    template <class F>
    bool each_wanted(const Block& square, F&& f)
    {
        std::array<std::uint32_t, kWidest * kWidest> first;
        std::uint32_t most = 0;
        const auto each = [&](auto&& of) {
            for (int row = 0; row < square.height; ++row)
                for (int column = 0; column < square.width; ++column)
                    of(static_cast<std::size_t>(row * kWidest + column), square.left + column, square.top + row);
        };
        each([&](std::size_t k, int x, int y) {
            first[k] = picture_.at(x, y).count;
            most = std::max(most, wanted_[index(x, y)]);
        });
        bool going = true;
        for (std::uint32_t n = 0; n < most && going; ++n)
            each([&](std::size_t k, int x, int y) {
                if (going && n < wanted_[index(x, y)]) going = f(x, y, seed_of(x, y, goal_.seed), first[k] + n);
            });
        return going;
    }

    PathFeatures* const features_;  ///< null: nobody asks
    const plan::CompiledScene& scene_;
    const RenderOptions& options_;
    const SamplingGoal& goal_;
    const ShownLevel& shown_;
    SampledPicture& picture_;
    const KernelTable& kernel_;
    const path::Sources sources_;
    Workers<BlockTracer, std::vector<scene::Color>> tracers_;
    Workers<PathTracer, PathBuffers> paths_;
    const Blocks blocks_;
    std::vector<std::size_t> window_;    ///< its pixels
    std::vector<std::uint32_t> wanted_;  ///< samples of each pixel in the pass at hand
    std::vector<double> variances_;
    const double start_ = now();
    std::uint32_t before_ = 0;  ///< samples of a pixel when the run began
    std::uint64_t taken_ = 0;   ///< in the passes before
    std::uint32_t passes_ = 0;
    std::size_t steps_ = 0;          ///< grids of SampledPicture::kCoarse that were asked, and all pixels
    int side_ = kSide;               ///< of the squares of this pass
    std::size_t at_once_ = kAtOnce;  ///< samples between two looks at the clock
    bool ends_ = false;              ///< whether the clock ends this pass
    double rate_ = 0.0;              ///< samples a second, in the last pass
    double afterwards_ = 0.0;  ///< seconds from the end of the last pass on until its picture was judged and shown
    bool stopped_ = false;
    std::atomic<std::uint64_t> broken_ = 0;  ///< samples that are no numbers
};

}  // namespace

RenderStatistics render_sampled(const plan::CompiledScene& scene, const RenderOptions& options,
                                const SamplingGoal& goal, const ShownLevel& shown, SampledPicture& picture,
                                const std::function<void(double)>& after_pass, PathFeatures* features)
{
    const KernelTable& kernel = load_kernel(options.isa);
    function::use(kernel.evaluators);
    return SampledRender(scene, options, goal, shown, picture, features).run(after_pass);
}

}  // namespace trace
