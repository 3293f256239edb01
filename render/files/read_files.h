#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace files {

/// What a scene is made from: the files that it read, and what stood in them then, by their hashes. A file that is
/// edited later is another one, however soon that is.
class ReadFiles {
public:
    void text(std::string_view whole);
    /// To call before anything of the file is read.
    void data(const std::string& path);
    /// The scene wrote to one of them.
    void written() { hash_of_.clear(); }

    const std::vector<std::uint64_t>& text_hashes() const { return text_hashes_; }  ///< in order of SourceRef::file
    const std::vector<std::string>& data_files() const { return data_files_; }      ///< in order, as often as named
    const std::vector<std::uint64_t>& data_hashes() const { return data_hashes_; }

private:
    std::vector<std::uint64_t> text_hashes_, data_hashes_;
    std::vector<std::string> data_files_;
    std::unordered_map<std::string, std::uint64_t> hash_of_;
};

}  // namespace files
