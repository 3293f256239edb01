#include "render/files/whole_file.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <utility>

namespace files {

namespace {

/// The system's number of the failure; 0: all is read.
int read_rest(std::FILE* stream, std::string& bytes)
{
    struct stat known = {};
    if (fstat(fileno(stream), &known) == 0 && S_ISREG(known.st_mode) && known.st_size > 0)
        bytes.reserve(static_cast<std::size_t>(known.st_size) + 1);  // one more: then the last piece finds the end
    // In pieces: what resize() clears is still near when it is written. Of what says nothing of its size they grow:
    // most such files are small.
    constexpr std::size_t kLeast = 1024, kMost = std::size_t{1} << 17;
    for (std::size_t got = 0, piece = 0; got == piece;) {
        const std::size_t before = bytes.size(), room = bytes.capacity() - before;
        piece = std::min(room > 0 ? room : std::max(kLeast, before), kMost);
        bytes.resize(before + piece);
        got = std::fread(bytes.data() + before, 1, piece, stream);
        if (std::ferror(stream) != 0) return errno;
        bytes.resize(before + got);
    }
    return 0;
}

int read_file(const std::string& path, std::string& bytes)
{
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
    if (!file) return errno;
    std::setvbuf(file.get(), nullptr, _IONBF, 0);
    return read_rest(file.get(), bytes);
}

std::string told(int failure, std::string&& bytes)
{
    if (failure != 0) throw std::system_error(failure, std::generic_category());
    return std::move(bytes);
}

}  // namespace

std::string rest_of(std::FILE* stream)
{
    std::string bytes;
    const int failure = read_rest(stream, bytes);
    return told(failure, std::move(bytes));
}

std::string whole_file(const std::string& path)
{
    std::string bytes;
    const int failure = read_file(path, bytes);
    return told(failure, std::move(bytes));
}

std::optional<std::string> whole_file_if(const std::string& path)
{
    std::optional<std::string> bytes(std::in_place);
    if (read_file(path, *bytes) != 0) bytes.reset();
    return bytes;
}

bool failure_may_pass(int number)
{
    constexpr int kPassing[] = {ENOSPC, EDQUOT, EIO,       ESTALE,    ENOMEM,       EMFILE,
                                ENFILE, EAGAIN, ETIMEDOUT, EHOSTDOWN, EHOSTUNREACH, ENOTCONN};
    return std::find(std::begin(kPassing), std::end(kPassing), number) != std::end(kPassing);
}

}  // namespace files
