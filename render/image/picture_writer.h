#pragma once

#include "render/image/files.h"
#include "render/image/codecs/write/row_sink.h"

#include <memory>
#include <string>
#include <vector>

namespace image {

class IoLoader;

/// A file of this process, whichever machine it runs on, beside `path`, removed unless it was put in place.
class Replacement {
public:
    explicit Replacement(const std::string& path);
    Replacement(const Replacement&) = delete;
    Replacement& operator=(const Replacement&) = delete;
    ~Replacement();
    const std::string& path() const { return path_; }
    const std::string& temporary() const { return temporary_; }
    /// \param lasting  on the disk before it has its name: a machine that loses its power leaves the old or the new
    void put_in_place(bool lasting = false);

private:
    std::string path_, temporary_;
    bool placed_ = false;
};

/// A picture on its way into a file, row by row: a few rows of memory, whatever the size. The file grows beside its
/// final name and takes it in finish(); one that is not finished leaves nothing. Methods throw FileError.
class PictureWriter {
public:
    PictureWriter(IoLoader& loader, const std::string& path, int width, int height, const FileSettings& settings);
    ~PictureWriter();
    /// The row to come, from the top: BMP is rounded from the bottom up, the others from the top down.
    int next_row() const { return bottom_up_ ? height_ - 1 - taken_ : taken_; }
    int taken() const { return taken_; }                                     ///< rows so far
    const std::string& growing() const { return replacement_.temporary(); }  ///< the file, while it is not finished
    /// \param pixels of next_row(), 4 * width, as Image has them
    void put(const float* pixels);
    void finish();

private:
    void put_linear(const float* pixels);
    template <class Work>
    void named(Work&& work) const;

    const int width_, height_;
    const bool bottom_up_, lasting_;
    int taken_ = 0;
    Replacement replacement_;
    TransferCurve working_;  ///< of pixels that are stored as linear light
    bool alpha_ = false;
    std::unique_ptr<RowQuantiser> rounding_;  ///< null: linear light
    std::unique_ptr<RowSink> sink_;
    std::unique_ptr<LevelSink> levels_;  ///< in its place, of linear light
    std::vector<std::uint16_t> row_;
    std::vector<float> level_row_;
};

}  // namespace image
