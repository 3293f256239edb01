#pragma once

#include "render/scene/base/color.h"
#include "render/kernel/tile/ray_state.h"

#include <algorithm>
#include <vector>

/// The rays that wait to be traced, and the nodes that say what becomes of their colours. Nothing recurses: a tile of
/// hits leaves rays and nodes here, the rays are traced a tile at a time, and when the last of them is through its
/// nodes are folded into the colours that the rays before them wait for (docs/shading.md).
namespace trace {

/// Where a colour lies in RayQueue::colors.
using ColorSlot = std::uint32_t;
inline constexpr ColorSlot kNoSlot = 0xffffffffu;  ///< black: no ray was worth tracing

struct QueuedRay {
    ColorSlot slot;  ///< of its colour
    int level;       ///< levels in use including this ray's
    RayState state;

    /// Not cleared: its state is written where it waits.
    QueuedRay() {}
    /// Built in place: copying a state that was just written in smaller pieces would stall on store forwarding.
    QueuedRay(const RayState& of, ColorSlot into, int in_use) : slot(into), level(in_use), state(of) {}
};

/// One of the colours that a node puts together.
struct ShadeTerm {
    ColorSlot slot;
    glm::vec3 factor;   ///< Surface: reflectivity; Spectrum: hue; Sum, Mean: weight (red alone)
    glm::vec3 film{1};  ///< Surface: iridescence of what is mirrored
    float power = 1;    ///< Surface: reflection_power

    ShadeTerm(ColorSlot of, const glm::vec3& by, float raised = 1) : slot(of), factor(by), power(raised) {}
};

/// How colours become one. Its terms are `count` from `first` on in RayQueue::terms.
struct ShadeNode {
    enum class Kind : std::uint8_t {
        Surface,   ///< layers of a texture: their own light, what is behind them, what they mirror
        Mix,       ///< two neighbours of a texture_map
        Sum,       ///< by weights: corners of a mesh's face, parts of a blob
        Mean,      ///< the same over the sum of the weights: an average
        Spectrum,  ///< rays of single wavelengths (spec 3, 8.5)
        Air        ///< what the air on the way of the ray makes of it (tile/air.h): share, glow and clear are `filter`,
                   ///< `own`, `residual`
    };
    Kind kind = Kind::Surface;
    bool total = false;  ///< Surface: `through` is the mirrored ray of a total reflection
    ColorSlot out = kNoSlot,
              through = kNoSlot;  ///< Mix: `through` is the lower one, the only term the upper one. Air: what it dims
    std::uint32_t first = 0, count = 0;
    float residual = 0;  ///< Surface: share of alpha that goes through
    float weights = 0;   ///< Mean: their sum
    double share = 0;    ///< Mix: of the upper one
    glm::vec3 own{0}, filter{1},
        fade{1};  ///< Surface; `fade`: of the ray that goes through, its film included where it is `total`
    glm::vec3 film{1};
};

/// What waits, per thread. Rays are a stack of batches: the last is traced first, so that few wait at any time, however
/// deep light goes. Of a tile the rays that are mirrored are a batch behind those that go through, and have a stack of
/// their own, where they stay until they are traced.
class RayQueue {
public:
    std::vector<QueuedRay> rays, mirrors;
    std::vector<ShadeNode> nodes;  ///< before every node those that wait for it
    std::vector<ShadeTerm> terms;
    std::vector<scene::Color> colors;  ///< by ColorSlot

    /// Empties the queue and gives the first slots to the colours of this many camera rays.
    void start(std::size_t camera_rays);

    ColorSlot new_slot()
    {
        colors.emplace_back();
        return static_cast<ColorSlot>(colors.size() - 1);
    }
    /// The slot of a ray that was written where it waits; straight: as of queue_ray().
    ColorSlot keep(QueuedRay& ray, bool straight)
    {
        ray.slot = new_slot();
        ray.level = straight ? ray.state.level : ray.state.level + 1;
        return ray.slot;
    }
    ShadeNode& new_node(ShadeNode::Kind kind, ColorSlot out);
    /// Adds black terms for a node and returns the index of the first.
    std::uint32_t new_terms(std::size_t count);

    /// Call before a tile is shaded; its rays have left the queue.
    void begin_tile();
    /// Call after a tile is shaded: the rays that it queued become batches.
    void end_tile();
    /// Whether no ray waits.
    bool empty() const { return batches_.empty(); }
    /// Takes at most `most` rays of the last batch; while they are few, the batches before it as well if they fit
    /// whole, since few rays make a poor beam.
    /// \param alike  (kind, kind) -> whether rays of two kinds may be traced together
    /// \return       how many were written to `out`
    template <class F>
    std::size_t take(std::size_t most, QueuedRay* out, F&& alike);
    /// Folds the nodes of every tile of which no ray waits any more.
    void fold();

    /// The sizes of the vectors above when a tile began.
    struct Frame {
        std::size_t rays, mirrors, nodes, terms, colors;
    };
    /// Of the tile at hand.
    const Frame& frame() const { return frames_.back(); }

private:
    /// Rays of a stack; behind them are those of later batches.
    struct Batch {
        std::vector<QueuedRay>* stack;
        std::size_t first, count;
        std::vector<QueuedRay>::iterator begin() const { return stack->begin() + static_cast<std::ptrdiff_t>(first); }
    };
    std::vector<Frame> frames_;
    std::vector<Batch> batches_;
};

template <class F>
std::size_t RayQueue::take(std::size_t most, QueuedRay* out, F&& alike)
{
    constexpr std::size_t kSmall = 16;
    Batch& top = batches_.back();
    if (top.count > most) {
        top.count -= most;
        std::copy_n(top.begin() + static_cast<std::ptrdiff_t>(top.count), most, out);
        top.stack->erase(top.begin() + static_cast<std::ptrdiff_t>(top.count), top.stack->end());
        return most;
    }
    std::size_t from = batches_.size() - 1, taken = top.count;
    for (; from > 0 && taken < kSmall; --from) {
        const Batch &last = batches_[from], &before = batches_[from - 1];
        if (taken + before.count > most || !alike(last.begin()->state.kind, before.begin()->state.kind)) break;
        taken += before.count;
    }
    for (std::size_t i = from; i < batches_.size(); ++i) out = std::copy_n(batches_[i].begin(), batches_[i].count, out);
    for (std::size_t i = batches_.size(); i-- > from;)
        batches_[i].stack->erase(batches_[i].begin(), batches_[i].stack->end());
    batches_.erase(batches_.begin() + static_cast<std::ptrdiff_t>(from), batches_.end());
    return taken;
}

/// A mirrored colour as the finish wants it (spec 3, section 6).
glm::vec3 raised(const scene::Color& c, float exponent);

}  // namespace trace
