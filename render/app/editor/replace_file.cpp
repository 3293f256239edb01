#include "render/app/editor/replace_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <sys/stat.h>
#include <unistd.h>

namespace app {
namespace {

[[noreturn]] void fail_with_cause(const char* what, const std::string& path, int cause)
{
    throw std::runtime_error(fmt::format("{} '{}': {}", what, path, std::strerror(cause)));
}

bool write_all(int file, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

}  // namespace

void replace_file(const std::string& path, std::string_view bytes)
{
    const std::string target = std::filesystem::canonical(path).string();
    struct stat before {};
    if (::stat(target.c_str(), &before) != 0) fail_with_cause("cannot read", path, errno);
    if (::access(target.c_str(), W_OK) != 0) fail_with_cause("cannot write", path, errno);
    std::string scratch = target + ".XXXXXX";
    const int file = ::mkstemp(scratch.data());
    if (file < 0) fail_with_cause("cannot write beside", path, errno);
    const bool complete = write_all(file, bytes) && ::fchmod(file, before.st_mode & 07777) == 0 && ::fsync(file) == 0;
    const int cause = errno;
    if (::close(file) != 0 || !complete || std::rename(scratch.c_str(), target.c_str()) != 0) {
        const int reason = complete ? errno : cause;
        ::unlink(scratch.c_str());
        fail_with_cause("cannot write", path, reason);
    }
}

std::string whole_file(const std::string& path)
{
    const bool input = path == "-";
    std::error_code error;
    if (!input && std::filesystem::is_directory(path, error)) fail_with_cause("cannot read", path, EISDIR);
    const auto close = [](std::FILE* f) { return f == stdin ? 0 : std::fclose(f); };
    const std::unique_ptr<std::FILE, decltype(close)> file(input ? stdin : std::fopen(path.c_str(), "rb"), close);
    if (!file) fail_with_cause("cannot read", path, errno);
    std::string bytes;
    char block[1 << 16];
    for (std::size_t got; (got = std::fread(block, 1, sizeof block, file.get())) > 0;) bytes.append(block, got);
    if (std::ferror(file.get()) != 0) fail_with_cause("cannot read", path, errno);
    return bytes;
}

}  // namespace app
