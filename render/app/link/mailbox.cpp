#include "render/app/link/mailbox.h"

#include "render/files/hash.h"

#include <dirent.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

namespace app {
namespace {

/// This user's alone; empty: there is none.
std::string folder_of_user()
{
    const char* const runtime = std::getenv("XDG_RUNTIME_DIR");
    const std::string folder = runtime != nullptr && *runtime == '/' ? std::string(runtime) + "/whittle"
                                                                     : "/tmp/whittle-" + std::to_string(getuid());
    if (mkdir(folder.c_str(), S_IRWXU) != 0 && errno != EEXIST) return {};
    struct stat found {};
    constexpr mode_t kOthers = S_IRWXG | S_IRWXO;
    const bool ours = lstat(folder.c_str(), &found) == 0 && S_ISDIR(found.st_mode) && found.st_uid == getuid() &&
                      (found.st_mode & kOthers) == 0;
    return ours ? folder : std::string();
}

/// False: the path is too long for one.
bool set_address(sockaddr_un& address, const std::string& path)
{
    address = {};
    address.sun_family = AF_UNIX;
    if (path.size() >= sizeof address.sun_path) return false;
    std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
    return true;
}

}  // namespace

Mailbox::Mailbox(const std::string& kind, Take take)
    : folder_(folder_of_user()), name_(kind + "-" + std::to_string(getpid()))
{
    sockaddr_un address;
    const std::string path = folder_ + "/" + name_;
    if (folder_.empty() || !set_address(address, path)) return;
    socket_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (socket_ < 0) return;
    unlink(path.c_str());  // of a process that had this number before
    ended_ = eventfd(0, EFD_CLOEXEC);
    if (ended_ < 0 || bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
        close(socket_);
        socket_ = -1;
        return;
    }
    thread_ = std::thread([this, take = std::move(take)] { listen(take); });
}

Mailbox::~Mailbox()
{
    if (socket_ >= 0) {
        const std::uint64_t one = 1;
        while (write(ended_, &one, sizeof one) < 0 && errno == EINTR) {}
        thread_.join();
        unlink((folder_ + "/" + name_).c_str());
        close(socket_);
    }
    if (ended_ >= 0) close(ended_);
}

void Mailbox::listen(const Take& take)
{
    std::vector<char> text(kLongest + 1);
    for (;;) {
        std::array<pollfd, 2> waited{{{socket_, POLLIN, 0}, {ended_, POLLIN, 0}}};
        if (poll(waited.data(), waited.size(), -1) < 0 && errno != EINTR) return;
        if (waited[1].revents != 0) return;
        if (waited[0].revents == 0) continue;
        sockaddr_un from{};
        socklen_t length = sizeof from;
        const ssize_t got =
            recvfrom(socket_, text.data(), text.size(), MSG_DONTWAIT, reinterpret_cast<sockaddr*>(&from), &length);
        if (got <= 0 || static_cast<std::size_t>(got) > kLongest) continue;
        std::string sender = length > offsetof(sockaddr_un, sun_path) ? std::string(from.sun_path) : std::string();
        const bool neighbour = sender.starts_with(folder_ + "/");
        sender = neighbour ? sender.substr(folder_.size() + 1) : std::string();
        take(std::string(text.data(), static_cast<std::size_t>(got)), sender);
    }
}

bool Mailbox::send(const std::string& name, const std::string& text) const
{
    sockaddr_un address;
    const std::string path = folder_ + "/" + name;
    if (socket_ < 0 || name.empty() || text.size() > kLongest || !set_address(address, path)) return false;
    if (sendto(socket_, text.data(), text.size(), MSG_DONTWAIT | MSG_NOSIGNAL,
               reinterpret_cast<const sockaddr*>(&address), sizeof address) >= 0)
        return true;
    if (errno == ECONNREFUSED) unlink(path.c_str());  // its program ended and could not tidy up
    return false;
}

std::size_t Mailbox::tell(const std::string& kind, const std::string& text) const
{
    if (socket_ < 0) return 0;
    const std::unique_ptr<DIR, int (*)(DIR*)> folder(opendir(folder_.c_str()), closedir);
    if (!folder) return 0;
    std::size_t reached = 0;
    while (const dirent* const entry = readdir(folder.get()))
        if (std::string_view(entry->d_name).starts_with(kind + "-") && send(entry->d_name, text)) ++reached;
    return reached;
}

std::uint64_t mark_of(std::string_view text) { return files::hash_of(text.data(), text.size()); }

}  // namespace app
