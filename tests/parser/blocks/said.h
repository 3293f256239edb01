#pragma once

#include "parser/parse.h"

#include <string>

/// What reading a scene says.
namespace said {

/// All messages with their places and weights, and the error.
inline std::string in_full(const std::string& text, parser::Options options)
{
    std::string said;
    options.most_tokens = 300'000;
    const auto keep = [](void* to, const parser::Message& message) {
        *static_cast<std::string*>(to) += std::to_string(static_cast<int>(message.severity)) + message_text(message) +
                                          "\n";
    };
    try {
        parser::parse_text(text, "t.pov", options, keep, &said);
    } catch (const parser::Error& error) {
        said += error.what();
    }
    return said;
}

}  // namespace said
