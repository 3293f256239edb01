#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace app {

/// Frames of a film, by their files.
struct Film {
    std::string out;
    std::vector<std::string> frames;
    double rate = 25.0;  ///< frames a second
};

/// A frame's pixels as a screen has them: red, green and blue, eight bits each; what is clear stands before black.
struct ScreenFrame {
    int width = 0, height = 0;
    std::vector<std::uint8_t> bytes;
};

/// Throws image::FileError, also where the size is not that of `like`.
ScreenFrame read_frame(const std::string& path, const ScreenFrame* like);

/// An animated PNG with the very pixels of frames that are PNG files of one kind; throws image::FileError.
void write_apng(const Film& film);
/// At most 256 colours a frame; throws image::FileError.
void write_gif(const Film& film);
/// By the command ffmpeg: MP4 (H.264) or WebM (VP9). Throws image::FileError where it is not installed or fails.
void write_by_ffmpeg(const Film& film);

}  // namespace app
