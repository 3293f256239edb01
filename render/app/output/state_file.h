#pragma once

#include "render/app/parts/block_file.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace app {

/// The finished blocks of a picture, kept beside it while it is rendered, so that +C can go on after an end at any
/// moment. A record that was cut short or damaged is dropped, with all behind it.
class StateFile {
public:
    /// \param of  a file of anything else is of no use
    /// \param after seconds of rendering before blocks are kept: short renders need no file
    StateFile(std::string path, BlocksOf of, double after);
    StateFile(const StateFile&) = delete;
    StateFile& operator=(const StateFile&) = delete;

    enum class Found { Nothing, Blocks, OtherPicture, Cancelled };
    using Show = std::function<void(const trace::Block& block, const float* samples)>;
    /// Finds the blocks of an earlier run and shows each. Cancelled: `cancel` was set meanwhile, and the file is as it
    /// was.
    Found resume(const std::atomic<bool>& cancel, const Show& show);
    /// Puts the blocks [first, last) of those into `picture`, which holds their rows. A block that is not in the file
    /// any more is not done.
    void load(std::size_t first, std::size_t last, image::Image& picture);
    /// By number: in the picture already.
    const std::vector<bool>& done() const { return done_; }
    std::size_t resumed() const { return resumed_; }

    /// Notes that a block is finished in the picture, and once `after` seconds are over writes it and all that wait.
    /// From any thread.
    void finished(std::size_t block, const image::Image& picture);
    /// Writes all that wait, as the render ends early. False if no block is finished or the file cannot be written.
    bool keep(const image::Image& picture);
    /// Deletes the file once the picture is in place.
    void remove();

    const std::string& path() const { return path_; }

private:
    using Clock = std::chrono::steady_clock;
    bool read_records(BlockReader& file, const std::atomic<bool>& cancel, const Show& show);
    void write_waiting(const image::Image& picture);

    const std::string path_;
    const BlocksOf of_;
    const Clock::time_point due_;
    std::vector<bool> done_;
    std::vector<long> places_;  ///< by number: where an earlier run's samples stand in the file
    std::size_t resumed_ = 0;
    long good_ = 0;  ///< bytes of an earlier file that are sound
    std::mutex writing_;
    std::vector<std::size_t> waiting_;
    std::size_t waiting_samples_ = 0;
    std::unique_ptr<BlockWriter> file_;
    bool broken_ = false;  ///< cannot be written: the render goes on without
};

}  // namespace app
