#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace app::rpc {

/// Messages of a client: a header with Content-Length, an empty line, so many bytes. What is none of that is passed
/// over up to the next header.
class Input {
public:
    static constexpr std::size_t kLongest = std::size_t{64} << 20;  ///< bytes of a message

    /// \param alive asked now and then while nothing comes; false ends the input
    Input(int file, std::function<bool()> alive) : file_(file), alive_(std::move(alive)) {}

    enum class What { Message, Garbage, TooLong, End };
    What next(std::string& body);
    /// The next line of a client that ends messages by line ends, without it.
    What next_line(std::string& body);
    /// The same of what has come already; nothing: no line is whole.
    std::optional<What> waiting_line(std::string& body);
    /// Waits for more bytes. False: none will come.
    bool fill();
    /// Bytes that are read again.
    void put_back(std::string_view bytes) { buffer_.insert(0, bytes); }

private:
    bool skip(std::size_t bytes);
    int file_;
    std::function<bool()> alive_;
    std::string buffer_;
    std::size_t looked_ = 0;  ///< so many bytes of it hold no line end
    bool passing_ = false;    ///< a line that is too long
};

/// How messages are kept apart: a header with Content-Length before each (the language server protocol), or a line end
/// behind each (the model context protocol).
enum class Framing { Header, Line };

/// Where a header begins in some bytes, upper or lower case; npos: nowhere.
std::size_t header_in(std::string_view bytes);

/// Messages to a client, each as a whole. A client that is gone is noticed and left alone.
class Output {
public:
    explicit Output(int file, Framing framing = Framing::Header) : file_(file), framing_(framing) {}
    void send(std::string_view body);
    bool gone() const { return gone_; }

private:
    int file_;
    Framing framing_;
    std::mutex mutex_;
    std::atomic<bool> gone_ = false;
};

}  // namespace app::rpc
