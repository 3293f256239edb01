#include "parser/stream/kept_files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace parser {
namespace {

namespace fs = std::filesystem;

std::string normal(const std::string& path) { return fs::path(path).lexically_normal().string(); }

}  // namespace

std::shared_ptr<std::string> KeptFiles::open(const std::string& path, bool append)
{
    auto text = std::make_shared<std::string>(append ? read(path).value_or(std::string()) : std::string());
    files_[normal(path)] = text;
    return text;
}

std::optional<std::string> KeptFiles::read(const std::string& path) const
{
    if (const std::string* text = find(path)) return *text;
    std::error_code error;
    if (!fs::is_regular_file(path, error)) return std::nullopt;
    std::ifstream in(path, std::ios::binary);
    if (!in) return std::nullopt;
    const std::uintmax_t size = fs::file_size(path, error);
    std::string text;
    text.reserve(error ? 0 : static_cast<std::size_t>(size));
    // In pieces: what resize() clears is still near when it is written.
    constexpr std::size_t kPiece = std::size_t{1} << 17;
    for (std::size_t left = text.capacity() < size || error ? 0 : static_cast<std::size_t>(size); in && left > 0;) {
        const std::size_t begin = text.size(), piece = std::min(left, kPiece);
        text.resize(begin + piece);
        in.read(&text[begin], static_cast<std::streamsize>(piece));
        text.resize(begin + static_cast<std::size_t>(in.gcount()));
        left -= piece;
    }
    // What a file that grows, or says nothing of its size, has beyond.
    if (in) text.append(std::istreambuf_iterator<char>(in), {});
    return text;
}

const std::string* KeptFiles::find(const std::string& path) const
{
    if (!files_.empty())
        if (const auto known = files_.find(normal(path)); known != files_.end()) return known->second.get();
    if (texts_ == nullptr || texts_->empty()) return nullptr;
    std::error_code error;
    const auto open = texts_->find(normal(fs::absolute(path, error).string()));
    return open == texts_->end() ? nullptr : &open->second;
}

}  // namespace parser
