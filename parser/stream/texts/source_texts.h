#pragma once

#include "parser/lexer/lexer.h"
#include "render/scene/base/message.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace parser {

/// The texts that were read so far, as tokens, and the places in them. SourceRef::file and Token::file count them from
/// 0, the scene's own; tokens never move.
class SourceTexts {
public:
    scene::SourceRef place(const Token& token) const
    {
        return token.file < files_.size() ? scene::SourceRef{token.file, token.offset} : scene::SourceRef{};
    }
    scene::LineAndColumn line_and_column(const scene::SourceRef& at) const;           ///< for messages
    scene::SourceRef start() const { return place(files_.front()->tokens.front()); }  ///< of the scene's first token
    scene::SourceRef end_of_scene() const  ///< of the scene's last token, however the text before it was read
    {
        const std::vector<Token>& all = files_.front()->tokens;
        return place(all[all.size() < 2 ? 0 : all.size() - 2]);
    }

    /// The values of a Faces or Numbers token and all that were read after it.
    std::span<const double> values_from(const Token& token) const
    {
        return std::span(files_[token.file]->numbers).subspan(token.name);
    }
    /// The values of a Numbers token.
    std::span<const double> values_of(const Token& numbers) const
    {
        return values_from(numbers).first(numbers.jump * static_cast<std::size_t>(numbers.number));
    }
    /// The rest of the file, from the token on. Nothing if the file is not what it was when it was read.
    std::string text_from(const Token& token) const;

    std::vector<std::string> files() const;       ///< paths in order of SourceRef::file
    std::vector<scene::LineTable> lines() const;  ///< by file

protected:
    /// A message with its place alone.
    scene::Message message(scene::Severity severity, const scene::SourceRef& at, std::string_view text) const;

    std::vector<std::unique_ptr<SourceFile>> files_;
};

}  // namespace parser
