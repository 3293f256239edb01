#pragma once

#include "render/kernel/context/segment_tile.h"
#include "render/kernel/context/shade_scratch.h"
#include "render/kernel/record/record.h"

/// How stages tell what they do (docs/tools/explain.md): tell<&Recorder::what>(scratch, ...).
namespace trace {

/// Writes to a Record what shading with a scratch does. Its members hold what has been told of the current tile, by
/// hit.
class Recorder {
public:
    Recorder(const plan::CompiledScene& scene, ShadeScratch& scratch, Record& into);
    ~Recorder() { scratch_.recorder = nullptr; }
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// An effect has been added to ShadeScratch::air of these segments.
    void air(HitMask segments, RecordedAir::Effect effect);
    /// The pigments of hits' rows on a page are known; clear: the hits whose opacity counts.
    void pigments(RowPage& page, HitMask hits, HitMask clear, const texture::ColorPoints& of);
    /// The colour of a slot is that of one entry of several textures.
    void entry(ColorSlot slot, std::uint32_t entry, bool of_map) { entries_.push_back({slot, entry, of_map}); }
    /// The shadow rays in ShadeScratch::shadow are answered. in_order: ray i is hit i's, not that of its lane.
    void shadow_rays(bool in_order);
    /// Shadow rays of these hits to a node of an area light are answered; lit: hits that see it, filtered: through
    /// something.
    void area_rays(const std::uint32_t* hits, std::size_t count, HitMask lit, HitMask filtered);
    /// A part of what the lamp at hand gives to rows of a page is diffuse light.
    void diffuse(const RowPage& page, HitMask rows, const TileFloats& amount);
    /// The lamp at hand has been asked for these hits. depths: pages of rows.
    void lamp(std::size_t depths, std::size_t number, HitMask asked);
    /// Rows have been given light by a source, or a lamp of this number.
    void gains(std::size_t depths, std::int32_t source);
    /// Of a row that goes through the lamps by itself a part is diffuse light; all so far, with this lamp; it is that
    /// of hit k.
    void scalar_diffuse(const glm::vec3& of) { scalar_diffuse_ += glm::dvec3(of); }
    void scalar_lamp(std::size_t number, const glm::vec3& so_far);
    void scalar_row(std::size_t depth, std::size_t k);
    /// What rays see that meet nothing.
    void sky(HitMask missed, const scene::Color* of);
    /// The tile is through but for its rays. dimmed: segments with air; alone: hits whose colour is that of their rows.
    void tile(const SegmentTile& tile, std::size_t depths, HitMask dimmed, HitMask alone);
    /// A sample of a lens has no ray.
    void no_ray() { ++record_.without_ray; }

private:
    /// Rows of one page.
    struct Depth {
        std::array<glm::vec3, kTileRays> before{};    ///< what they had gained when they were last looked at
        std::array<glm::dvec3, kTileRays> diffuse{};  ///< since then
        std::array<std::vector<RecordedGain>, kTileRays> gains;
    };
    Depth& depth(std::size_t d);
    void shadow_ray(std::size_t k, const csg::Ray& ray, double from, double to, bool blocked, bool filtered);
    void number_slots(const SegmentTile& tile, std::size_t first);
    ColorSlot numbered(ColorSlot slot) const { return slot == kNoSlot ? kNoSlot : slots_[slot]; }
    void add_row(RecordedRay& ray, std::size_t d, std::size_t k);
    void add_nodes(const SegmentTile& tile, const RayQueue::Frame& frame, std::uint32_t first_ray);
    void own_nodes(std::size_t first_node, std::uint32_t ray);

    const plan::CompiledScene& scene_;
    const csg::World world_;
    csg::Scratch geometry_;
    ShadeScratch& scratch_;
    Record& record_;
    std::vector<ColorSlot> slots_;  ///< the record's number for a slot of the queue
    std::array<std::vector<RecordedAir>, kTileRays> air_;
    std::array<std::vector<RecordedLamp>, kTileRays> lamps_;
    std::array<RecordedShadow, kTileRays> shadows_;  ///< of the lamp at hand
    std::array<scene::Color, kTileRays> sky_{};
    std::vector<RecordedEntry> entries_;
    std::vector<Depth> depths_;
    std::vector<RecordedGain> scalar_;  ///< of the row at hand
    glm::vec3 scalar_before_{0};
    glm::dvec3 scalar_diffuse_{0};
};

/// Lets the scratch's recorder hear of something, if it has one.
template <auto Did>
struct Tell;
template <class... Of, void (Recorder::*Did)(Of...)>
struct Tell<Did> {
    // Not inlined and without exceptions: the code around a call keeps its branches, by which the kernels' profile
    // knows it.
    [[gnu::noinline]] static void tell(const ShadeScratch& scratch, Of... of) noexcept
    {
        if (scratch.recorder != nullptr) (scratch.recorder->*Did)(of...);
    }
};
template <auto Did>
inline constexpr auto tell = &Tell<Did>::tell;

}  // namespace trace
