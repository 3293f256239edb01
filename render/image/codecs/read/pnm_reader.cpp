#include "render/image/codecs/read/direct_readers.h"

#include <cctype>
#include <utility>
#include <vector>

namespace image {
namespace {

/// Numbers of the header, and of the pixels where these are text: between them white space, and comments from # to the
/// end of a line.
class NumberReader {
public:
    NumberReader(const ByteList& bytes, std::size_t at) : bytes_(bytes), at_(at) {}

    int next()
    {
        while (at_ < bytes_.size() && (std::isspace(bytes_[at_]) || bytes_[at_] == '#'))
            if (bytes_[at_++] == '#')
                while (at_ < bytes_.size() && bytes_[at_] != '\n') ++at_;
        if (at_ >= bytes_.size() || !std::isdigit(bytes_[at_])) throw FileError("the PPM file is broken");
        int number = 0;
        for (; at_ < bytes_.size() && std::isdigit(bytes_[at_]); ++at_)
            if (number < kMost) number = 10 * number + (bytes_[at_] - '0');
        return number;
    }
    std::size_t at() const { return at_; }

private:
    static constexpr int kMost = 100'000'000;
    const ByteList& bytes_;
    std::size_t at_;
};

bool is_text(const ByteList& bytes) { return bytes[1] <= '3'; }

}  // namespace

bool is_plain_pnm(const ByteList& bytes)
{
    return bytes.size() > 2 && bytes[0] == 'P' && std::isspace(bytes[2]) &&
           (bytes[1] == '2' || bytes[1] == '3' || bytes[1] == '5' || bytes[1] == '6');
}

Picture decode_pnm(const ByteList& bytes)
{
    Picture out;
    NumberReader numbers(bytes, 2);
    out.width = numbers.next();
    out.height = numbers.next();
    const int most = numbers.next();
    out.channels = bytes[1] == '3' || bytes[1] == '6' ? 3 : 1;
    out.bits = most > 255 ? 16 : 8;
    const std::size_t count = out.count() * static_cast<std::size_t>(out.channels),
                      size = is_text(bytes) ? 1 : static_cast<std::size_t>(out.bits / 8);
    if (out.width == 0 || out.height == 0 || most == 0 || most > 65535) throw FileError("the PPM file is broken");
    if (out.count() > bytes.size() || count * size > bytes.size())
        throw FileError("the PPM file is broken (it ends too early)");
    // Shares of the most, not of 255: POV-Ray rounds to no level (spec 4, 12.10).
    if (is_text(bytes)) {
        std::vector<float> shares(count);
        for (float& share : shares) share = static_cast<float>(numbers.next()) / static_cast<float>(most);
        out.samples = {std::move(shares)};
        return out;
    }
    const std::size_t first = numbers.at() + 1;  // one white space
    if (first > bytes.size() || bytes.size() - first < count * size)
        throw FileError("the PPM file is broken (it ends too early)");
    const std::uint8_t* const at = &bytes[first];
    if (size == 1) {
        out.samples = {std::vector<std::uint8_t>(at, at + count), static_cast<std::uint32_t>(most)};
        return out;
    }
    std::vector<std::uint16_t> levels(count);
    for (std::size_t i = 0; i < count; ++i) levels[i] = static_cast<std::uint16_t>(at[2 * i] << 8 | at[2 * i + 1]);
    out.samples = {std::move(levels), static_cast<std::uint32_t>(most)};
    return out;
}

}  // namespace image
