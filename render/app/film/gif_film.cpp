#include "render/app/film/film.h"

#include "render/image/picture_writer.h"
#include "render/image/pixels/passing_failure.h"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <memory>
#include <numeric>

namespace app {
namespace {

constexpr std::size_t kMostColors = 256;
constexpr int kLevels = 5;  // bits of a channel by which colours are counted

std::size_t bin_of(const std::uint8_t* color)
{
    std::size_t bin = 0;
    for (int c = 0; c < 3; ++c) bin = bin << kLevels | static_cast<std::size_t>(color[c] >> (8 - kLevels));
    return bin;
}

/// The colours of a bin, added up.
struct Bin {
    std::size_t number = 0;
    double count = 0.0;
    std::array<double, 3> sum{};
    double mean(std::size_t c) const { return sum[c] / count; }
};

using Bins = std::vector<Bin>;

/// The channel in which a box is widest, weighted by how many pixels it has, and that weight.
std::pair<std::size_t, double> widest(Bins::const_iterator first, Bins::const_iterator last)
{
    std::pair<std::size_t, double> found{0, 0.0};
    for (std::size_t c = 0; c < 3; ++c) {
        double count = 0.0, sum = 0.0, squares = 0.0;
        for (auto bin = first; bin != last; ++bin) {
            count += bin->count;
            sum += bin->sum[c];
            squares += bin->count * bin->mean(c) * bin->mean(c);
        }
        const double spread = squares - sum * sum / count;
        if (spread > found.second) found = {c, spread};
    }
    return found;
}

struct Palette {
    std::vector<GifColorType> colors;
    std::vector<std::uint8_t> of_bin;
};

/// Heckbert's median cut: the box with the largest spread is cut in two at the mean, until there are colours enough.
Palette palette_of(const ScreenFrame& frame)
{
    Bins all(std::size_t{1} << (3 * kLevels));
    for (std::size_t at = 0; at < frame.bytes.size(); at += 3) {
        Bin& bin = all[bin_of(&frame.bytes[at])];
        bin.count += 1.0;
        for (std::size_t c = 0; c < 3; ++c) bin.sum[c] += frame.bytes[at + c];
    }
    for (std::size_t i = 0; i < all.size(); ++i) all[i].number = i;
    Bins used;
    std::copy_if(all.begin(), all.end(), std::back_inserter(used), [](const Bin& bin) { return bin.count > 0.0; });
    struct Box {
        std::size_t first, last, channel;
        double spread;
    };
    const auto box = [&](std::size_t first, std::size_t last) {
        const auto at = [&](std::size_t i) { return used.cbegin() + static_cast<std::ptrdiff_t>(i); };
        const auto [channel, spread] = widest(at(first), at(last));
        return Box{first, last, channel, last - first > 1 ? spread : 0.0};
    };
    std::vector<Box> boxes{box(0, used.size())};
    while (boxes.size() < kMostColors) {
        auto largest = std::max_element(boxes.begin(), boxes.end(),
                                        [](const Box& a, const Box& b) { return a.spread < b.spread; });
        if (!(largest->spread > 0.0)) break;
        const auto begin = used.begin() + static_cast<std::ptrdiff_t>(largest->first),
                   end = used.begin() + static_cast<std::ptrdiff_t>(largest->last);
        const std::size_t c = largest->channel;
        double count = 0.0, sum = 0.0;
        for (auto bin = begin; bin != end; ++bin) {
            count += bin->count;
            sum += bin->sum[c];
        }
        const auto middle =
            std::stable_partition(begin, end, [&](const Bin& bin) { return bin.mean(c) <= sum / count; });
        const auto cut = static_cast<std::size_t>(middle - used.begin());
        if (cut == largest->first || cut == largest->last) {
            largest->spread = 0.0;
            continue;
        }
        const Box upper = box(cut, largest->last);
        *largest = box(largest->first, cut);
        boxes.push_back(upper);
    }
    Palette out{{}, std::vector<std::uint8_t>(all.size())};
    for (const Box& one : boxes) {
        std::array<double, 3> sum{};
        double count = 0.0;
        for (std::size_t i = one.first; i < one.last; ++i) {
            count += used[i].count;
            for (std::size_t c = 0; c < 3; ++c) sum[c] += used[i].sum[c];
            out.of_bin[used[i].number] = static_cast<std::uint8_t>(out.colors.size());
        }
        const auto level = [&](std::size_t c) { return static_cast<GifByteType>(std::lround(sum[c] / count)); };
        out.colors.push_back({level(0), level(1), level(2)});
    }
    out.colors.resize(kMostColors, {0, 0, 0});
    return out;
}

[[noreturn]] void fail_gif(int code)
{
    const char* const words = GifErrorString(code);
    image::fail_by_system(errno, words != nullptr ? words : "giflib fails");
}

struct CloseGif {
    void operator()(GifFileType* file) const { EGifCloseFile(file, nullptr); }
};

class GifFilm {
public:
    GifFilm(const std::string& path, const ScreenFrame& like, double rate)
        : delay_(static_cast<int>(std::clamp(std::lround(100.0 / rate), 2L, 65535L)))
    {
        int code = 0;
        errno = 0;
        file_.reset(EGifOpenFileName(path.c_str(), false, &code));
        if (!file_) fail_gif(code);
        EGifSetGifVersion(file_.get(), true);
        check(EGifPutScreenDesc(file_.get(), like.width, like.height, 8, 0, nullptr));
        // Again and again, as browsers know it from Netscape.
        const unsigned char forever[] = {1, 0, 0};
        check(EGifPutExtensionLeader(file_.get(), APPLICATION_EXT_FUNC_CODE));
        check(EGifPutExtensionBlock(file_.get(), 11, "NETSCAPE2.0"));
        check(EGifPutExtensionBlock(file_.get(), sizeof forever, forever));
        check(EGifPutExtensionTrailer(file_.get()));
    }

    void put(const ScreenFrame& frame)
    {
        const Palette palette = palette_of(frame);
        const std::unique_ptr<ColorMapObject, void (*)(ColorMapObject*)> map(
            GifMakeMapObject(static_cast<int>(palette.colors.size()), palette.colors.data()), GifFreeMapObject);
        const GraphicsControlBlock control{DISPOSE_DO_NOT, false, delay_, NO_TRANSPARENT_COLOR};
        GifByteType bytes[4];
        const std::size_t count = EGifGCBToExtension(&control, bytes);
        check(EGifPutExtension(file_.get(), GRAPHICS_EXT_FUNC_CODE, static_cast<int>(count), bytes));
        check(EGifPutImageDesc(file_.get(), 0, 0, frame.width, frame.height, false, map.get()));
        std::vector<GifPixelType> row(static_cast<std::size_t>(frame.width));
        for (std::size_t at = 0; at < frame.bytes.size(); at += 3 * row.size()) {
            for (std::size_t x = 0; x < row.size(); ++x) row[x] = palette.of_bin[bin_of(&frame.bytes[at + 3 * x])];
            check(EGifPutLine(file_.get(), row.data(), frame.width));
        }
    }

    void finish()
    {
        int code = 0;
        if (EGifCloseFile(file_.release(), &code) == GIF_ERROR) fail_gif(code);
    }

private:
    void check(int result) const
    {
        if (result == GIF_ERROR) fail_gif(file_->Error);
    }
    std::unique_ptr<GifFileType, CloseGif> file_;
    const int delay_;  ///< hundredths of a second; viewers take less than two for ten
};

}  // namespace

void write_gif(const Film& film)
{
    constexpr int kLargest = 65535;
    image::Replacement replacement(film.out);
    try {
        const ScreenFrame first = read_frame(film.frames.front(), nullptr);
        if (std::max(first.width, first.height) > kLargest)
            throw image::FileError("GIF holds at most 65535 columns and rows");
        GifFilm gif(replacement.temporary(), first, film.rate);
        gif.put(first);
        for (std::size_t i = 1; i < film.frames.size(); ++i) gif.put(read_frame(film.frames[i], &first));
        gif.finish();
    } catch (const image::FileError& error) {
        image::fail_named("cannot write '" + film.out + "': ", error);
    }
    replacement.put_in_place();
}

}  // namespace app
