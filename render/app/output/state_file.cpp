#include "render/app/output/state_file.h"

#include "render/image/pixels/passing_failure.h"

#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace app {

namespace {

struct Header {
    char magic[16] = "whittle state 2";
    std::uint64_t identity = 0;
    std::int32_t width = 0, height = 0;
    std::uint64_t blocks = 0;
};

struct Record {
    std::uint64_t block = 0;
    std::uint64_t check = 0;  ///< hash of the samples and the number
};

/// Samples that may wait for the time to come: a run that is cancelled has to write them at once. 64 MB take 0.1 s.
constexpr std::size_t kMostWaiting = 1 << 24;

std::size_t samples_of(const trace::Block& block)
{
    return 4 * static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height);
}

std::vector<float> cut_out(const trace::Block& block, const image::Image& picture)
{
    std::vector<float> samples;
    samples.reserve(samples_of(block));
    for (int row = 0; row < block.height; ++row) {
        const float* from = picture.at(block.left, block.top + row);
        samples.insert(samples.end(), from, from + 4 * block.width);
    }
    return samples;
}

void put_back(const trace::Block& block, const float* samples, image::Image& picture)
{
    const std::size_t row_length = 4 * static_cast<std::size_t>(block.width);
    for (int row = 0; row < block.height; ++row)
        std::memcpy(picture.at(block.left, block.top + row), samples + static_cast<std::size_t>(row) * row_length,
                    row_length * sizeof(float));
}

std::uint64_t check_of(std::uint64_t number, const std::vector<float>& samples)
{
    return hash_of(samples.data(), samples.size() * sizeof(float), hash_of(&number, sizeof number));
}

}  // namespace

std::uint64_t hash_of(const void* bytes, std::size_t count, std::uint64_t so_far)
{
    const auto* byte = static_cast<const unsigned char*>(bytes);
    for (std::size_t i = 0; i < count; i += sizeof(std::uint64_t)) {
        std::uint64_t word = 0;
        std::memcpy(&word, byte + i, std::min(sizeof word, count - i));
        so_far = (so_far ^ word) * 0x100000001b3ULL;
        so_far ^= so_far >> 32;  // a product never carries upper bits down
    }
    return so_far;
}

StateFile::StateFile(std::string path, std::function<std::uint64_t()> identity, const trace::Blocks& blocks,
                     double after)
    : path_(std::move(path)), identity_(std::move(identity)), blocks_(blocks),
      due_(Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(after)))
{}

StateFile::Found StateFile::resume(int width, int height, const std::atomic<bool>& cancel, const Show& show)
{
    const File file(std::fopen(path_.c_str(), "rb"), std::fclose);
    if (!file) return Found::Nothing;
    Header header;
    const Header wanted;
    if (std::fread(&header, sizeof header, 1, file.get()) != 1 ||
        std::memcmp(header.magic, wanted.magic, sizeof header.magic) != 0 || header.identity != identity_() ||
        header.width != width || header.height != height || header.blocks != blocks_.size())
        return Found::OtherPicture;
    done_.assign(blocks_.size(), false);
    places_.assign(blocks_.size(), 0);
    good_ = sizeof header;
    if (!read_records(file.get(), cancel, show)) return Found::Cancelled;
    return resumed_ > 0 ? Found::Blocks : Found::Nothing;
}

/// False: cancelled.
bool StateFile::read_records(std::FILE* file, const std::atomic<bool>& cancel, const Show& show)
{
    Record record;
    std::vector<float> samples;
    while (std::fread(&record, sizeof record, 1, file) == 1 && record.block < blocks_.size()) {
        if (cancel) return false;
        const trace::Block block = blocks_[record.block];
        samples.resize(samples_of(block));
        const long place = std::ftell(file);
        if (std::fread(samples.data(), sizeof(float), samples.size(), file) != samples.size() ||
            check_of(record.block, samples) != record.check)
            return true;
        show(block, samples.data());
        if (!done_[record.block]) ++resumed_;
        done_[record.block] = true;
        places_[record.block] = place;
        good_ = std::ftell(file);
    }
    return true;
}

void StateFile::load(std::size_t first, std::size_t last, image::Image& picture)
{
    if (resumed_ == 0) return;
    const File file(std::fopen(path_.c_str(), "rb"), std::fclose);
    std::vector<float> samples;
    for (std::size_t i = first; i < last; ++i) {
        if (!done_[i]) continue;
        const trace::Block block = blocks_[i];
        samples.resize(samples_of(block));
        if (!file || std::fseek(file.get(), places_[i], SEEK_SET) != 0 ||
            std::fread(samples.data(), sizeof(float), samples.size(), file.get()) != samples.size())
            throw image::PassingFailure("cannot read '" + path_ + "' any more");
        put_back(block, samples.data(), picture);
    }
}

bool StateFile::open_for_writing(const image::Image& picture)
{
    if (file_ || broken_) return !broken_;
    if (good_ > 0) {  // goes on behind what is sound
        broken_ = truncate(path_.c_str(), good_) != 0;
        file_.reset(broken_ ? nullptr : std::fopen(path_.c_str(), "ab"));
    } else {
        Header header;
        header.identity = identity_();
        header.width = picture.width;
        header.height = picture.height;
        header.blocks = blocks_.size();
        file_.reset(std::fopen(path_.c_str(), "wb"));
        if (file_ && std::fwrite(&header, sizeof header, 1, file_.get()) != 1) broken_ = true;
    }
    broken_ = broken_ || !file_;
    return !broken_;
}

void StateFile::write_waiting(const image::Image& picture)
{
    if (waiting_.empty() || !open_for_writing(picture)) return;
    for (const std::size_t number : waiting_) {
        const std::vector<float> samples = cut_out(blocks_[number], picture);
        const Record record{number, check_of(number, samples)};
        broken_ = broken_ || std::fwrite(&record, sizeof record, 1, file_.get()) != 1 ||
                  std::fwrite(samples.data(), sizeof(float), samples.size(), file_.get()) != samples.size();
    }
    broken_ = std::fflush(file_.get()) != 0 || broken_;
    waiting_.clear();
    waiting_samples_ = 0;
}

void StateFile::finished(std::size_t block, const image::Image& picture)
{
    const std::lock_guard lock(writing_);
    waiting_.push_back(block);
    waiting_samples_ += samples_of(blocks_[block]);
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
