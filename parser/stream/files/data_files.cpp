#include "parser/stream/files/data_file.h"
#include "parser/stream/expression.h"
#include "parser/stream/files/file_bytes.h"
#include "parser/stream/files/file_policy.h"
#include "parser/stream/text.h"
#include "parser/stream/token_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

/// `#fopen` and its kin (spec 1, 10.2 to 10.4). A scene may write below the current folder and the folders of
/// Options::write_folders only.
namespace parser {
namespace {

/// One value as bytes: clamped to the type's range, rounded half up.
struct Binary {
    double least, most;
    int bytes;
    bool big_endian;
};
std::optional<Binary> binary_type(Kind kind)
{
    switch (kind) {
    case Kind::Sint8: return Binary{-128, 127, 1, false};
    case Kind::Uint8: return Binary{0, 255, 1, false};
    case Kind::Sint16le: return Binary{-32768, 32767, 2, false};
    case Kind::Sint16be: return Binary{-32768, 32767, 2, true};
    case Kind::Uint16le: return Binary{0, 65535, 2, false};
    case Kind::Uint16be: return Binary{0, 65535, 2, true};
    case Kind::Sint32le: return Binary{-2147483648.0, 2147483647.0, 4, false};
    case Kind::Sint32be: return Binary{-2147483648.0, 2147483647.0, 4, true};
    default: return std::nullopt;
    }
}

std::string as_bytes(const Binary& type, double v)
{
    const double rounded = std::clamp(std::floor(v + 0.5), type.least, type.most);
    const auto bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(std::isnan(rounded) ? 0.0 : rounded));
    std::string bytes;
    for (int i = 0; i < type.bytes; ++i) bytes += static_cast<char>(bits >> (8 * i) & 0xffu);
    if (type.big_endian) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

std::string as_text(const Tuple& value)
{
    if (value.count == 1) return fmt::format("{:g}", value.at[0]);
    std::string text = "<";
    for (std::size_t i = 0; i < static_cast<std::size_t>(value.count); ++i)
        text += fmt::format("{}{:g}", i > 0 ? "," : "", value.at[i]);
    return text + "> ";
}

}  // namespace

void TokenStream::open_data_file()
{
    const Token name = raw_next();
    if (name.kind != Kind::Identifier) fail_expected_at(name, "a new name for the file");
    if (symbols_.find(name.name)) fail(place(name), fmt::format("'{}' is declared already", word(name)));
    const scene::SourceRef at = here();
    auto file = std::make_shared<DataFile>();
    file->path = path_expr(*this);
    const Token way = raw_next();
    if (way.kind == Kind::Read) {
        const std::string path = find_file(file->path, {});
        const bool kept = !path.empty() && kept_files_.has(path);
        if (kept) file->text = kept_files_.read(path).value_or(std::string());
        else if (std::error_code error; std::filesystem::is_regular_file(path, error)) {
            read_files_.data(path);
            file->in.reset(std::fopen(path.c_str(), "rb"));
        }
        if (!kept && !file->in) fail(at, fmt::format("cannot open '{}' for reading{}", file->path, why_not_found()));
    } else if (way.kind == Kind::Write || way.kind == Kind::Append) {
        if (!may_write(options_, file->path))
            fail(at, fmt::format("a scene may not write to '{}': it lies outside of the current folder and the "
                                 "output's (--allow-write)",
                                 file->path));
        // What is being read stays as it was when it was opened.
        for (std::uint32_t one = 0; one < names_.size(); ++one) {
            const Cell cell = symbols_.find_global(one);
            const auto* const open = cell ? cell->get_if<std::shared_ptr<DataFile>>() : nullptr;
            if (open && *open) (*open)->load_all();
        }
        const bool append = way.kind == Kind::Append;
        if (options_.write_nothing) file->kept = kept_files_.open(file->path, append);
        else file->out.reset(std::fopen(file->path.c_str(), append ? "ab" : "wb"));
        if (file->reading()) fail(at, fmt::format("cannot open '{}' for writing", file->path));
        forget_text(file->path);
    } else {
        fail_expected_at(way, "'read', 'write' or 'append'");
    }
    *symbols_.global(name.name) = std::move(file);
}

/// A file that is written anew must be read anew by the next #include.
void TokenStream::forget_text(const std::string& path)
{
    included_.clear();  // the new file may be what a name means now
    read_files_.written();
    std::error_code error;
    const auto written = std::filesystem::path(path).lexically_normal();
    std::erase_if(loaded_, [&](const auto& entry) {
        return std::filesystem::path(entry.first).lexically_normal() == written ||
               std::filesystem::equivalent(entry.first, path, error);
    });
}

void TokenStream::close_data_file()
{
    const Token name = raw_next();  // with anything but an open file it does nothing
    const Value* value = name.kind == Kind::Identifier ? symbols_.find(name.name) : nullptr;
    if (value && value->get_if<std::shared_ptr<DataFile>>()) symbols_.undefine(name.name);
}

std::shared_ptr<DataFile> TokenStream::data_file(Token& name, bool reading)
{
    expect(Kind::LeftParen, "'(' and the name of an open file");
    name = raw_next();
    const Value* value = name.kind == Kind::Identifier ? symbols_.find(name.name) : nullptr;
    const auto* file = value ? value->get_if<std::shared_ptr<DataFile>>() : nullptr;
    if (!file) fail_expected_at(name, "the name of an open file");
    if ((*file)->reading() != reading)
        fail(place(name), fmt::format("'{}' was opened for {}", word(name), reading ? "writing" : "reading"));
    return *file;
}

/// Where an item goes: a new global name, a variable, an element of an array that holds something.
Cell TokenStream::read_target()
{
    const Token name = raw_next();
    if (name.kind != Kind::Identifier) fail_expected_at(name, "the name of a variable");
    Cell cell = symbols_.find_cell(name.name);
    if (!cell) return symbols_.global(name.name);
    if (is_container(*cell)) cell = subscripted(cell, name, false);
    const Tuple* tuple = cell->get_if<Tuple>();
    const bool takes = !cell->set() || cell->get_if<std::string>() ||
                       (tuple && (tuple->count == 1 || tuple->count == 3));
    if (!takes)
        fail(place(name), fmt::format("'{}' is declared as {}: it cannot take data", word(name), type_name(*cell)));
    return cell;
}

void TokenStream::read_data()
{
    Token name;
    const std::shared_ptr<DataFile> file = data_file(name, true);
    bool ended = false;
    std::vector<std::uint32_t> fresh;
    accept_comma();
    while (peek_raw().kind != Kind::RightParen) {
        const Token variable = peek_raw();
        const bool known = variable.kind == Kind::Identifier && symbols_.find(variable.name) != nullptr;
        const Cell target = read_target();
        accept_comma();
        std::optional<DataFile::Item> item;
        try {
            if (!ended) item = file->read_item();
        } catch (const std::system_error& error) {
            fail_to_read(*this, place(variable), file->path, error.code().value());
        } catch (const std::exception& error) {
            fail(place(variable), fmt::format("{}: {}", file->path, error.what()));
        }
        ended = ended || !item;
        if (!item) {
            if (!known) symbols_.undefine(variable.name);  // it stays undeclared
            continue;
        }
        if (const auto* number = std::get_if<double>(&*item)) *target = Tuple::of(*number);
        else if (const auto* text = std::get_if<std::string>(&*item)) *target = *text;
        else *target = Tuple{std::get<DataFile::Vector>(*item).at, std::get<DataFile::Vector>(*item).count}.stored();
        ended = !file->skip_separator();
    }
    raw_next();
    if (ended) symbols_.undefine(name.name);
}

/// An item of `#write`: a colour must stand in parentheses or behind a sign.
Tuple TokenStream::written_value()
{
    const Token& token = peek();
    const Value* value = token.kind == Kind::Identifier ? value_of(token) : nullptr;
    const Tuple* tuple = value ? value->get_if<Tuple>() : nullptr;
    if (lexical_class(token.kind) == LexicalClass::Color || (tuple && tuple->count == 5))
        fail_expected("a text, a number or a vector (a colour needs parentheses)");
    return untyped_expr(*this);
}

void TokenStream::write_data()
{
    Token name;
    const std::shared_ptr<DataFile> file = data_file(name, false);
    accept_comma();
    std::string text;
    for (Kind kind = peek().kind; kind != Kind::RightParen; kind = peek().kind) {
        if (kind == Kind::String) {  // first: most of what loops write
            text += printed(string_text(next(), false), language_.version);
        } else if (const auto type = binary_type(kind)) {
            next();
            do {
                const Tuple value = untyped_expr(*this);
                for (std::size_t i = 0; i < static_cast<std::size_t>(value.count); ++i)
                    text += as_bytes(*type, value.at[i]);
            } while (peek().kind != Kind::Comma && at_expression(*this));
        } else {
            text += at_string(*this) ? printed(string_expr(*this), language_.version) : as_text(written_value());
        }
        accept_comma();
    }
    next();
    if (!file->write(text)) fail(place(name), fmt::format("cannot write to '{}'", file->path));
}

}  // namespace parser
