#include "render/app/run/memory.h"

#include "render/app/run/allocation.h"
#include "render/app/run/exit_status.h"
#include "render/app/run/stage_options.h"
#include "render/files/whole_file.h"

#include <sys/resource.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <system_error>

namespace app {

namespace {

/// Of a strip. More saves nothing: threads wait for each other once a strip, for the time of a block.
constexpr double kStrip = 256e6;

/// Bytes that the system has left; infinite if it does not tell.
double left_to_all()
{
    const std::string text = files::whole_file_if("/proc/meminfo").value_or(std::string());
    return number_after(text, "MemAvailable:").value_or(std::numeric_limits<double>::infinity()) * 1024.0;
}

double process_limit()
{
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return std::numeric_limits<double>::infinity();
    return static_cast<double>(limit.rlim_cur);
}

/// Of the file system of the file's folder; infinite where it cannot be found out.
struct Room {
    double left = std::numeric_limits<double>::infinity();  ///< that a user who is not root may fill
    double all = left;
};

Room room_beside(const std::string& path)
{
    std::filesystem::path folder = std::filesystem::path(path).parent_path();
    if (folder.empty()) folder = ".";
    std::error_code error;
    const auto space = std::filesystem::space(folder, error);
    if (error) return {};
    return {static_cast<double>(space.available), static_cast<double>(space.capacity)};
}

std::string readable(double bytes)
{
    for (const auto& [unit, name] : {std::pair{1e12, "TB"}, std::pair{1e9, "GB"}})
        if (bytes >= unit) return fmt::format("{:.1f} {}", bytes / unit, name);
    return fmt::format("{:.1f} MB", bytes / 1e6);
}

image::Encoding asked_encoding(const Settings& settings)
{
    image::Encoding encoding;
    encoding.bits = settings.greyscale ? 16 : settings.bits_per_color;
    encoding.alpha = settings.alpha;
    encoding.greyscale = settings.greyscale;
    return encoding;
}

}  // namespace

double picture_bytes(const Settings& settings) { return kTracedPixelBytes * settings.width * settings.height; }

double picture_memory(const Settings& settings, double needed)
{
    constexpr double kFew = 24e6;
    if (settings.memory > 0.0) return settings.memory;
    if (needed <= kFew) return std::numeric_limits<double>::infinity();
    return std::min({left_to_all(), allocated_memory(), process_limit()}) / 2.0;
}

bool has_memory_for(const Settings& settings, double bytes) { return bytes <= picture_memory(settings, bytes); }

std::size_t rows_of_blocks_in(double memory, const trace::Blocks& blocks, int width, int height, image::FileType type)
{
    const double row = kTracedPixelBytes * width;
    if (row * height <= memory) return blocks.rows();
    if (type == image::FileType::Bmp) return 0;  // its first row is the picture's last
    const double row_of_blocks = row * blocks.side();
    if (row_of_blocks > memory) return 0;
    return std::clamp(static_cast<std::size_t>(std::min(memory, kStrip) / row_of_blocks), std::size_t{1},
                      blocks.rows());
}

void check_fits(const Settings& settings, const std::string& path)
{
    const std::string size = fmt::format("a picture of {}x{}", settings.width, settings.height);
    const bool written = settings.output_to_file;
    const int side = image::largest_side(settings.file_type);
    if (written && std::max(settings.width, settings.height) > side)
        throw OptionError(fmt::format(
            "{} does not fit into this output file type, whose sides are at most {}: use +FN, +FP or +FE", size, side));
    const double memory = picture_memory(settings, picture_bytes(settings));
    const trace::Blocks blocks(plan_options(settings));
    const image::FileType type = written ? settings.file_type : image::FileType::Png;
    if (rows_of_blocks_in(memory, blocks, settings.width, settings.height, type) == 0) {
        if (type == image::FileType::Bmp)
            throw OptionError(fmt::format(
                "{} takes {} of memory, and {} may be used: a BMP cannot grow row by row, use +FN, +FP or +FE", size,
                readable(picture_bytes(settings)), readable(memory)));
        const std::string text = fmt::format("a row of blocks of {} takes {} of memory, and {} may be used: smaller "
                                             "blocks (+BS) or a smaller picture fit",
                                             size, readable(kTracedPixelBytes * settings.width * blocks.side()),
                                             readable(memory));
        if (settings.memory > 0.0) throw OptionError(text);
        throw TryAgain(text);
    }
    if (!written || path.empty()) return;
    const double needed =
        image::least_bytes(settings.file_type, settings.width, settings.height, asked_encoding(settings));
    const Room room = room_beside(path);
    if (needed <= room.left) return;
    const std::string text = fmt::format("{} takes at least {} on disk, and there is room for {} beside '{}'", size,
                                         readable(needed), readable(room.left), path);
    if (needed > room.all) throw OptionError(text);  // nor would there be on an empty disk
    throw TryAgain(text);
}

bool has_room_for_state(const Settings& settings, const std::string& path)
{
    const double pixels = static_cast<double>(settings.width) * settings.height;
    // Not every picture packs well: its plain bytes.
    return kTracedPixelBytes * pixels + 8.0 * pixels <= room_beside(path).left;
}

}  // namespace app
