#include "render/app/join/shelf.h"

#include "render/app/run/exit_status.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <numeric>
#include <set>

namespace app {

namespace {

constexpr std::size_t kMostOpen = 64;  // files; a process may have some hundred

/// Equal for parts of one picture, however it was cut.
std::string kind_of(BlocksOf of)
{
    of.part = of.parts = 1;
    of.wanted.clear();
    return heading_of(of);
}

/// What most of them are; of as many, what comes first.
template <class Value>
Value commonest(const std::vector<Value>& values)
{
    std::map<Value, int> counts;
    for (const Value& value : values) ++counts[value];
    return *std::max_element(values.begin(), values.end(),
                             [&](const Value& a, const Value& b) { return counts[a] < counts[b]; });
}

}  // namespace

Shelf::Shelf(const std::vector<std::string>& paths)
{
    open(paths);
    if (parts_.empty()) return;
    keep_one_kind();
    scan();
    tell_missing();
}

void Shelf::open(const std::vector<std::string>& paths)
{
    for (const std::string& path : paths) {
        errno = 0;
        const BlockReader file(path);
        if (!file.there()) {
            const int why = errno;
            const char* const what = why == ENOENT ? "this part is missing" : std::strerror(why);
            faults_.push_back({fmt::format("{}: {}", path, what), why != EACCES && why != EISDIR});
        } else if (file.strange()) {
            faults_.push_back({path + ": it is no part of a picture", false});
        } else if (!file.of()) {
            faults_.push_back({path + ": it is cut short or damaged", true});
        } else {
            parts_.push_back({path, *file.of()});
        }
    }
}

void Shelf::keep_one_kind()
{
    std::vector<std::string> kinds;
    for (const Part& part : parts_) kinds.push_back(kind_of(part.of));
    const std::string kind = commonest(kinds);
    const auto main = std::find(kinds.begin(), kinds.end(), kind) - kinds.begin();
    of_ = parts_[static_cast<std::size_t>(main)].of;
    std::vector<Part> same;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        if (kinds[i] == kind) {
            same.push_back(std::move(parts_[i]));
            continue;
        }
        const std::string &own = parts_[i].of.file.fingerprint, &others = of_.file.fingerprint;
        faults_.push_back({own != others
                               ? fmt::format("{}: it is of another scene, of other options or of another version "
                                             "(fingerprint {}, that of most is {})",
                                             parts_[i].path, own, others)
                               : fmt::format("{}: it has other layers or blocks than most", parts_[i].path),
                           false});
    }
    parts_ = std::move(same);
}

void Shelf::scan()
{
    blocks_.resize(of_.blocks.size());
    if (!of_.layers.empty()) layer_rows_.resize(static_cast<std::size_t>(of_.height));
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        BlockReader file(parts_[i].path);
        Record record;
        while (file.next(record, samples_)) {
            const bool layer = (record.number & Record::kLayerRow) != 0;
            Place& place = layer ? layer_rows_[record.number ^ Record::kLayerRow] : blocks_[record.number];
            place = {static_cast<std::uint32_t>(i), file.place()};
        }
    }
}

/// Blocks and rows of layers that a part is to have and that no file holds.
std::size_t Shelf::lacking(const BlocksOf& of) const
{
    auto count = std::count_if(of.wanted.begin(), of.wanted.end(),
                               [this](std::uint32_t block) { return blocks_[block].file == kNowhere; });
    for (int row = of.first_layer_row(); row < of.last_layer_row() && !layer_rows_.empty(); ++row)
        count += layer_rows_[static_cast<std::size_t>(row)].file == kNowhere ? 1 : 0;
    return static_cast<std::size_t>(count);
}

void Shelf::tell_missing()
{
    BlocksOf all = of_;
    all.part = all.parts = 1;
    all.wanted.resize(blocks_.size());
    std::iota(all.wanted.begin(), all.wanted.end(), 0u);
    if (lacking(all) == 0) {  // whatever else was given
        std::erase_if(faults_, [](const Fault& fault) { return fault.may_mend; });
        return;
    }
    bool told = std::any_of(faults_.begin(), faults_.end(), [](const Fault& fault) { return fault.may_mend; });
    std::vector<int> numbers;
    for (const Part& part : parts_) {
        numbers.push_back(part.of.parts);
        const std::size_t count = lacking(part.of);
        if (count == 0) continue;
        faults_.push_back(
            {fmt::format("{}: it is cut short or damaged, {} of its blocks are missing", part.path, count), true});
        told = true;
    }
    const int most = commonest(numbers);
    std::set<int> there;
    for (const Part& part : parts_)
        if (part.of.parts == most) there.insert(part.of.part);
    for (int i = 1; i <= most; ++i) {
        if (there.contains(i)) continue;
        faults_.push_back({fmt::format("part {} of {} is missing", i, most), true});
        told = true;
    }
    if (!told)
        faults_.push_back({fmt::format("{} of {} blocks are in no part: the parts are of different cuts", lacking(all),
                                       blocks_.size()),
                           false});
}

void Shelf::read(const Place& place, std::uint64_t number)
{
    if (readers_.size() >= kMostOpen && !readers_.contains(place.file)) readers_.clear();
    const std::string& path = parts_[place.file].path;
    if (!readers_.try_emplace(place.file, path).first->second.again(place.at, number, samples_))
        throw TryAgain(path + ": it has changed while it was read");
}

void Shelf::load(int row, image::Image& picture)
{
    const trace::Block& window = of_.blocks.window();
    picture.width = of_.width;
    if (row < window.top || row >= window.top + window.height) return picture.hold(row, 1);
    const std::size_t first = static_cast<std::size_t>((row - window.top) / of_.blocks.side()) * of_.blocks.per_row();
    const trace::Block left = of_.blocks[first];
    picture.hold(left.top, left.height);
    for (std::size_t i = first; i < first + of_.blocks.per_row(); ++i) {
        read(blocks_[i], i);
        put_back(of_.blocks[i], samples_.data(), picture);
    }
}

const std::vector<float>& Shelf::layer_row(int row)
{
    read(layer_rows_[static_cast<std::size_t>(row)], Record::kLayerRow | static_cast<std::uint64_t>(row));
    return samples_;
}

}  // namespace app
