// Files that a scene reads with #read.
#include "parser/stream/files/data_file.h"
#include "tests/fuzz/target.h"

#include <stdexcept>

void fuzz::one(const Bytes& bytes)
{
    parser::DataFile file;
    file.text = text_of(bytes);
    try {
        while (file.read_item()) {
            const std::size_t before = file.position;
            const bool more = file.skip_separator();
            require(file.position <= file.text.size() && (!more || file.position > before), "reading does not go on");
        }
    } catch (const std::runtime_error&) {}
}

std::vector<fuzz::Bytes> fuzz::seeds()
{
    return {
        bytes_of("1, -2.5e3, <1, 2>, <1,2,3,4,5>, \"text \\\" more\", // remark\n +.5, /* a /* nested */ one */ 7\n"),
        bytes_of("<-1,+2>\n\"\",\n1e999, 1e-999 x"), bytes_of("<1"), bytes_of("/*")};
}
