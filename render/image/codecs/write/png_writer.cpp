#include "render/image/codecs/write/png_writer.h"

#include "numbers/instructions.h"
#include "render/image/pixels/passing_failure.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

namespace image {

namespace {

std::array<std::uint8_t, 4> big_endian(std::uint32_t value)
{
    return {static_cast<std::uint8_t>(value >> 24), static_cast<std::uint8_t>(value >> 16),
            static_cast<std::uint8_t>(value >> 8), static_cast<std::uint8_t>(value)};
}

// What PNG takes from a row before it is packed, sixteen bytes at a time (PNG specification 9.2).

using Byte = std::uint8_t;
using Bytes = __m128i;
constexpr std::size_t kBytes = sizeof(Bytes);  ///< rows have room for as many behind their end

/// By what a byte is predicted: from those to the left, above and above left.
struct Nothing {
    Bytes operator()(Bytes, Bytes, Bytes) const { return _mm_setzero_si128(); }
};
struct Left {
    Bytes operator()(Bytes a, Bytes, Bytes) const { return a; }
};
struct Above {
    Bytes operator()(Bytes, Bytes b, Bytes) const { return b; }
};
/// Half of their sum, rounded down; the machine's own mean is rounded up.
struct Mean {
    Bytes operator()(Bytes a, Bytes b, Bytes) const
    {
        return _mm_sub_epi8(_mm_avg_epu8(a, b), _mm_and_si128(_mm_xor_si128(a, b), _mm_set1_epi8(1)));
    }
};
/// The nearest of left, above and above left to left + above - above left, in this order (9.4).
struct Paeth {
    static Bytes between(Bytes a, Bytes b) { return _mm_or_si128(_mm_subs_epu8(a, b), _mm_subs_epu8(b, a)); }
    static Bytes at_most(Bytes a, Bytes b) { return _mm_cmpeq_epi8(_mm_min_epu8(a, b), a); }
    static Bytes select(Bytes where, Bytes a, Bytes b)
    {
        return _mm_or_si128(_mm_and_si128(where, a), _mm_andnot_si128(where, b));
    }

    Bytes operator()(Bytes a, Bytes b, Bytes c) const
    {
        const Bytes to_a = between(b, c), to_b = between(a, c);
        // Both differences of one sign add up to more than each.
        const Bytes one_sign = _mm_cmpeq_epi8(at_most(c, a), at_most(c, b)),
                    to_c = _mm_or_si128(between(to_a, to_b), one_sign);
        return select(_mm_and_si128(at_most(to_a, to_b), at_most(to_a, to_c)), a, select(at_most(to_b, to_c), b, c));
    }
};

/// A row less what is predicted of it. Before each row lie zeros for the first pixel's left.
/// \param step  bytes of a pixel
/// \returns the sum of what is left, taken as numbers of either sign: small where it packs well (12.8 there)
template <class Predict>
std::uint32_t filter(const Byte* row, const Byte* above, std::size_t size, std::size_t step, Byte* out, Predict predict)
{
    const auto load = [](const Byte* from) { return _mm_loadu_si128(reinterpret_cast<const Bytes*>(from)); };
    const auto store = [](const Bytes& v, Byte* to) { _mm_storeu_si128(reinterpret_cast<Bytes*>(to), v); };
    const Bytes zero = _mm_setzero_si128();
    Bytes sums = zero;
    for (std::size_t i = 0; i < size; i += kBytes) {
        Bytes left =
            _mm_sub_epi8(load(row + i), predict(load(row + i - step), load(above + i), load(above + i - step)));
        store(left, out + i);
        if (size - i < kBytes) {  // what lies behind the row does not count
            Byte last[kBytes] = {};
            std::copy_n(out + i, size - i, last);
            left = load(last);
        }
        sums = _mm_add_epi64(sums, _mm_sad_epu8(_mm_min_epu8(left, _mm_sub_epi8(zero, left)), zero));
    }
    return static_cast<std::uint32_t>(_mm_cvtsi128_si32(sums) + _mm_cvtsi128_si32(_mm_unpackhi_epi64(sums, sums)));
}

}  // namespace

struct PngWriter::Encoder {
    Encoder(const std::string& path, const FileShape& shape, int effort)
        : file(std::fopen(path.c_str(), "wb"), std::fclose), bits(shape.bits)
    {
        if (!file) fail_by_system(errno);
        if (shape.width < 1 || shape.height < 1) throw FileError("PNG takes no picture without pixels");
        if (deflateInit2(&zip, effort, Z_DEFLATED, MAX_WBITS, 8, Z_FILTERED) != Z_OK)
            throw PassingFailure("not enough memory for PNG");
        step = static_cast<std::size_t>(shape.channels) * (bits <= 8 ? 1 : 2);
        size = static_cast<std::size_t>(shape.width) * step;
        row.resize(step + size + kBytes);
        above.resize(row.size());
        best.resize(1 + size + kBytes);
        tried.resize(best.size());
        begin_chunk_data();
    }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;
    ~Encoder() { deflateEnd(&zip); }

    void write(const void* data, std::size_t count)
    {
        if (std::fwrite(data, 1, count, file.get()) != count) fail_by_system(errno);
    }
    void chunk(const char* name, const std::uint8_t* data, std::size_t count)
    {
        const auto* letters = reinterpret_cast<const std::uint8_t*>(name);
        uLong sum = crc32(0, letters, 4);
        if (count > 0) sum = crc32(sum, data, static_cast<uInt>(count));  // of no data zlib would begin anew
        write(big_endian(static_cast<std::uint32_t>(count)).data(), 4);
        write(name, 4);
        write(data, count);
        write(big_endian(static_cast<std::uint32_t>(sum)).data(), 4);
    }
    template <std::size_t N>
    void chunk(const char* name, const std::array<std::uint8_t, N>& data)
    {
        chunk(name, data.data(), N);
    }

    void put_text(const char* key, const std::string& value)
    {
        const std::string text = key + std::string(1, '\0') + value;
        chunk("tEXt", reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    }

    /// The entries before the samples.
    void begin(const FileShape& shape)
    {
        write("\x89PNG\r\n\x1a\n", 8);
        const auto width = big_endian(static_cast<std::uint32_t>(shape.width));
        const auto height = big_endian(static_cast<std::uint32_t>(shape.height));
        constexpr std::array<std::uint8_t, 4> kColorTypes{0, 4, 2, 6};  // grey, with alpha, colours, with alpha
        std::array<std::uint8_t, 13> header{};
        std::copy(width.begin(), width.end(), header.begin());
        std::copy(height.begin(), height.end(), header.begin() + 4);
        header[8] = bits <= 8 ? 8 : 16;
        header[9] = kColorTypes.at(static_cast<std::size_t>(shape.channels - 1));
        chunk("IHDR", header);
        const auto gamma = static_cast<double>(shape.curve.approximate_gamma());
        chunk("gAMA", big_endian(static_cast<std::uint32_t>(std::floor(100000.0 / gamma + 0.5))));
        constexpr std::array<std::uint8_t, 1> kPerceptual{0};
        if (shape.curve.kind == TransferCurve::Kind::Srgb) chunk("sRGB", kPerceptual);
        std::array<std::uint8_t, 4> significant{};
        significant.fill(static_cast<std::uint8_t>(bits));
        chunk("sBIT", significant.data(), static_cast<std::size_t>(shape.channels));
        put_text("Software", shape.software);
        if (!shape.fingerprint.empty()) put_text(kFingerprintKey, shape.fingerprint);
        if (shape.carried)
            chunk(kCarriedChunk, reinterpret_cast<const std::uint8_t*>(shape.carried->data()), shape.carried->size());
    }

    void try_filter(std::uint8_t number, std::uint32_t& least, auto predict)
    {
        const std::uint32_t sum = filter(row.data() + step, above.data() + step, size, step, tried.data() + 1, predict);
        if (number > 0 && sum >= least) return;
        least = sum;
        tried[0] = number;
        best.swap(tried);
    }
    /// The five filters of a row are tried, as the specification counsels.
    void put()
    {
        std::uint32_t least = 0;
        try_filter(0, least, Nothing());
        try_filter(1, least, Left());
        try_filter(2, least, Above());
        try_filter(3, least, Mean());
        try_filter(4, least, Paeth());
        row.swap(above);
        zip.next_in = best.data();
        zip.avail_in = static_cast<uInt>(1 + size);
        while (zip.avail_in > 0) {
            if (deflate(&zip, Z_NO_FLUSH) != Z_OK) throw FileError("zlib failed");
            if (zip.avail_out == 0) end_chunk_data();
        }
    }
    void end()
    {
        for (int state = Z_OK; state != Z_STREAM_END;) {
            state = deflate(&zip, Z_FINISH);
            if (state != Z_OK && state != Z_STREAM_END) throw FileError("zlib failed");
            end_chunk_data();
        }
        chunk("IEND", nullptr, 0);
        if (std::fclose(file.release()) != 0) fail_by_system(errno);  // a full disk may show only now
    }

    void begin_chunk_data()
    {
        zip.next_out = packed.data();
        zip.avail_out = static_cast<uInt>(packed.size());
    }
    void end_chunk_data()
    {
        if (zip.avail_out < packed.size()) chunk("IDAT", packed.data(), packed.size() - zip.avail_out);
        begin_chunk_data();
    }

    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file;
    z_stream zip{};
    int bits;
    std::size_t step, size;  ///< bytes of a pixel and of a row
    /// As PNG stores them: one byte a sample, or two with the high one first; zeros of a pixel before, room behind.
    std::vector<Byte> row, above;
    std::vector<Byte> best, tried;  ///< filtered, behind the filter's number
    std::array<std::uint8_t, 8192> packed;
};

PngWriter::PngWriter(const std::string& path, const FileShape& shape, PngEffort effort)
    : encoder_(std::make_unique<Encoder>(path, shape, static_cast<int>(effort)))
{
    encoder_->begin(shape);
}

PngWriter::~PngWriter() = default;

void PngWriter::put(const std::uint16_t* samples)
{
    std::uint8_t* const row = encoder_->row.data() + encoder_->step;
    const std::size_t size = encoder_->size;
    if (encoder_->bits == 8) {
        std::transform(samples, samples + size, row,
                       [](std::uint16_t sample) { return static_cast<std::uint8_t>(sample); });
    } else if (encoder_->bits < 8) {
        std::transform(samples, samples + size, row, [this](std::uint16_t sample) {
            return static_cast<std::uint8_t>(widened(sample, encoder_->bits) >> 8);
        });
    } else {
        for (std::size_t i = 0; i < size; i += 2) {
            const std::uint16_t wide = widened(samples[i / 2], encoder_->bits);
            row[i] = static_cast<std::uint8_t>(wide >> 8);
            row[i + 1] = static_cast<std::uint8_t>(wide & 0xff);
        }
    }
    encoder_->put();
}

void PngWriter::finish() { encoder_->end(); }

}  // namespace image
