#include "render/app/rpc/framing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <poll.h>
#include <unistd.h>
#include <utility>

namespace app::rpc {
namespace {

constexpr std::string_view kLength = "content-length:";
constexpr std::size_t kLongestHeader = 4096;           // bytes
constexpr std::size_t kAbsurd = std::size_t{1} << 30;  // a length that is no length
constexpr int kPatience = 2000;                        // ms between two looks whether the client lives

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool blank(std::string_view bytes)
{
    return std::all_of(bytes.begin(), bytes.end(), [](char c) { return c == ' ' || c == '\r' || c == '\n'; });
}

/// The number behind the colon; kAbsurd where there is none or a longer one.
std::size_t length_of(std::string_view header)
{
    std::size_t at = kLength.size(), length = 0, digits = 0;
    while (at < header.size() && (header[at] == ' ' || header[at] == '\t')) ++at;
    for (; at < header.size() && header[at] >= '0' && header[at] <= '9'; ++at, ++digits)
        length = std::min(length * 10 + static_cast<std::size_t>(header[at] - '0'), kAbsurd);
    const bool ends = at < header.size() && (header[at] == '\r' || header[at] == '\n' || header[at] == ' ');
    return digits == 0 || !ends ? kAbsurd : length;
}

/// Behind the empty line that ends a header; npos: it is still to come.
std::size_t end_of_header(std::string_view bytes)
{
    const std::size_t usual = bytes.find("\r\n\r\n"), short_one = bytes.find("\n\n");
    if (usual == std::string_view::npos && short_one == std::string_view::npos) return usual;
    return usual < short_one ? usual + 4 : short_one + 2;
}

}  // namespace

std::size_t header_in(std::string_view bytes)
{
    const auto found = std::search(bytes.begin(), bytes.end(), kLength.begin(), kLength.end(),
                                   [](char a, char b) { return lower(a) == b; });
    return found == bytes.end() ? std::string_view::npos : static_cast<std::size_t>(found - bytes.begin());
}

bool Input::fill()
{
    for (;;) {
        pollfd wanted{file_, POLLIN, 0};
        const int ready = ::poll(&wanted, 1, kPatience);
        if (ready == 0 || (ready < 0 && errno == EINTR)) {
            if (!alive_()) return false;
            continue;
        }
        char block[1 << 16];
        const ssize_t got = ::read(file_, block, sizeof block);
        if (got < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (got <= 0) return false;
        buffer_.append(block, static_cast<std::size_t>(got));
        return true;
    }
}

bool Input::skip(std::size_t bytes)
{
    while (buffer_.size() < bytes) {
        bytes -= buffer_.size();
        buffer_.clear();
        if (!fill()) return false;
    }
    buffer_.erase(0, bytes);
    return true;
}

Input::What Input::next(std::string& body)
{
    for (;;) {
        const std::size_t header = header_in(buffer_);
        if (header == std::string::npos) {
            const std::size_t kept = std::min(buffer_.size(), kLength.size());
            const bool garbage = buffer_.size() > kLongestHeader && !blank(buffer_);
            if (buffer_.size() > kLongestHeader) buffer_.erase(0, buffer_.size() - kept);
            if (garbage) return What::Garbage;
            if (!fill()) return What::End;
            continue;
        }
        // Other lines may stand in a header before the length; anything else is garbage.
        const std::string_view before = std::string_view(buffer_).substr(0, header);
        const bool garbage = !blank(before) && before.find(':') == std::string_view::npos;
        buffer_.erase(0, header);
        if (garbage) return What::Garbage;
        std::size_t end = end_of_header(buffer_);
        while (end == std::string::npos && buffer_.size() < kLongestHeader) {
            if (!fill()) return What::End;
            end = end_of_header(buffer_);
        }
        const std::size_t length = length_of(buffer_);
        if (end == std::string::npos || length >= kAbsurd) {
            buffer_.erase(0, kLength.size());
            return What::Garbage;
        }
        buffer_.erase(0, end);
        if (length > kLongest) return skip(length) ? What::TooLong : What::End;
        while (buffer_.size() < length)
            if (!fill()) return What::End;
        body.assign(buffer_, 0, length);
        buffer_.erase(0, length);
        if (buffer_.empty()) std::string().swap(buffer_);  // a long message's memory is not kept
        return What::Message;
    }
}

std::optional<Input::What> Input::waiting_line(std::string& body)
{
    const std::size_t end = buffer_.find('\n', looked_);
    if (end == std::string::npos) {
        looked_ = buffer_.size();
        if (buffer_.size() <= kLongest) return {};
        passing_ = true;
        std::string().swap(buffer_);
        looked_ = 0;
        return {};
    }
    body.assign(buffer_, 0, end);
    if (body.ends_with('\r')) body.pop_back();
    buffer_.erase(0, end + 1);
    looked_ = 0;
    if (!std::exchange(passing_, false)) return What::Message;
    body.clear();
    return What::TooLong;
}

Input::What Input::next_line(std::string& body)
{
    for (;;) {
        if (const auto what = waiting_line(body)) return *what;
        if (fill()) continue;
        if (buffer_.empty()) return What::End;
        buffer_ += '\n';  // a last line without its end
    }
}

void Output::send(std::string_view body)
{
    const std::string message = framing_ == Framing::Line
                                    ? fmt::format("{}\n", body)
                                    : fmt::format("Content-Length: {}\r\n\r\n{}", body.size(), body);
    const std::lock_guard lock(mutex_);
    for (std::string_view rest = message; !rest.empty() && !gone_;) {
        const ssize_t written = ::write(file_, rest.data(), rest.size());
        if (written < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (written <= 0) gone_ = true;
        else rest.remove_prefix(static_cast<std::size_t>(written));
    }
}

}  // namespace app::rpc
