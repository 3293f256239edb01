#pragma once

#include "render/app/parts/block_file.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace app {

/// What some parts of one picture hold together.
class Shelf {
public:
    struct Fault {
        std::string text;
        bool may_mend;  ///< a task that is run once more brings what is missing
    };

    /// Reads all of the files once and looks at their checks.
    explicit Shelf(const std::vector<std::string>& paths);

    const std::vector<Fault>& faults() const { return faults_; }
    /// Of the parts, if there are any.
    const BlocksOf& of() const { return of_; }

    /// The row of blocks that holds this row of the picture, black where the window has none. Throws
    /// TryAgain where a file has changed since.
    void load(int row, image::Image& picture);
    /// All channels of a row of layers, as they were rendered.
    const std::vector<float>& layer_row(int row);

private:
    static constexpr std::uint32_t kNowhere = 0xffffffffu;
    struct Place {
        std::uint32_t file = kNowhere;
        long at = 0;
    };
    struct Part {
        std::string path;
        BlocksOf of;
    };
    void open(const std::vector<std::string>& paths);
    void keep_one_kind();
    void scan();
    void tell_missing();
    void read(const Place& place, std::uint64_t number);
    std::size_t lacking(const BlocksOf& of) const;

    std::vector<Part> parts_;
    BlocksOf of_;
    std::vector<Place> blocks_, layer_rows_;
    std::vector<Fault> faults_;
    std::map<std::uint32_t, BlockReader> readers_;  ///< by file: some that are open
    std::vector<float> samples_;
};

}  // namespace app
