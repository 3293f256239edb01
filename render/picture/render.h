#pragma once

#include "render/image/pixels/image.h"
#include "render/plan/compiled_scene.h"
#include "render/picture/blocks.h"
#include "render/kernel/tile/ray_counts.h"

#include <atomic>
#include <functional>
#include <string_view>
#include <string>

namespace trace {

struct IndirectLight;
struct Prepared;

/// Instruction sets with a kernel module of their own. Auto takes the best that the processor has.
enum class Isa { Auto, V2, V3, V4 };

struct RenderOptions {
    int threads = 0;  ///< 0: all cores
    Isa isa = Isa::Auto;
    /// Called now and then from any thread with the share of blocks done in [0, 1]; may be empty.
    std::function<void(double)> progress;
    /// Set to true to stop early: looked at once a tile of rays at the latest, whatever a block costs; null: never.
    const std::atomic<bool>* cancel = nullptr;
    const IndirectLight* indirect = nullptr;        ///< of run_passes(); null: none
    std::function<void(std::string_view)> pass;     ///< told the name of each pass that begins; may be empty
    std::string radiosity_from, radiosity_to;       ///< files of samples to begin with and to leave; empty: none
    std::uint64_t radiosity_seed = 0;               ///< which of many sets of samples that are as good as each other
    const Prepared* prepared = nullptr;             ///< what the passes have found before; null: they have not run
    std::size_t first = 0, last = ~std::size_t{0};  ///< blocks [first, last) alone, by number of Blocks
    /// By number of Blocks: true for those that the picture handed in holds already; empty: it holds none.
    std::vector<bool> done;
    std::vector<bool> others;  ///< by number of Blocks: true for those that are not asked for; empty: all are
    bool asks_for(std::size_t block) const { return others.empty() || !others[block]; }
    /// Called from any thread with the number of a block that has just been put into the picture; may be empty.
    std::function<void(std::size_t)> finished;
};

struct RenderStatistics {
    RayCounts rays;
    double seconds_trace = 0;  ///< wall clock
    int threads = 1;
    std::string isa;  ///< "v2", "v3" or "v4"
    bool cancelled = false;
    std::uint64_t samples = 0;  ///< of a picture of many samples (sampling/sampled_render.h); 0: of another
    std::uint64_t broken = 0;   ///< of them: no numbers, and taken as black
    /// And what the spread of its samples says of it, in shown levels, root mean square; NaN: a pixel has one sample or
    /// none, which has no spread.
    double error = 0;

    /// Of two parts of one picture.
    RenderStatistics& operator+=(const RenderStatistics& other)
    {
        rays += other.rays;
        seconds_trace += other.seconds_trace;
        threads = other.threads;
        isa = other.isa;
        cancelled = cancelled || other.cancelled;
        samples = other.samples;
        broken += other.broken;
        error = other.error;
        return *this;
    }
};

/// Traces the picture: same bytes for any number of threads and any instruction set.
/// `image` is made unless it has the picture's size; then the blocks asked for lie in the rows that it holds. Pixels
/// outside of them and of the window of plan::Options stay as they are: black and opaque. Throws std::runtime_error if
/// the kernel module for the asked instruction set is missing or the processor cannot run it.
RenderStatistics render(const plan::CompiledScene& scene, const RenderOptions& options, image::Image& image);

/// The kernels that the processor runs and that were built, best last.
std::vector<Isa> kernels_there();

}  // namespace trace
