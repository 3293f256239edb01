#pragma once

#include "parser/parse.h"

#include <string>

/// What the grammar's tests share: text in, description or message out.
namespace grammar_test {

inline scene::Description parsed(const std::string& text) { return parser::parse_text(text, "test.pov", {}).scene; }

/// First line of the error's text without the file's name; empty if the text is accepted.
inline std::string error_of(const std::string& text)
{
    try {
        parsed(text);
        return {};
    } catch (const parser::Error& error) {
        const std::string all = error.what();
        const std::string line = all.substr(0, all.find('\n'));
        const std::string prefix = "test.pov:";
        return line.rfind(prefix, 0) == 0 ? line.substr(prefix.size()) : line;
    }
}

}  // namespace grammar_test
