#pragma once

#include "render/app/parts/block_file.h"
#include "render/image/picture_writer.h"

#include <memory>
#include <string>

namespace app {

/// The part of a picture that --shard asks for, on its way into its file: what was written beside the name takes it
/// when it is whole and on the disk. Methods throw FileError.
class PicturePart {
public:
    PicturePart(const std::string& path, BlocksOf of);
    const BlocksOf& of() const { return of_; }
    const std::string& growing() const { return replacement_.temporary(); }  ///< the file, while it is not finished
    /// Those of the blocks [first, last) that are the part's.
    void put(std::size_t first, std::size_t last, const image::Image& picture);
    void put(const image::Channels& layers);
    void finish();

private:
    BlockWriter& writer();

    const BlocksOf of_;
    image::Replacement replacement_;
    /// Begun when there is something to write: a task that is killed before leaves no file of it.
    std::unique_ptr<BlockWriter> writer_;
};

}  // namespace app
