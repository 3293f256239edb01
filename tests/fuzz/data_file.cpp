// Files that a scene reads with #read: the same whether the text is there as a whole or read on the way, item by item
// or several numbers at once.
#include "parser/stream/files/data_file.h"
#include "tests/fuzz/target.h"

#include <stdexcept>

namespace {

std::string told(const parser::DataFile::Item& item)
{
    if (const auto* number = std::get_if<double>(&item)) return std::to_string(*number);
    if (const auto* text = std::get_if<std::string>(&item)) return '"' + *text + '"';
    const auto& vector = std::get<parser::DataFile::Vector>(item);
    std::string all = "<";
    for (std::size_t i = 0; i < static_cast<std::size_t>(vector.count); ++i) all += std::to_string(vector.at[i]) + ",";
    return all;
}

/// All items and the error; `at_once`: so many numbers together where they stand.
std::string items_of(parser::DataFile& file, std::size_t at_once)
{
    std::string all;
    double numbers[4];
    try {
        for (;;) {
            if (at_once > 0 && file.read_numbers(numbers, at_once)) {
                for (std::size_t i = 0; i < at_once; ++i) all += std::to_string(numbers[i]) + "\n";
                continue;
            }
            const auto item = file.read_item();
            if (!item) return all;
            all += told(*item) + "\n";
            const std::size_t before = file.dropped + file.position;
            const bool more = file.skip_separator();
            fuzz::require(file.position <= file.text.size() && (!more || file.dropped + file.position > before),
                          "reading does not go on");
            if (!more) all += "end\n";
        }
    } catch (const std::runtime_error& error) {
        return all + error.what();
    }
}

}  // namespace

void fuzz::one(const Bytes& bytes)
{
    const std::string text = text_of(bytes);
    parser::DataFile whole;
    whole.text = text;
    const std::string expected = items_of(whole, 0);
    for (const std::size_t window : {1u, 2u, 7u, 4096u}) {
        parser::DataFile parts;
        parts.window = window;
        if (!text.empty()) parts.in.reset(fmemopen(const_cast<char*>(text.data()), text.size(), "rb"));
        const std::string said = items_of(parts, window % 4);
        if (said != expected)
            fail("a file says otherwise in parts of " + std::to_string(window) + ":\n" + text + "\nwhole: " + expected +
                 "\nin parts: " + said);
    }
}

std::vector<fuzz::Bytes> fuzz::seeds()
{
    return {
        bytes_of("1, -2.5e3, <1, 2>, <1,2,3,4,5>, \"text \\\" more\", // remark\n +.5, /* a /* nested */ one */ 7\n"),
        bytes_of("<-1,+2>\n\"\",\n1e999, 1e-999 x"), bytes_of("<1"), bytes_of("/*"),
        bytes_of("1,2,-3e-2,4.5E+10,.25, - 7,8 9,10;11,12,1e,5,1e+,6,12345678901234567890,3/4,5//6\n,7")};
}
