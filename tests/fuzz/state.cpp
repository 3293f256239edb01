// The finished blocks that an interrupted render keeps. The first byte is odd where the magic, the sizes and the
// checksums are put right first: else few inputs would come past them.
#include "render/app/output/state_file.h"
#include "render/files/hash.h"
#include "tests/fuzz/scratch_file.h"

#include <algorithm>
#include <atomic>
#include <cstring>

namespace {

constexpr int kWide = 10, kHigh = 7, kSide = 4;
constexpr std::size_t kRecordSize = 16;

trace::Blocks blocks() { return {{0, 0, kWide, kHigh}, kSide}; }

app::BlocksOf whole_of_it()
{
    app::BlocksOf of;
    of.width = kWide;
    of.height = kHigh;
    of.blocks = blocks();
    of.file.fingerprint = "1234";
    return of;
}

const std::size_t kHeaderSize = app::heading_of(whole_of_it()).size();

image::Image picture()
{
    image::Image image;
    image.width = kWide;
    image.height = kHigh;
    for (int i = 0; i < 4 * kWide * kHigh; ++i) image.pixels.push_back(static_cast<float>(i));
    return image;
}

/// A file of the first `count` blocks.
fuzz::Bytes kept(std::size_t count)
{
    const fuzz::ScratchFile file(".kept");
    app::StateFile state(file.path(), whole_of_it(), 0.0);
    const image::Image whole = picture();
    for (std::size_t i = 0; i < count; ++i) state.finished(i, whole);
    std::FILE* in = std::fopen(file.path().c_str(), "rb");
    fuzz::Bytes bytes(1, 0);
    for (int c = 0; in != nullptr && (c = std::fgetc(in)) != EOF;) bytes.push_back(static_cast<std::uint8_t>(c));
    if (in != nullptr) std::fclose(in);
    return bytes;
}

template <class T>
T taken(const fuzz::Bytes& bytes, std::size_t at)
{
    T value;
    std::memcpy(&value, &bytes[at], sizeof value);
    return value;
}

void put_right(fuzz::Bytes& bytes)
{
    static const fuzz::Bytes header = kept(1);
    if (bytes.size() < kHeaderSize) return;
    std::copy_n(header.begin() + 1, kHeaderSize, bytes.begin());
    const trace::Blocks all = blocks();
    for (std::size_t at = kHeaderSize; at + kRecordSize <= bytes.size();) {
        const auto number = taken<std::uint64_t>(bytes, at);
        if (number >= all.size()) return;
        const std::size_t size = 16 * static_cast<std::size_t>(all[number].width) *
                                 static_cast<std::size_t>(all[number].height);
        if (at + kRecordSize + size > bytes.size()) return;
        const std::uint64_t check =
            files::hash_of(&bytes[at + kRecordSize], size, files::hash_of(&number, sizeof number));
        std::memcpy(&bytes[at + 8], &check, sizeof check);
        at += kRecordSize + size;
    }
}

}  // namespace

void fuzz::one(const Bytes& bytes)
{
    if (bytes.empty()) return;
    Bytes file_bytes(bytes.begin() + 1, bytes.end());
    if (bytes[0] % 2 == 1) put_right(file_bytes);
    static const ScratchFile file(".whittle-state");
    app::StateFile state(file.holding(file_bytes), whole_of_it(), 0.0);
    const std::atomic<bool> cancel = false;
    const auto found = [&](app::StateFile& file_of_blocks, image::Image& image) {
        image = picture();
        std::size_t shown = 0;
        const app::StateFile::Found what =
            file_of_blocks.resume(cancel, [&](const trace::Block& block, const float* samples) {
                require(block.left >= 0 && block.top >= 0 && block.left + block.width <= kWide &&
                            block.top + block.height <= kHigh && samples != nullptr,
                        "a block outside the picture");
                ++shown;
            });
        require(shown >= file_of_blocks.resumed(), "blocks are not shown");
        file_of_blocks.load(0, blocks().size(), image);
        return what;
    };
    image::Image image;
    const app::StateFile::Found what = found(state, image);
    const auto done = static_cast<std::size_t>(std::count(state.done().begin(), state.done().end(), true));
    require((what == app::StateFile::Found::Blocks) == (state.resumed() > 0) && done == state.resumed(),
            "the count of blocks is wrong");
    // The render goes on: what was not there is added, and all of it is found again.
    const image::Image whole = picture();
    for (std::size_t i = 0; i < blocks().size(); ++i)
        if (done == 0 || !state.done()[i]) state.finished(i, whole);
    app::StateFile again(file.path(), whole_of_it(), 0.0);
    require(found(again, image) == app::StateFile::Found::Blocks && again.resumed() == blocks().size(),
            "blocks are lost");
}

std::vector<fuzz::Bytes> fuzz::seeds()
{
    std::vector<Bytes> all = {kept(1), kept(6)};
    for (std::size_t i = 0; i < 2; ++i) {
        all.push_back(all[i]);
        all.back()[0] = 1;
    }
    return all;
}
