#include "render/image/codecs/read/direct_readers.h"

#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace image {
namespace {

/// One pixel as stored: three mantissas and their exponent.
constexpr std::size_t kPixel = 4;
constexpr int kLeastRun = 8, kMostRun = 0x7fff;  // widths of rows whose four channels are packed one after the other

FileError broken() { return FileError("the Radiance file is broken, or of a variant that is not known"); }

/// The header's lines, an empty one, and the line of the sizes; only pictures of rows from above, from the left.
class Header {
public:
    explicit Header(std::string_view text)
    {
        for (std::string_view line = take_line(text); !line.empty(); line = take_line(text)) {}
        std::string_view sizes = take_line(text);
        height = number_behind(sizes, "-Y ");
        width = number_behind(sizes, " +X ");
        rest = text.size();
    }
    int width = 0, height = 0;
    std::size_t rest = 0;  ///< bytes behind the header

private:
    static std::string_view take_line(std::string_view& text)
    {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) throw broken();
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(end + 1);
        return line;
    }
    static int number_behind(std::string_view& text, std::string_view word)
    {
        if (!text.starts_with(word)) throw broken();
        text.remove_prefix(word.size());
        int number = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc() || number <= 0) throw broken();
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        return number;
    }
};

class RowReader {
public:
    RowReader(const ByteList& bytes, std::size_t at) : bytes_(bytes), at_(at) {}

    void read(std::vector<std::uint8_t>& row)
    {
        const std::size_t width = row.size() / kPixel;
        const bool packed = width >= kLeastRun && width <= kMostRun && bytes_.size() - at_ >= kPixel &&
                            bytes_[at_] == 2 && bytes_[at_ + 1] == 2 &&
                            std::size_t{bytes_[at_ + 2]} * 256 + bytes_[at_ + 3] == width;
        if (!packed) return read_plain(row);
        at_ += kPixel;
        for (std::size_t channel = 0; channel < kPixel; ++channel)
            for (std::size_t x = 0; x < width;) {
                std::size_t length = next();
                const bool repeated = length > 128;
                if (repeated) length -= 128;
                if (length == 0 || length > width - x) throw broken();
                const std::uint8_t value = repeated ? next() : std::uint8_t{0};
                for (; length > 0; --length, ++x) row[kPixel * x + channel] = repeated ? value : next();
            }
    }

private:
    /// Pixels one by one; 1, 1, 1 and a number: the one before so many times, each such in a row counts 256 times more.
    void read_plain(std::vector<std::uint8_t>& row)
    {
        int shift = 0;
        for (std::size_t x = 0; x < row.size() / kPixel;) {
            std::uint8_t* pixel = &row[kPixel * x];
            for (std::size_t c = 0; c < kPixel; ++c) pixel[c] = next();
            if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
                shift = 0;
                ++x;
                continue;
            }
            std::size_t times = std::size_t{pixel[3]} << shift;
            if (x == 0 || times > row.size() / kPixel - x || shift > 16) throw broken();
            for (; times > 0; --times, ++x)
                for (std::size_t c = 0; c < kPixel; ++c) row[kPixel * x + c] = row[kPixel * (x - 1) + c];
            shift += 8;
        }
    }
    std::uint8_t next()
    {
        if (at_ >= bytes_.size()) throw FileError("the Radiance file is broken (it ends too early)");
        return bytes_[at_++];
    }

    const ByteList& bytes_;
    std::size_t at_;
};

}  // namespace

Picture decode_hdr(const ByteList& bytes)
{
    const Header header(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    Picture out;
    out.width = header.width;
    out.height = header.height;
    out.channels = 3;
    out.bits = 32;
    // A packed row has at least two bytes a channel for 127 pixels.
    if (out.count() / 127 > bytes.size()) throw FileError("the Radiance file is broken (it ends too early)");
    std::vector<float> samples;
    samples.reserve(3 * out.count());
    RowReader rows(bytes, bytes.size() - header.rest);
    std::vector<std::uint8_t> row(kPixel * static_cast<std::size_t>(out.width));
    for (int y = 0; y < out.height; ++y) {
        rows.read(row);
        for (std::size_t i = 0; i < row.size(); i += kPixel)
            for (std::size_t c = 0; c < 3; ++c)  // the middle of what is rounded to a mantissa (spec 4, 12.10)
                samples.push_back(
                    row[i + 3] == 0 ? 0.0f : std::ldexp(static_cast<float>(row[i + c]) + 0.5f, row[i + 3] - 136));
    }
    out.samples = {std::move(samples)};
    return out;
}

}  // namespace image
