#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// A string as JSON has it, in quotes. Bytes that are no UTF-8 become U+FFFD.
std::string json_quoted(std::string_view text);

/// Writes JSON, indented by two blanks a level. Text is UTF-8; bytes that are not become U+FFFD.
class JsonWriter {
public:
    void begin_object() { open('{'); }
    void begin_array() { open('['); }
    void end() { close(); }
    JsonWriter& key(std::string_view name);

    void text(std::string_view value);
    void number(double value);  ///< null if it is not finite
    void integer(std::int64_t value) { item(std::to_string(value)); }
    void truth(bool value) { item(value ? "true" : "false"); }
    void null() { item("null"); }

    /// The whole text, when all is closed.
    std::string take() { return std::move(out_) + "\n"; }

private:
    void open(char bracket);
    void close();
    void item(std::string_view text);
    void new_line();

    std::string out_, closing_;  ///< brackets that are open, the innermost last
    bool first_ = true, after_key_ = false;
};

}  // namespace app
