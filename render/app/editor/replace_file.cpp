#include "render/app/editor/replace_file.h"

#include "render/files/whole_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <system_error>
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
    try {
        return path == "-" ? files::rest_of(stdin) : files::whole_file(path);
    } catch (const std::system_error& error) {
        fail_with_cause("cannot read", path, error.code().value());
    }
}

}  // namespace app
