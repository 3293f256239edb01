#pragma once

#include "parser/base/reading.h"

#include <string>

namespace parser {

/// Reads a scene file and everything it includes. Throws Error, Cancelled.
Result parse_file(const std::string& path, const Options& options, MessageSink sink = nullptr, void* context = nullptr);

/// The same for text in memory; `name` stands for the file in messages.
Result parse_text(const std::string& text, const std::string& name, const Options& options, MessageSink sink = nullptr,
                  void* context = nullptr);

/// --dump=tokens: one token a line, with position.
std::string dump_tokens(const std::string& path);

}  // namespace parser
