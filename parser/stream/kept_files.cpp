#include "parser/stream/kept_files.h"

#include "render/files/whole_file.h"

#include <filesystem>

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
    return files::whole_file_if(path);
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
