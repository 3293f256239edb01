#include "render/files/whole_file.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace files {

namespace {

[[noreturn]] void fail(int number) { throw std::system_error(number, std::generic_category()); }

}  // namespace

std::string rest_of(std::FILE* stream)
{
    std::string bytes;
    struct stat known = {};
    if (fstat(fileno(stream), &known) == 0 && S_ISREG(known.st_mode) && known.st_size > 0)
        bytes.reserve(static_cast<std::size_t>(known.st_size) +
                      1);  // one more, so that its end is found by the last piece
    // In pieces: what resize() clears is still near when it is written.
    constexpr std::size_t kPiece = std::size_t{1} << 17;
    for (std::size_t got = kPiece, piece = kPiece; got == piece;) {
        const std::size_t before = bytes.size(), room = bytes.capacity() - before;
        piece = room > 0 ? std::min(room, kPiece) : kPiece;
        bytes.resize(before + piece);
        got = std::fread(bytes.data() + before, 1, piece, stream);
        if (std::ferror(stream) != 0) fail(errno);
        bytes.resize(before + got);
    }
    return bytes;
}

std::string whole_file(const std::string& path)
{
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
    if (!file) fail(errno);
    std::setvbuf(file.get(), nullptr, _IONBF, 0);
    return rest_of(file.get());
}

std::optional<std::string> whole_file_if(const std::string& path)
{
    try {
        return whole_file(path);
    } catch (const std::system_error&) {
        return std::nullopt;
    }
}

bool failure_may_pass(int number)
{
    constexpr int kPassing[] = {ENOSPC, EDQUOT, EIO,       ESTALE,    ENOMEM,       EMFILE,
                                ENFILE, EAGAIN, ETIMEDOUT, EHOSTDOWN, EHOSTUNREACH, ENOTCONN};
    return std::find(std::begin(kPassing), std::end(kPassing), number) != std::end(kPassing);
}

}  // namespace files
