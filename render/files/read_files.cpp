#include "render/files/read_files.h"

#include "render/files/hash.h"

namespace files {

void ReadFiles::text(std::string_view whole) { text_hashes_.push_back(hash_of_text(whole)); }

void ReadFiles::data(const std::string& path)
{
    const auto [known, first] = hash_of_.try_emplace(path, 0);
    if (first) known->second = hash_of_file(path);
    data_files_.push_back(path);
    data_hashes_.push_back(known->second);
}

}  // namespace files
