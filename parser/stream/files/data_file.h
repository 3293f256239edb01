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
    std::unique_ptr<std::FILE, Closer> out;     ///< writing to disk
    std::shared_ptr<std::string> kept;          ///< writing with Options::write_nothing
    std::string text;                           ///< reading: all of it, or what was read of `in` and is not done with
    std::size_t position = 0;                   ///< in `text`
    std::unique_ptr<std::FILE, Closer> in;      ///< reading: where the rest comes from; null: there is none
    std::size_t dropped = 0;                    ///< bytes before `text`
    std::size_t window = std::size_t{1} << 16;  ///< bytes of `in` that are read at a time
    bool reading() const { return !out && !kept; }

    /// False if the disk does not take it. Not for files that are read.
    bool write(const std::string& bytes);

    /// A number, a vector of 2 to 5 components or a string.
    struct Vector {
        std::array<double, 5> at{};
        int count = 0;
    };
    using Item = std::variant<double, Vector, std::string>;

    /// The next item; nothing at the end of the file. Throws std::runtime_error where something else
    /// stands, std::system_error where the file cannot be read on.
    std::optional<Item> read_item();
    /// Takes the token behind an item, whatever it is: a comma, as it should be, or else it is lost. False at the end.
    bool skip_separator();

    /// `count` items that are numbers and their separators, with more behind them. False: it is not so, and it stands
    /// where it stood.
    bool read_numbers(double* to, std::size_t count);
    /// The rest becomes text: the file may change from now on.
    void load_all()
    {
        while (more()) {}
    }

private:
    enum class Mark : unsigned char { End, Number, Text, Other };
    struct Token {
        Mark mark = Mark::End;
        double number = 0;
        std::string text;
    };
    /// Whether a character stands so far behind the position.
    bool has(std::size_t ahead) { return position + ahead < text.size() || fetch(ahead); }
    bool fetch(std::size_t ahead);
    bool more();
    bool stands(const char (&two)[3]) { return has(1) && text[position] == two[0] && text[position + 1] == two[1]; }
    void skip_blanks();
    bool plain_number(double& to);
    bool read_short_numbers(double* to, std::size_t count);
    Token token();
    double signed_number(Token first);
    std::optional<std::size_t> held_;  ///< what stands from this byte of the file on is not dropped
};

}  // namespace parser
