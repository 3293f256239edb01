#include "parser/stream/files/file_bytes.h"

#include "parser/stream/token_stream.h"
#include "render/files/whole_file.h"
#include "render/scene/base/passing_error.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace parser {

std::string bytes_of_file(TokenStream& in, const scene::SourceRef& at, const std::string& path)
{
    try {
        return files::whole_file(path);
    } catch (const std::system_error& error) {
        fail_to_read(in, at, path, error.code().value());
    }
}

void fail_to_read(TokenStream& in, const scene::SourceRef& at, const std::string& path, int number)
{
    const auto tell = [&] { in.fail(at, fmt::format("cannot read '{}': {}", path, std::strerror(number))); };
    if (number != ENOENT && !files::failure_may_pass(number)) tell();
    scene::fail_for_now(tell);
}

}  // namespace parser
