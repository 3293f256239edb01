#pragma once

#include "render/kernel/gather/indirect_light.h"
#include "render/kernel/light/direct_batch.h"
#include "render/kernel/indirect/photon_light.h"
#include "render/kernel/context/segment_tile.h"
#include "render/kernel/radiosity/radiosity_stage.h"
#include "render/kernel/record/recorder.h"
#include "render/kernel/subsurface/subsurface_stage.h"

/// Light that comes from no lamp, over a tile's rows: photons, radiosity, light below the surface.
namespace trace {

class IndirectStage {
public:
    IndirectStage(Context& context, const SegmentTile& tile, DirectBatch& batch)
        : context_(context), tile_(tile), batch_(batch)
    {}

    /// Adds to what the lights have given to the rows (RowPage::gained).
    void run()
    {
        if (context_.scene.subsurface != nullptr) add_below();
        if (context_.indirect != nullptr) add();
    }

private:
    /// Out of line: scenes without such light keep the code of a tile small.
    [[gnu::noinline]] void add()
    {
        PhotonLightStage(context_, tile_, batch_).run();
        tell<&Recorder::gains>(context_.scratch.shade, batch_.depths(), RecordedGain::Photons);
        if (const radiosity::Field* field = context_.indirect->radiosity.get();
            field != nullptr && context_.bounce < field->settings().recursion_limit)
            RadiosityStage(context_, tile_, batch_).run();
        tell<&Recorder::gains>(context_.scratch.shade, batch_.depths(), RecordedGain::Surroundings);
    }

    [[gnu::noinline]] void add_below()
    {
        const radiosity::Field* field = context_.indirect != nullptr ? context_.indirect->radiosity.get() : nullptr;
        if (context_.bounce == 0 || (field != nullptr && field->settings().subsurface))
            add_subsurface_light(context_, tile_, batch_);
        tell<&Recorder::gains>(context_.scratch.shade, batch_.depths(), RecordedGain::Below);
    }

    Context& context_;
    const SegmentTile& tile_;
    DirectBatch& batch_;
};

}  // namespace trace
