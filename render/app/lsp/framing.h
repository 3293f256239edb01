#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>

namespace app::lsp {

/// Messages of a client: a header with Content-Length, an empty line, so many bytes. What is none of that is passed
/// over up to the next header.
class Input {
public:
    static constexpr std::size_t kLongest = std::size_t{64} << 20;  ///< bytes of a message

    /// \param alive asked now and then while nothing comes; false ends the input
    Input(int file, std::function<bool()> alive) : file_(file), alive_(std::move(alive)) {}

    enum class What { Message, Garbage, TooLong, End };
    What next(std::string& body);
    /// Bytes that are read again.
    void put_back(std::string_view bytes) { buffer_.insert(0, bytes); }

private:
    bool fill();
    bool skip(std::size_t bytes);
    int file_;
    std::function<bool()> alive_;
    std::string buffer_;
};

/// Where a header begins in some bytes, upper or lower case; npos: nowhere.
std::size_t header_in(std::string_view bytes);

/// Messages to a client, each as a whole. A client that is gone is noticed and left alone.
class Output {
public:
    explicit Output(int file) : file_(file) {}
    void send(std::string_view body);
    bool gone() const { return gone_; }

private:
    int file_;
    std::mutex mutex_;
    std::atomic<bool> gone_ = false;
};

}  // namespace app::lsp
