#pragma once

#include "render/image/files.h"
#include "render/picture/blocks.h"

#include <string>

namespace app {

/// What a render that ended early leaves to look at, NAME.partial.png beside the picture: what is done in its place,
/// the rest black. It has to be there within tenths of a second: not compressed, not dithered, and of a large picture
/// every second or third pixel of a row and of a column.
class PartialPicture {
public:
    /// \param path  of the picture
    /// \param settings  of the picture's file
    /// \param in_strips  only some rows of the picture are in memory at a time
    PartialPicture(const image::Files& files, const std::string& path, int width, int height,
                   image::FileSettings settings, bool in_strips);

    /// Pixels of a picture in strips, 4 a pixel, before they leave the memory. Any thread, if no two show the same.
    void show(const trace::Block& block, const float* samples);
    /// The same of all rows that the picture holds.
    void show(const image::Image& picture);

    /// \param picture as far as it is in memory \return the file; empty if it cannot be written
    std::string write(const image::Image& picture);
    /// The picture is in place: no longer needed.
    void remove() const;

private:
    void show_row(int left, int width, int row, const float* samples);
    const image::Files& files_;
    const std::string path_;
    image::FileSettings settings_;
    const int step_;      ///< one pixel of so many, across and down
    image::Image small_;  ///< of a picture in strips
    const bool in_strips_;
};

}  // namespace app
