#pragma once

#include "csg/world/inside_lines.h"
#include "function/field/field.h"
#include "render/plan/compiled_scene.h"
#include "render/scene/base/color.h"
#include "render/kernel/antialias/antialias.h"
#include "render/kernel/path/path_tracer.h"
#include "render/kernel/tile/ray_counts.h"
#include "render/kernel/radiosity/samples/pass_tile.h"

#include <atomic>
#include <span>

/// The interface of a kernel module: everything that runs per ray.
namespace trace {

class BlockTracer;
class PhotonTracer;
struct Record;
struct Emission;
struct IndirectLight;
struct PhotonFlight;
struct PhotonYield;
class JitterStream;

/// Functions of one module. A BlockTracer belongs to one thread and lives inside the module that made it.
struct KernelTable {
    const char* isa;
    /// \param indirect  of the passes before; null: none
    /// \param cancel  see RenderOptions; null: never
    BlockTracer* (*make)(const plan::CompiledScene& scene, const IndirectLight* indirect,
                         const std::atomic<bool>* cancel);
    void (*free)(BlockTracer* tracer);
    /// Colours of the block's pixels, row by row. False: `cancel` was set meanwhile, and the tracer can only be freed.
    bool (*trace)(BlockTracer& tracer, const Block& block, scene::Color* out);
    /// Colours of samples that lie anywhere; neighbours in the list should be neighbours in the picture. False:
    /// cancelled, as above.
    bool (*sample)(BlockTracer& tracer, std::span<const SamplePosition> positions, scene::Color* out);
    /// A tile of a pass of radiosity. False: cancelled, as above.
    bool (*pretrace)(BlockTracer& tracer, const radiosity::PassTile& tile, radiosity::TileFindings& out);
    RayCounts (*counts)(const BlockTracer& tracer);
    /// What the tracer does from now on is written down; null: no more.
    void (*record)(BlockTracer& tracer, Record* into);
    /// A PhotonTracer belongs to one thread, as a BlockTracer does.
    PhotonTracer* (*make_photons)(const plan::CompiledScene& scene, const std::atomic<bool>* cancel);
    void (*free_photons)(PhotonTracer* tracer);
    /// PhotonTracer::follow, and where `jitter` is null count.
    bool (*follow_photons)(PhotonTracer& tracer, const PhotonFlight& flight, std::span<const Emission> photons,
                           const JitterStream* jitter, PhotonYield& out);
    /// A PathTracer belongs to one thread, as a BlockTracer does.
    PathTracer* (*make_paths)(const plan::CompiledScene& scene, const path::Sources& sources,
                              const std::atomic<bool>* cancel);
    void (*free_paths)(PathTracer* tracer);
    bool (*trace_paths)(PathTracer& tracer, std::span<const PathSample> samples, PathFound* out);
    bool (*first_hits)(PathTracer& tracer, std::span<const PathSample> samples, FirstHit* out);
    RayCounts (*path_counts)(const PathTracer& tracer);
    /// InsideLines::chords() of many lines.
    void (*chords)(const csg::InsideLines& of, const csg::LineTile& lines, csg::ChordTile& out);
    function::Evaluators evaluators;  ///< for the fields of solids, which live outside of the module
};

/// The one symbol that a module exports.
inline constexpr const char* kKernelSymbol = "whittle_kernel";
using KernelEntry = const KernelTable* (*)();

}  // namespace trace
