#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <thread>

namespace app {

/// Where programs of one user tell each other something: sockets in a folder that nobody else may enter, a datagram
/// each message, so that nobody waits for anybody and nothing has to be closed. Without such a folder it tells nobody
/// and hears nothing.
class Mailbox {
public:
    /// Called from a thread of the mailbox's own.
    /// \param from  whom to answer; empty: nobody
    using Take = std::function<void(const std::string& text, const std::string& from)>;

    static constexpr std::size_t kLongest = 65536;  ///< bytes of a message; longer ones are not told

    /// \param kind  of this program: "lsp", "watch"
    Mailbox(const std::string& kind, Take take);
    ~Mailbox();
    Mailbox(const Mailbox&) = delete;
    Mailbox& operator=(const Mailbox&) = delete;

    /// To every program of a kind. \return how many it reached
    std::size_t tell(const std::string& kind, const std::string& text) const;
    /// To one whose message was taken.
    void answer(const std::string& from, const std::string& text) const { send(from, text); }
    bool open() const { return socket_ >= 0; }

private:
    void listen(const Take& take);
    bool send(const std::string& name, const std::string& text) const;

    std::string folder_, name_;
    int socket_ = -1, ended_ = -1;
    std::thread thread_;
};

/// A number that tells texts apart: whether two programs speak of the same one.
std::uint64_t mark_of(std::string_view text);

}  // namespace app
