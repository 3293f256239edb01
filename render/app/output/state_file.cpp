#include "render/app/output/state_file.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace app {

namespace {

/// Samples that may wait for the time to come: a run that is cancelled has to write them at once. 64 MB take 0.1 s.
constexpr std::size_t kMostWaiting = 1 << 24;

}  // namespace

StateFile::StateFile(std::string path, BlocksOf of, double after)
    : path_(std::move(path)), of_(std::move(of)),
      due_(Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(after)))
{}

StateFile::Found StateFile::resume(const std::atomic<bool>& cancel, const Show& show)
{
    BlockReader file(path_);
    if (!file.there()) return Found::Nothing;
    if (file.heading() != heading_of(of_)) return Found::OtherPicture;
    done_.assign(of_.blocks.size(), false);
    places_.assign(of_.blocks.size(), 0);
    good_ = file.sound();
    if (!read_records(file, cancel, show)) return Found::Cancelled;
    return resumed_ > 0 ? Found::Blocks : Found::Nothing;
}

/// False: cancelled.
bool StateFile::read_records(BlockReader& file, const std::atomic<bool>& cancel, const Show& show)
{
    Record record;
    std::vector<float> samples;
    while (file.next(record, samples)) {
        if (cancel) return false;
        if (record.number >= of_.blocks.size()) continue;
        show(of_.blocks[record.number], samples.data());
        if (!done_[record.number]) ++resumed_;
        done_[record.number] = true;
        places_[record.number] = file.place();
        good_ = file.sound();
    }
    return true;
}

void StateFile::load(std::size_t first, std::size_t last, image::Image& picture)
{
    if (resumed_ == 0) return;
    BlockReader file(path_);
    std::vector<float> samples;
    for (std::size_t i = first; i < last; ++i) {
        if (!done_[i]) continue;
        if (file.again(places_[i], i, samples)) put_back(of_.blocks[i], samples.data(), picture);
        else done_[i] = false;
    }
}

void StateFile::write_waiting(const image::Image& picture)
{
    if (waiting_.empty() || broken_) return;
    if (!file_) file_ = std::make_unique<BlockWriter>(path_, of_, good_);  // goes on behind what is sound
    for (const std::size_t number : waiting_) file_->put(number, of_.blocks[number], picture);
    broken_ = !file_->flush();
    waiting_.clear();
    waiting_samples_ = 0;
}

void StateFile::finished(std::size_t block, const image::Image& picture)
{
    const std::lock_guard lock(writing_);
    waiting_.push_back(block);
    waiting_samples_ += samples_of(of_.blocks[block]);
    if (waiting_samples_ >= kMostWaiting || Clock::now() >= due_) write_waiting(picture);
}

bool StateFile::keep(const image::Image& picture)
{
    const std::lock_guard lock(writing_);
    write_waiting(picture);
    return !broken_ && (file_ || resumed_ > 0);
}

void StateFile::remove()
{
    file_.reset();
    std::remove(path_.c_str());
}

}  // namespace app
