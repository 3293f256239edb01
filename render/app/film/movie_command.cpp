#include "render/app/film/movie_command.h"

#include "render/app/base/text.h"
#include "render/app/film/film.h"
#include "render/app/options/positive.h"
#include "render/app/run/exit_status.h"
#include "render/image/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace app {
namespace {

constexpr const char* kMovieUsage = R"(usage: whittle join --movie OUT FRAME... [--fps=25]

The frames, in the order in which they stand, as a film: OUT ends in .png or .apng (an animated PNG with the frames' very pixels), .gif (256
colours a frame), .mp4 or .webm (by the command ffmpeg, where it is installed).
Exit status: 0 done; 75 frames are missing, tasks that are run once more may bring them; 1 the film cannot be made.
)";

struct MovieRequest {
    Film film;
    void (*write)(const Film&) = nullptr;
};

MovieRequest request_of(const std::vector<std::string>& arguments)
{
    MovieRequest request;
    std::vector<std::string> names;
    bool options = true;
    for (const std::string& word : arguments) {
        if (options && word == "--") options = false;
        else if (options && word == "--movie") continue;
        else if (options && word.starts_with("--fps="))
            request.film.rate = whole_positive("--fps", word.substr(6), 1000.0);
        else if (options && word.starts_with("--"))
            throw OptionError("unknown option '" + word + "' of whittle join --movie");
        else names.push_back(word);
    }
    if (names.size() < 2)
        throw OptionError("join --movie wants a film and its frames: whittle join --movie OUT FRAME...");
    request.film.out = names.front();
    request.film.frames.assign(names.begin() + 1, names.end());
    const std::string ending = std::filesystem::path(request.film.out).extension().string();
    const auto is = [&](const char* name) { return same_text(ending, name); };
    if (is(".png") || is(".apng")) request.write = write_apng;
    else if (is(".gif")) request.write = write_gif;
    else if (is(".mp4") || is(".webm")) request.write = write_by_ffmpeg;
    else throw OptionError("join --movie writes .png, .apng, .gif, .mp4 and .webm, found '" + request.film.out + "'");
    return request;
}

}  // namespace

std::string movie_help() { return kMovieUsage; }

int movie_command(const std::vector<std::string>& arguments)
{
    const MovieRequest request = request_of(arguments);
    int status = kSuccess;
    for (const std::string& frame : request.film.frames) {
        std::error_code error;
        if (std::filesystem::exists(frame, error)) continue;
        fmt::print(stderr, "whittle: error: missing: {}\n", frame);
        status = kTryAgain;
    }
    if (status != kSuccess) return status;
    request.write(request.film);
    fmt::print(stderr, "{}  {} frames, {:g} a second\n", request.film.out, request.film.frames.size(),
               request.film.rate);
    return kSuccess;
}

ScreenFrame read_frame(const std::string& path, const ScreenFrame* like)
{
    const image::Picture picture = image::Files().read(path);
    if (like != nullptr && (picture.width != like->width || picture.height != like->height))
        throw image::FileError(fmt::format("'{}' is {}x{}, the first frame {}x{}", path, picture.width, picture.height,
                                           like->width, like->height));
    ScreenFrame out{picture.width, picture.height, {}};
    out.bytes.reserve(3 * picture.count());
    const auto byte = [](float value) {
        return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
    };
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const std::array<float, 4> at = picture.at(x, y);
            const bool grey = picture.channels < 3, clear = picture.channels == 4 || picture.channels == 2;
            const float cover = !clear || picture.premultiplied ? 1.0f : at[grey ? 1 : 3];
            for (std::size_t c = 0; c < 3; ++c) out.bytes.push_back(byte(cover * at[grey ? 0 : c]));
        }
    return out;
}

}  // namespace app
