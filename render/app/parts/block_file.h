#pragma once

#include "render/image/files.h"
#include "render/picture/blocks.h"

#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Files of traced blocks: the state that +C goes on from, and the parts that `whittle join` makes a picture of. A
/// heading, then records, each with its check: blocks, and rows of layers.
namespace app {

/// What a file of blocks is of.
struct BlocksOf {
    int width = 0, height = 0;
    trace::Blocks blocks;
    image::FileSettings file;  ///< how the picture is written, with its fingerprint
    int part = 1, parts = 1;
    std::vector<std::uint32_t> wanted;  ///< the blocks that are to be in it, ascending; of a state not told
    std::vector<std::string> layers;    ///< channels of the layers beside the picture; empty: none
    std::vector<std::pair<std::string, std::string>> attributes;  ///< of those

    /// Rows of layers that are to be in it: as many as whole squares of rays.
    int first_layer_row() const { return layer_row(part - 1); }
    int last_layer_row() const { return layer_row(part); }

private:
    int layer_row(int parts_before) const;
};

/// One thing in a file of blocks.
struct Record {
    static constexpr std::uint64_t kLayerRow = std::uint64_t{1} << 63;
    std::uint64_t number = 0;  ///< of a block, or kLayerRow and the number of a row
    std::uint64_t check = 0;   ///< hash of the samples and the number
};

/// The heading as it stands in a file: files of one heading are of one thing.
std::string heading_of(const BlocksOf& of);

class BlockReader {
public:
    explicit BlockReader(const std::string& path);
    bool there() const { return file_ != nullptr; }
    /// What the file is of. Nothing: its heading is cut short or damaged, or it is of another kind (see strange()).
    const std::optional<BlocksOf>& of() const { return of_; }
    bool strange() const { return strange_; }  ///< it begins otherwise than a file of blocks
    const std::string& heading() const { return heading_; }

    /// The next record that is whole. False: there is none, or what follows is damaged.
    bool next(Record& record, std::vector<float>& samples);
    /// Where the record that next() gave begins, and where it ends.
    long place() const { return place_; }
    long sound() const { return sound_; }
    /// The record at a place that next() told. False: it is not there any more.
    bool again(long place, std::uint64_t number, std::vector<float>& samples);

private:
    void read_heading();
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    std::string heading_;
    std::optional<BlocksOf> of_;
    bool strange_ = false;
    long place_ = 0, sound_ = 0;
};

class BlockWriter {
public:
    /// \param after  bytes of the file that is there after which is written; 0: a new file
    BlockWriter(const std::string& path, const BlocksOf& of, long after);
    void put(std::uint64_t number, const std::vector<float>& samples);
    void put(std::size_t number, const trace::Block& block, const image::Image& picture);
    /// Whether all that was put is with the system.
    bool flush();
    /// Whether all of it is on the disk, and the file is closed.
    bool finish();
    int error() const { return error_; }  ///< the system's number of what failed first; 0: nothing

private:
    void expect(bool done);
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    int error_ = 0;
    std::vector<float> samples_;
};

/// The fingerprint of a part that holds all that is to be in it; nothing where it lacks something.
std::optional<std::string> whole_part(const std::string& path);

std::size_t samples_of(const trace::Block& block);
/// Samples of a block into the picture, which holds its rows.
void put_back(const trace::Block& block, const float* samples, image::Image& picture);

}  // namespace app
