#include "render/app/base/text.h"
#include "render/app/film/film.h"
#include "render/image/pixels/passing_failure.h"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace app {

void write_by_ffmpeg(const Film& film)
{
    if (std::system("command -v ffmpeg >/dev/null 2>&1") != 0)
        throw image::FileError("cannot write '" + film.out +
                               "': films of that kind are made by the command ffmpeg, which is "
                               "not installed; .png and .gif need none");
    const ScreenFrame first = read_frame(film.frames.front(), nullptr);
    const std::filesystem::path out(film.out);
    const bool webm = same_text(out.extension().string(), ".webm");
    // Beside its name, with the ending that ffmpeg goes by. H.264 halves the colours' columns and rows: they are made
    // even.
    const std::string growing =
        (out.parent_path() / ("." + out.stem().string() + ".growing" + out.extension().string())).string();
    const std::string command = fmt::format(
        "ffmpeg -y -loglevel error -f rawvideo -pix_fmt rgb24 -s {}x{} -r {:g} -i - -vf "
        "'pad=ceil(iw/2)*2:ceil(ih/2)*2' "
        "-pix_fmt yuv420p {} {}",
        first.width, first.height, film.rate,
        webm ? "-c:v libvpx-vp9 -crf 20 -b:v 0" : "-c:v libx264 -crf 16 -movflags +faststart", shell_word(growing));
    const auto before = std::signal(SIGPIPE, SIG_IGN);  // ffmpeg's own words say why it ended
    std::FILE* const pipe = popen(command.c_str(), "w");
    if (pipe == nullptr) image::fail_by_system(errno, "cannot start ffmpeg");
    bool taken = true;
    try {
        for (std::size_t i = 0; i < film.frames.size() && taken; ++i) {
            const ScreenFrame frame = i == 0 ? first : read_frame(film.frames[i], &first);
            taken = std::fwrite(frame.bytes.data(), 1, frame.bytes.size(), pipe) == frame.bytes.size();
        }
    } catch (const image::FileError&) {
        pclose(pipe);
        std::remove(growing.c_str());
        throw;
    }
    const int status = pclose(pipe);
    std::signal(SIGPIPE, before);
    if (!taken || status != 0 || std::rename(growing.c_str(), film.out.c_str()) != 0) {
        std::remove(growing.c_str());
        throw image::FileError("cannot write '" + film.out + "': ffmpeg fails");
    }
}

}  // namespace app
