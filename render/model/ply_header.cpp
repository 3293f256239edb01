#include "render/model/ply_header.h"

#include "render/model/base/text_words.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace model {
namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};
constexpr TypeName kTypes[] = {
    {"char", PlyType::Int8},      {"int8", PlyType::Int8},       {"uchar", PlyType::Uint8},
    {"uint8", PlyType::Uint8},    {"short", PlyType::Int16},     {"int16", PlyType::Int16},
    {"ushort", PlyType::Uint16},  {"uint16", PlyType::Uint16},   {"int", PlyType::Int32},
    {"int32", PlyType::Int32},    {"uint", PlyType::Uint32},     {"uint32", PlyType::Uint32},
    {"float", PlyType::Float32},  {"float32", PlyType::Float32}, {"double", PlyType::Float64},
    {"float64", PlyType::Float64}};

class Header {
public:
    explicit Header(std::string_view bytes) : bytes_(bytes) {}

    PlyHeader read()
    {
        if (next_line() != "ply") fail("a PLY file begins with 'ply'");
        bool has_format = false;
        for (;;) {
            TextWords words(next_line(), header_.line - 1);
            const std::string_view word = words.next();
            if (word == "end_header") break;
            if (word.empty() || word == "comment" || word == "obj_info") continue;
            if (word == "format") format(words), has_format = true;
            else if (word == "element") element(words);
            else if (word == "property") property(words);
            else words.fail("'" + shortened(word) + "' is no word of a PLY header");
        }
        if (!has_format) fail("its header names no format");
        return std::move(header_);
    }

private:
    [[noreturn]] void fail(const std::string& what) const { throw ModelError(what, header_.line - 1); }

    /// Without its end; `end` and `line` stand behind it then.
    std::string_view next_line()
    {
        if (header_.end >= bytes_.size()) throw ModelError("it ends within its header", header_.line);
        const std::size_t end = bytes_.find('\n', header_.end);
        if (end == std::string_view::npos) throw ModelError("it ends within its header", header_.line);
        std::string_view line = bytes_.substr(header_.end, end - header_.end);
        if (line.ends_with('\r')) line.remove_suffix(1);
        header_.end = end + 1;
        ++header_.line;
        return line;
    }
    void format(TextWords& words)
    {
        using Format = PlyHeader::Format;
        const std::string_view name = words.next();
        if (name == "ascii") header_.format = Format::Text;
        else if (name == "binary_little_endian") header_.format = Format::LittleEndian;
        else if (name == "binary_big_endian") header_.format = Format::BigEndian;
        else words.fail("'" + shortened(name) + "' is no format of PLY");
    }
    void element(TextWords& words)
    {
        PlyElement element;
        element.name = words.next();
        element.count = words.number<std::uint64_t>();
        header_.elements.push_back(std::move(element));
    }
    void property(TextWords& words)
    {
        if (header_.elements.empty()) words.fail("a property before any element");
        PlyProperty property;
        std::string_view word = words.next();
        if (word == "list") {
            property.list = true;
            property.count_type = type_of(words, words.next());
            if (property.count_type >= PlyType::Float32) words.fail("how many a list has is a whole number");
            word = words.next();
        }
        property.type = type_of(words, word);
        property.name = words.next();
        if (property.name.empty()) words.fail("a property without a name");
        header_.elements.back().properties.push_back(std::move(property));
    }
    static PlyType type_of(TextWords& words, std::string_view name)
    {
        const auto known =
            std::find_if(std::begin(kTypes), std::end(kTypes), [&](const TypeName& one) { return one.name == name; });
        if (known == std::end(kTypes)) words.fail("'" + shortened(name) + "' is no type of PLY");
        return known->type;
    }

    std::string_view bytes_;
    PlyHeader header_;
};

}  // namespace

std::size_t bytes_of(PlyType type)
{
    constexpr std::size_t kBytes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return kBytes[static_cast<std::size_t>(type)];
}

PlyHeader ply_header_of(std::string_view bytes) { return Header(bytes).read(); }

}  // namespace model
