#pragma once

#include "render/app/picture/picture_run.h"
#include "render/app/output/growing_picture.h"
#include "render/app/output/partial_picture.h"
#include "render/app/output/preview_file.h"
#include "render/app/output/state_file.h"
#include "render/app/output/streamed_file.h"
#include "render/app/picture/picture_part.h"
#include "render/image/picture_writer.h"
#include "render/kernel/gather/indirect_light.h"
#include "render/picture/passes/prepared.h"
#include "render/picture/render.h"

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

namespace app {

/// One picture being made.
class PictureRun {
public:
    PictureRun(const PictureTask& task, StageTimes& times);
    int render();

private:
    bool kept() const
    {
        return !task_.path.empty() && task_.run.settings.output_to_file;
    }  ///< a file that +C can go on with
    bool cancelled() const { return task_.run.cancel.requested; }
    void resume();
    void find_prepared();
    int prepare();
    std::vector<double> coarse_costs();
    bool choose_blocks();
    bool trace_blocks();
    bool finish_part();
    void prepare_strip(std::size_t first, std::size_t last);
    trace::RenderOptions render_options();
    bool find_indirect_light();
    bool trace(std::size_t first, std::size_t last);
    bool trace_samples();
    bool write_rows(int end);
    void put_in_place();
    void tell_far();
    int give_up();
    void save();

    const PictureTask& task_;
    const Settings& settings_;
    StageTimes& times_;
    const trace::Blocks blocks_;
    const std::size_t strip_;   ///< rows of blocks that are in memory at a time
    const bool in_strips_;      ///< not all rows are in memory
    std::vector<bool> others_;  ///< by number: a block that other parts have; empty: there are none
    image::Image picture_;
    trace::RenderStatistics statistics_;
    std::optional<trace::Prepared> prepared_;               ///< found beside the picture by its part
    std::shared_ptr<const trace::IndirectLight> indirect_;  ///< null: the scene has none
    std::unique_ptr<StateFile> state_;
    std::optional<PartialPicture> partial_;
    std::unique_ptr<PreviewFile> preview_;
    std::unique_ptr<GrowingPicture> growing_;
    std::atomic<bool> any_done_ = false;
    std::unique_ptr<PicturePart> part_;  ///< where a part is asked for
    std::optional<StreamedFile> streamed_;
    std::unique_ptr<image::PictureWriter> writer_;
    std::vector<float> black_;  ///< a row outside of the window
};

}  // namespace app
