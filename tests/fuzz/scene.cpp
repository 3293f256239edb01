// Any bytes as a scene: a description or an Error.
#include "parser/parse.h"
#include "tests/fuzz/target.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

void fuzz::one(const Bytes& bytes)
{
    parser::Options options;
    options.most_tokens = 20'000;  // a loop need not end
    options.write_nothing = true;
    try {
        parser::parse_text(text_of(bytes), "fuzz.pov", options);
    } catch (const parser::Error&) {}
}

std::vector<fuzz::Bytes> fuzz::seeds()
{
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(WHITTLE_SCENES))
        if (entry.path().extension() == ".pov" && entry.file_size() < 4096) paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());  // a number means the same input everywhere
    std::vector<Bytes> all;
    for (const auto& path : paths) {
        std::ifstream in(path, std::ios::binary);
        all.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }
    return all;
}
