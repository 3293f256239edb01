#include "parser/stream/texts/source_texts.h"

namespace parser {

scene::LineAndColumn SourceTexts::line_and_column(const scene::SourceRef& at) const
{
    if (at.file >= files_.size() || !at.somewhere()) return {};
    return files_[at.file]->locate(at.offset);
}

std::string SourceTexts::text_from(const Token& token) const
{
    const std::string& text = files_[token.file]->whole_text();
    return token.offset < text.size() ? text.substr(token.offset) : std::string();
}

std::vector<std::string> SourceTexts::files() const
{
    std::vector<std::string> paths;
    for (const auto& source : files_) paths.push_back(source->path);
    return paths;
}

std::vector<scene::LineTable> SourceTexts::lines() const
{
    std::vector<scene::LineTable> all;
    for (const auto& source : files_) all.push_back(source->lines());
    return all;
}

scene::Message SourceTexts::message(scene::Severity severity, const scene::SourceRef& at, std::string_view text) const
{
    scene::Message out{severity, std::string(text), {}, {}, {}, at};
    if (at.file >= files_.size()) return out;
    out.place = {files_[at.file]->path, line_and_column(at)};
    return out;
}

}  // namespace parser
