#pragma once

#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace parser {

/// A file that a scene reads or writes (`#fopen`; spec 1, 10.2 to 10.4). One direction for its whole life.
struct DataFile {
    struct Closer {
        void operator()(std::FILE* f) const { std::fclose(f); }
    };

    std::string path;
    std::unique_ptr<std::FILE, Closer> out;  ///< writing to disk
    std::shared_ptr<std::string> kept;       ///< writing with Options::write_nothing
    std::string text;                        ///< reading: all of it
    std::size_t position = 0;
    bool reading() const { return !out && !kept; }

    /// False if the disk does not take it. Not for files that are read.
    bool write(const std::string& bytes);

    /// A number, a vector of 2 to 5 components or a string.
    struct Vector {
        std::array<double, 5> at{};
        int count = 0;
    };
    using Item = std::variant<double, Vector, std::string>;

    /// The next item; nothing at the end of the file. Throws std::runtime_error where something else stands.
    std::optional<Item> read_item();
    /// Takes the token behind an item, whatever it is: a comma, as it should be, or else it is lost. False at the end.
    bool skip_separator();

private:
    enum class Mark : unsigned char { End, Number, Text, Other };
    struct Token {
        Mark mark = Mark::End;
        double number = 0;
        std::string text;
    };
    void skip_blanks();
    Token token();
    double signed_number(Token first);
};

}  // namespace parser
