#include "render/app/watch/passes.h"

#include "render/app/still/still.h"
#include "render/app/watch/block_event.h"
#include "render/kernel/gather/indirect_light.h"
#include "render/picture/passes/passes.h"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <chrono>
#include <memory>

namespace app {
namespace {

using PassClock = std::chrono::steady_clock;

constexpr std::array kSteps = {16, 8, 4, 2, 1};
constexpr int kIndirectAfter = 2;           // the number of the pass that is followed by radiosity and photons
constexpr double kAntialiasingCosts = 2.5;  // of the pass before it, as a guess for the time left
constexpr double kTellEvery = 0.1;          // seconds

double seconds_since(PassClock::time_point start)
{
    return std::chrono::duration<double>(PassClock::now() - start).count();
}

class PassTracer {
public:
    PassTracer(plan::CompiledScene& compiled, const trace::RenderOptions& options, const image::Encoding& encoding,
               int generation, EventLog& events, PassTimes& times)
        : compiled_(compiled), whole_(compiled.options), options_(options), encoding_(encoding),
          generation_(generation), events_(events), times_(times)
    {}

    bool run(bool coarse)
    {
        const bool antialiases = whole_.antialiasing.method != 0;
        const bool indirect = compiled_.photons != nullptr || compiled_.radiosity != nullptr;
        const std::size_t first = coarse || indirect ? 0 : kSteps.size() - 1;
        for (std::size_t pass = first; pass < kSteps.size(); ++pass) {
            if (!trace(static_cast<int>(pass), kSteps[pass], false)) return false;
            if (indirect && pass == kIndirectAfter && !find_indirect()) return false;
        }
        return !antialiases || trace(static_cast<int>(kSteps.size()), 1, true);
    }

private:
    bool find_indirect()
    {
        compiled_.options = whole_;
        const auto start = PassClock::now();
        trace::RenderOptions options = options_;
        options.pass = [this](std::string_view name) { tell(name, 0.0, -1.0); };
        light_ = trace::run_passes(compiled_, options);
        times_.emplace_back("light", seconds_since(start));
        return !options_.cancel->load();
    }

    /// \param step pixels of the whole picture that one of the pass stands for, across and down
    bool trace(int pass, int step, bool antialias)
    {
        compiled_.options = antialias ? whole_ : coarse_options(whole_, step);
        const plan::Options& o = compiled_.options;
        const std::string name = antialias ? "antialiasing" : fmt::format("1/{}", step);
        const trace::Blocks blocks(o);
        const auto start = PassClock::now();
        image::Image picture{o.width, o.height, {}, 0};
        picture.hold(0, o.height);
        trace::RenderOptions options = options_;
        options.indirect = light_.get();
        std::atomic<double> told = -kTellEvery;
        options.progress = [&](double share) {
            const double now = seconds_since(start);
            double before = told;
            if (now - before < kTellEvery || !told.compare_exchange_strong(before, now)) return;
            tell(name, share, share > 0.0 ? time_left(pass, step, now, share) : -1.0);
        };
        options.finished = [&](std::size_t i) {
            events_.push(EventLog::Kind::Block, block_event(generation_, pass, blocks[i], picture, encoding_),
                         generation_, pass);
        };
        const bool done = !trace::render(compiled_, options, picture).cancelled;
        compiled_.options = whole_;
        if (!done) return false;
        events_.passed(generation_, pass);
        times_.emplace_back(name, seconds_since(start));
        return true;
    }

    /// From how long this pass takes so far: each finer one takes four times as long.
    double time_left(int pass, int step, double seconds, double share) const
    {
        const double all = seconds / share;
        double later = 0.0, finest = all;
        for (; step > 1; step /= 2) later += finest *= 4.0;
        const bool antialiased = pass == static_cast<int>(kSteps.size());
        if (whole_.antialiasing.method != 0 && !antialiased) later += kAntialiasingCosts * finest;
        return all - seconds + later;
    }

    void tell(std::string_view name, double share, double left)
    {
        events_.push(EventLog::Kind::Progress, fmt::format(R"({{"g":{},"pass":"{}","share":{:.4f},"left":{:.2f}}})",
                                                           generation_, name, share, left));
    }

    plan::CompiledScene& compiled_;
    const plan::Options whole_;
    const trace::RenderOptions& options_;
    const image::Encoding& encoding_;
    const int generation_;
    EventLog& events_;
    PassTimes& times_;
    std::shared_ptr<const trace::IndirectLight> light_;
};

}  // namespace

bool trace_passes(plan::CompiledScene& compiled, const trace::RenderOptions& options, const image::Encoding& encoding,
                  bool coarse, int generation, EventLog& events, PassTimes& times)
{
    return PassTracer(compiled, options, encoding, generation, events, times).run(coarse);
}

}  // namespace app
