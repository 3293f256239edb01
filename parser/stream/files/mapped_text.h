#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace parser {

/// The bytes of a long file where the system keeps them: without memory of our own to copy them to. While it lives the
/// file stays as it is: who wants to write to it or shorten it waits (a lease). Empty where the system gives none, as
/// while somebody has the file open for writing, or where the file belongs to somebody else.
class MappedText {
public:
    /// A file of fewer bytes than `least` is not worth it.
    MappedText(const std::string& path, std::size_t least);
    MappedText(const MappedText&) = delete;
    MappedText& operator=(const MappedText&) = delete;
    ~MappedText();
    explicit operator bool() const { return memory_ != nullptr; }
    std::string_view text() const { return {static_cast<const char*>(memory_), size_}; }

private:
    bool take_lease() const;
    int file_ = -1;
    void* memory_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace parser
