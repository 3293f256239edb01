#include "render/picture/passes/radiosity_pass.h"

#include "render/kernel/gather/indirect_light.h"
#include "render/kernel/kernel.h"
#include "render/picture/passes/pass_rays.h"
#include "render/picture/passes/prepared.h"
#include "render/picture/passes/sample_file.h"
#include "render/picture/workers.h"
#include "numbers/random.h"

#include <algorithm>

namespace trace::radiosity {
namespace {

/// A part of the picture that passes go on with.
struct PartState {
    bool open = true;
    std::vector<glm::dvec2> rays;  ///< of the pass at hand, as are the others
    int asked = 0;
    double weight = 0;
};

/// Some of a part's rays. Without the rays themselves: tiles are sorted.
struct PartTile {
    int part;
    std::size_t first, count;
    std::uint64_t seed;
};

class Passes {
public:
    Passes(const plan::CompiledScene& scene, const RenderOptions& options, const KernelTable& kernel,
           IndirectLight& light)
        : options_(options), kernel_(kernel),
          field_(*light.radiosity), parts_{scene.options.width, scene.options.height},
          state_(static_cast<std::size_t>(parts_.count())),
          workers_(
              options, [&scene, &light, this] { return kernel_.make(scene, &light, options_.cancel); }, kernel.free)
    {
        const scene::RadiositySettings& settings = field_.settings();
        passes_ =
            passes(settings.pretrace_start, settings.pretrace_end, parts_.width, parts_.height, scene.camera.povray);
    }

    bool run()
    {
        for (const Pass& pass : passes_) {
            if (!run(pass, tiles_of(pass))) return false;
            close(pass);
        }
        return true;
    }

private:
    /// Rays of all open parts in tiles: in POV-Ray's order for the first pass, else scattered over the picture in an
    /// order that follows no row.
    std::vector<PartTile> tiles_of(const Pass& pass)
    {
        const std::size_t most = pass.pretrace ? kPretraceRays : PassTile::kMost;
        std::vector<PartTile> out;
        for (int part = 0; part < parts_.count(); ++part) {
            PartState& state = state_[static_cast<std::size_t>(part)];
            if (pass.pretrace && !state.open) continue;
            state.rays = rays_of(pass, parts_, part);
            state.asked = 0;
            state.weight = 0;
            for (std::size_t first = 0; first < state.rays.size(); first += most)
                out.push_back({part, first, std::min(most, state.rays.size() - first),
                               numbers::stirred((static_cast<std::uint64_t>(pass.number) << 32) + out.size() + 1 +
                                                options_.radiosity_seed * kFar)});
        }
        if (!in_order(pass))
            std::sort(out.begin(), out.end(), [](const PartTile& a, const PartTile& b) { return a.seed < b.seed; });
        return out;
    }

    PassTile filled(const Pass& pass, const PartTile& from) const
    {
        PassTile tile;
        const auto first = state_[static_cast<std::size_t>(from.part)].rays.begin();
        std::copy_n(first + static_cast<std::ptrdiff_t>(from.first), from.count, tile.at.begin());
        tile.count = static_cast<int>(from.count);
        tile.seed = from.seed;
        tile.pretrace = pass.pretrace;
        return tile;
    }

    /// What the first few samples say is what all that follow are close enough to, so they are POV-Ray's: its parts one
    /// after the other, and its directions. Not where the first pass has so many rays that threads would wait for them
    /// (scenes mostly write 0.08 for pretrace_start).
    bool in_order(const Pass& pass) const
    {
        constexpr double kMostAcross = 32.0;  // rays
        return pass.number == 0 && pass.step * kMostAcross >= std::max(parts_.width, parts_.height);
    }

    /// Tiles of a sub-pass do not see each other's samples: there are few of them as long as there are few samples.
    bool run(const Pass& pass, const std::vector<PartTile>& tiles)
    {
        std::vector<std::size_t> directions(in_order(pass) ? field_.samples.size() : 0);
        const std::size_t most = in_order(pass) ? 1 : kMostAtOnce;
        std::vector<TileFindings> findings;
        for (std::size_t first = 0; first < tiles.size();) {
            const std::size_t count = std::min({std::max<std::size_t>(1, done_), most, tiles.size() - first});
            findings.resize(std::max(findings.size(), count));
            if (!workers_.each(0, count, [&](std::size_t i, auto& worker) {
                    PassTile tile = filled(pass, tiles[first + i]);
                    if (in_order(pass)) tile.first = &directions;
                    return kernel_.pretrace(*worker.tracer, tile, findings[i]);
                }))
                return false;
            for (std::size_t i = 0; i < count; ++i) {
                PartState& state = state_[static_cast<std::size_t>(tiles[first + i].part)];
                state.asked += findings[i].asked;
                state.weight += findings[i].weight;
                for (const Found& found : findings[i].found) field_.add(found);
            }
            if (in_order(pass)) directions = findings[0].next;
            first += count;
            done_ += count;
            if (options_.progress)
                options_.progress((pass.number + static_cast<double>(first) / static_cast<double>(tiles.size())) /
                                  static_cast<double>(passes_.size()));
        }
        return true;
    }

    /// Parts that need no finer passes (spec 6, 4.7).
    void close(const Pass& pass)
    {
        constexpr std::size_t kTelling = 9;
        if (!pass.pretrace) return;
        const int enough = field_.settings().adaptive_count;
        for (PartState& state : state_)
            if (state.open && state.rays.size() >= kTelling)
                state.open = state.asked > 0 && (enough == 0 || state.weight < enough * state.asked);
    }

    static constexpr std::uint64_t kFar = 0x10000000000u;  ///< more than there are tiles
    static constexpr std::size_t kPretraceRays = 64, kMostAtOnce = 64;

    const RenderOptions& options_;
    const KernelTable& kernel_;
    Field& field_;
    Parts parts_;
    std::vector<PartState> state_;
    Workers<BlockTracer> workers_;
    std::vector<Pass> passes_;
    std::size_t done_ = 0;  ///< tiles
};

}  // namespace

bool fill(const plan::CompiledScene& scene, const RenderOptions& options, const KernelTable& kernel,
          IndirectLight& light)
{
    light.radiosity = std::make_unique<Field>(scene);
    if (options.prepared != nullptr) {
        for (const Found& found : options.prepared->samples) light.radiosity->add(found);
        return true;
    }
    if (options.pass) options.pass("radiosity pretrace");
    if (!options.radiosity_from.empty())
        for (const Found& found : read_samples(options.radiosity_from))
            if (found.bounce < scene.radiosity->settings.recursion_limit) light.radiosity->add(found);
    if (!Passes(scene, options, kernel, light).run()) return false;
    if (!options.radiosity_to.empty()) write_samples(options.radiosity_to, light.radiosity->samples);
    return true;
}

}  // namespace trace::radiosity
