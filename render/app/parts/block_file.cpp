#include "render/app/parts/block_file.h"

#include "render/files/hash.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace app {

namespace {

constexpr std::string_view kBlocksMagic = "whittle blocks 1";

struct Heading {
    char magic[16];
    std::uint64_t fingerprint;
    std::uint64_t wanted;  ///< numbers of blocks, which follow behind the text
    std::int32_t width, height, side, window[4], part, parts;
    std::int32_t type, bits, alpha, greyscale, dither, quality;
    std::int32_t working_kind, file_kind;
    float working_gamma, file_gamma;
    std::uint32_t layers, text;  ///< channels; bytes of their names and attributes, which follow
    std::uint32_t none;
    std::uint64_t check;  ///< hash of all else
};
static_assert(std::is_trivially_copyable_v<Heading> && std::has_unique_object_representations_v<Record>);

constexpr std::int32_t kMostParts = 1'000'000;
constexpr int kLayerRows = 8;  // that are made together

std::uint64_t check_of(Heading heading, const std::string& text, const std::vector<std::uint32_t>& wanted)
{
    heading.check = 0;
    return files::hash_of(wanted.data(), wanted.size() * sizeof(std::uint32_t),
                          files::hash_of(text.data(), text.size(), files::hash_of(&heading, sizeof heading)));
}

std::string bytes_of(const Heading& heading, const std::string& text, const std::vector<std::uint32_t>& wanted)
{
    std::string bytes(reinterpret_cast<const char*>(&heading), sizeof heading);
    bytes += text;
    return bytes.append(reinterpret_cast<const char*>(wanted.data()), wanted.size() * sizeof(std::uint32_t));
}

std::uint64_t check_of(std::uint64_t number, const std::vector<float>& samples)
{
    return files::hash_of(samples.data(), samples.size() * sizeof(float), files::hash_of(&number, sizeof number));
}

void put_curve(const image::TransferCurve& curve, std::int32_t& kind, float& gamma)
{
    kind = static_cast<std::int32_t>(curve.kind);
    gamma = curve.gamma;
}

bool known(const Heading& h)
{
    constexpr std::string_view kTypes = "NPTCJBEH";
    const auto within = [](std::int64_t least, std::int64_t value, std::int64_t most) {
        return least <= value && value <= most;
    };
    const std::int32_t* w = h.window;
    return within(1, h.width, 1 << 30) && within(1, h.height, 1 << 30) && within(1, h.side, 1 << 20) &&
           within(0, w[0], h.width) && within(0, w[1], h.height) && within(1, w[2], h.width - w[0]) &&
           within(1, w[3], h.height - w[1]) && within(1, h.parts, kMostParts) && within(1, h.part, h.parts) &&
           within(0, h.type, 127) && kTypes.find(static_cast<char>(h.type)) != std::string_view::npos &&
           within(1, h.bits, 16) && within(0, h.dither, static_cast<int>(image::Dither::kLast)) &&
           within(0, h.working_kind, 4) && within(0, h.file_kind, 4) && h.layers <= (1u << 16);
}

/// Texts one after the other, each ended by a zero.
std::string text_of(const BlocksOf& of)
{
    std::string out;
    const auto add = [&out](const std::string& text) { (out += text) += '\0'; };
    for (const std::string& name : of.layers) add(name);
    for (const auto& [key, value] : of.attributes) {
        add(key);
        add(value);
    }
    return out;
}

std::optional<BlocksOf> unpacked(const Heading& h, const std::string& text, std::vector<std::uint32_t> wanted)
{
    BlocksOf of;
    of.width = h.width;
    of.height = h.height;
    of.blocks = trace::Blocks({h.window[0], h.window[1], h.window[2], h.window[3]}, h.side);
    of.wanted = std::move(wanted);
    of.part = h.part;
    of.parts = h.parts;
    if (!std::is_sorted(of.wanted.begin(), of.wanted.end()) ||
        (!of.wanted.empty() && of.wanted.back() >= of.blocks.size()))
        return std::nullopt;
    of.file.type = static_cast<image::FileType>(h.type);
    of.file.jpeg_quality = h.quality;
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(h.fingerprint));
    of.file.fingerprint = digits;
    image::Encoding& encoding = of.file.encoding;
    encoding.bits = h.bits;
    encoding.alpha = h.alpha != 0;
    encoding.greyscale = h.greyscale != 0;
    encoding.dither = static_cast<image::Dither>(h.dither);
    encoding.curves.working = {static_cast<image::TransferCurve::Kind>(h.working_kind), h.working_gamma};
    encoding.curves.file = {static_cast<image::TransferCurve::Kind>(h.file_kind), h.file_gamma};
    std::vector<std::string> texts;
    for (std::size_t at = 0; at < text.size(); at += texts.back().size() + 1) texts.emplace_back(&text[at]);
    if (texts.size() < h.layers || (texts.size() - h.layers) % 2 != 0) return std::nullopt;
    of.layers.assign(texts.begin(), texts.begin() + h.layers);
    for (std::size_t i = h.layers; i < texts.size(); i += 2) of.attributes.emplace_back(texts[i], texts[i + 1]);
    return of;
}

}  // namespace

int BlocksOf::layer_row(int parts_before) const
{
    const std::int64_t squares = (height - 1) / kLayerRows + 1;
    return std::min(height, static_cast<int>(squares * parts_before / parts) * kLayerRows);
}

std::string heading_of(const BlocksOf& of)
{
    Heading h{};
    std::memcpy(h.magic, kBlocksMagic.data(), kBlocksMagic.size());
    h.fingerprint = std::strtoull(of.file.fingerprint.c_str(), nullptr, 16);
    h.wanted = of.wanted.size();
    h.width = of.width;
    h.height = of.height;
    h.side = of.blocks.side();
    const trace::Block& window = of.blocks.window();
    h.window[0] = window.left;
    h.window[1] = window.top;
    h.window[2] = window.width;
    h.window[3] = window.height;
    h.part = of.part;
    h.parts = of.parts;
    const image::Encoding& encoding = of.file.encoding;
    h.type = static_cast<std::int32_t>(of.file.type);
    h.bits = encoding.bits;
    h.alpha = encoding.alpha ? 1 : 0;
    h.greyscale = encoding.greyscale ? 1 : 0;
    h.dither = static_cast<std::int32_t>(encoding.dither);
    h.quality = of.file.jpeg_quality;
    put_curve(encoding.curves.working, h.working_kind, h.working_gamma);
    put_curve(encoding.curves.file, h.file_kind, h.file_gamma);
    const std::string text = text_of(of);
    h.layers = static_cast<std::uint32_t>(of.layers.size());
    h.text = static_cast<std::uint32_t>(text.size());
    h.check = check_of(h, text, of.wanted);
    return bytes_of(h, text, of.wanted);
}

std::size_t samples_of(const trace::Block& block)
{
    return 4 * static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height);
}

void put_back(const trace::Block& block, const float* samples, image::Image& picture)
{
    const std::size_t row_length = 4 * static_cast<std::size_t>(block.width);
    for (int row = 0; row < block.height; ++row)
        std::memcpy(picture.at(block.left, block.top + row), samples + static_cast<std::size_t>(row) * row_length,
                    row_length * sizeof(float));
}

BlockReader::BlockReader(const std::string& path) : file_(std::fopen(path.c_str(), "rb"), std::fclose)
{
    if (file_) read_heading();
}

void BlockReader::read_heading()
{
    Heading h;
    const std::size_t count = std::fread(&h, 1, sizeof h, file_.get());
    strange_ = std::memcmp(h.magic, kBlocksMagic.data(), std::min(count, kBlocksMagic.size())) != 0;
    struct stat status {};
    if (strange_ || count != sizeof h || !known(h) || fstat(fileno(file_.get()), &status) != 0) return;
    const auto size = static_cast<std::uint64_t>(status.st_size);
    if (h.text > size || h.wanted > size / sizeof(std::uint32_t)) return;  // no memory for what is not there
    std::string text(h.text, '\0');
    if (std::fread(text.data(), 1, text.size(), file_.get()) != text.size()) return;
    std::vector<std::uint32_t> wanted(h.wanted);
    if (std::fread(wanted.data(), sizeof(std::uint32_t), wanted.size(), file_.get()) != wanted.size() ||
        h.check != check_of(h, text, wanted) || (!text.empty() && text.back() != '\0'))
        return;
    heading_ = bytes_of(h, text, wanted);
    of_ = unpacked(h, text, std::move(wanted));
    place_ = sound_ = std::ftell(file_.get());
}

bool BlockReader::next(Record& record, std::vector<float>& samples)
{
    const long place = sound_;
    if (!of_ || std::fread(&record, sizeof record, 1, file_.get()) != 1) return false;
    if ((record.number & Record::kLayerRow) != 0) {
        if ((record.number ^ Record::kLayerRow) >= static_cast<std::uint64_t>(of_->height)) return false;
        samples.resize(of_->layers.size() * static_cast<std::size_t>(of_->width));
    } else {
        if (record.number >= of_->blocks.size()) return false;
        samples.resize(samples_of(of_->blocks[record.number]));
    }
    if (std::fread(samples.data(), sizeof(float), samples.size(), file_.get()) != samples.size() ||
        check_of(record.number, samples) != record.check)
        return false;
    place_ = place;
    sound_ = std::ftell(file_.get());
    return true;
}

bool BlockReader::again(long place, std::uint64_t number, std::vector<float>& samples)
{
    Record record;
    sound_ = place;
    return file_ && std::fseek(file_.get(), place, SEEK_SET) == 0 && next(record, samples) && record.number == number;
}

std::optional<std::string> whole_part(const std::string& path)
{
    BlockReader file(path);
    if (!file.of()) return std::nullopt;
    const BlocksOf& of = *file.of();
    std::size_t lacking = of.wanted.size();
    if (!of.layers.empty()) lacking += static_cast<std::size_t>(of.last_layer_row() - of.first_layer_row());
    Record record;
    std::vector<float> samples;
    while (file.next(record, samples)) --lacking;  // nothing else is in it, and nothing twice
    return lacking == 0 ? std::optional(of.file.fingerprint) : std::nullopt;
}

BlockWriter::BlockWriter(const std::string& path, const BlocksOf& of, long after) : file_(nullptr, std::fclose)
{
    if (after > 0) expect(truncate(path.c_str(), after) == 0);
    if (error_ == 0) file_.reset(std::fopen(path.c_str(), after > 0 ? "ab" : "wb"));
    expect(file_ != nullptr);
    if (error_ != 0 || after > 0) return;
    const std::string heading = heading_of(of);
    expect(std::fwrite(heading.data(), 1, heading.size(), file_.get()) == heading.size());
}

void BlockWriter::expect(bool done)
{
    if (!done && error_ == 0) error_ = errno != 0 ? errno : EIO;
}

void BlockWriter::put(std::uint64_t number, const std::vector<float>& samples)
{
    if (error_ != 0) return;
    const Record record{number, check_of(number, samples)};
    expect(std::fwrite(&record, sizeof record, 1, file_.get()) == 1 &&
           std::fwrite(samples.data(), sizeof(float), samples.size(), file_.get()) == samples.size());
}

void BlockWriter::put(std::size_t number, const trace::Block& block, const image::Image& picture)
{
    samples_.clear();
    for (int row = 0; row < block.height; ++row) {
        const float* from = picture.at(block.left, block.top + row);
        samples_.insert(samples_.end(), from, from + 4 * block.width);
    }
    put(number, samples_);
}

bool BlockWriter::flush()
{
    if (error_ == 0) expect(std::fflush(file_.get()) == 0);
    return error_ == 0;
}

bool BlockWriter::finish()
{
    if (!flush()) return false;
    expect(fsync(fileno(file_.get())) == 0);
    expect(std::fclose(file_.release()) == 0);
    return error_ == 0;
}

}  // namespace app
