#include "render/app/embed/unpack.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <utility>

namespace app {
namespace {

/// An open file or folder of the system.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept
    {
        std::swap(number_, other.number_);
        return *this;
    }
    ~Descriptor()
    {
        if (number_ >= 0) ::close(number_);
    }
    int number() const { return number_; }
    explicit operator bool() const { return number_ >= 0; }

private:
    int number_;
};

[[noreturn]] void cannot(const char* what, const std::string& name)
{
    const std::string why = errno == ELOOP || errno == ENOTDIR ? "a symbolic link or a file is in its way"
                                                               : std::strerror(errno);
    throw std::runtime_error(fmt::format("cannot {} '{}': {}", what, name, why));
}

/// The folder of a name, step by step: a step that is a link is none.
/// \param make  folders that are missing; else the result may be none
Descriptor folder_of(const Descriptor& top, const std::string& name, bool make)
{
    Descriptor at(::fcntl(top.number(), F_DUPFD_CLOEXEC, 0));
    std::size_t begin = 0;
    for (std::size_t slash = name.find('/'); slash != std::string::npos; slash = name.find('/', begin)) {
        const std::string part = name.substr(begin, slash - begin);
        begin = slash + 1;
        if (make && ::mkdirat(at.number(), part.c_str(), 0777) != 0 && errno != EEXIST)
            cannot("make the folder of", name);
        Descriptor next(::openat(at.number(), part.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
        if (!next && !make && errno == ENOENT) return next;
        if (!next) cannot("write", name);
        at = std::move(next);
    }
    return at;
}

std::string last_part(const std::string& name) { return name.substr(name.rfind('/') + 1); }

enum class There { Nothing, Same, Other };

There what_is_there(const Descriptor& top, const Carried::File& file)
{
    const Descriptor folder = folder_of(top, file.name, false);
    if (!folder) return There::Nothing;
    const Descriptor old(
        ::openat(folder.number(), last_part(file.name).c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    if (!old && errno == ENOENT) return There::Nothing;
    struct stat facts {};
    if (!old || ::fstat(old.number(), &facts) != 0 || !S_ISREG(facts.st_mode)) return There::Other;
    if (static_cast<std::size_t>(facts.st_size) != file.bytes.size()) return There::Other;
    std::string bytes(file.bytes.size(), '\0');
    std::size_t got = 0;
    while (got < bytes.size()) {
        const ssize_t some = ::read(old.number(), bytes.data() + got, bytes.size() - got);
        if (some <= 0) return There::Other;
        got += static_cast<std::size_t>(some);
    }
    return bytes == file.bytes ? There::Same : There::Other;
}

void put(const Descriptor& top, const Carried::File& file)
{
    const Descriptor folder = folder_of(top, file.name, true);
    const std::string last = last_part(file.name);
    ::unlinkat(folder.number(), last.c_str(), 0);  // a link that stands there is not followed but replaced
    const Descriptor out(
        ::openat(folder.number(), last.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
    if (!out) cannot("write", file.name);
    for (std::string_view rest = file.bytes; !rest.empty();) {
        const ssize_t written = ::write(out.number(), rest.data(), rest.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) cannot("write", file.name);
        rest.remove_prefix(static_cast<std::size_t>(written));
    }
}

}  // namespace

void put_files(const std::vector<Carried::File>& files, const std::string& folder, bool replace)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    const Descriptor top(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!top) cannot("open the folder", folder);
    std::vector<const Carried::File*> wanted;
    std::string in_the_way;
    for (const Carried::File& file : files) {
        const There there = what_is_there(top, file);
        if (there != There::Same) wanted.push_back(&file);
        if (there == There::Other) in_the_way += (in_the_way.empty() ? "" : ", ") + file.name;
    }
    if (!in_the_way.empty() && !replace)
        throw std::runtime_error(fmt::format("'{}' has other files of these names: {}; nothing was written (--replace "
                                             "overwrites them)",
                                             folder, in_the_way));
    for (const Carried::File* file : wanted) put(top, *file);
}

}  // namespace app
