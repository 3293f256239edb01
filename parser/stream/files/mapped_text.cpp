#include "parser/stream/files/mapped_text.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

namespace parser {

MappedText::MappedText(const std::string& path, std::size_t least)
{
    struct stat before {
    }, leased{};
    if (stat(path.c_str(), &before) != 0 || !S_ISREG(before.st_mode) || before.st_size < 0 ||
        static_cast<std::size_t>(before.st_size) < least || before.st_size == 0)
        return;
    file_ = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file_ < 0 || !take_lease() || fstat(file_, &leased) != 0 || leased.st_size != before.st_size) return;
    const auto size = static_cast<std::size_t>(leased.st_size);
    void* const memory = mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, file_, 0);
    if (memory == MAP_FAILED) return;
    memory_ = memory;
    size_ = size;
}

MappedText::~MappedText()
{
    if (memory_) munmap(memory_, size_);
    if (file_ >= 0) close(file_);  // with its lease
}

/// The system tells by a signal that somebody waits to write to the file. SIGURG is ignored by default, which is right
/// here: the lease is held for a short while only.
bool MappedText::take_lease() const
{
    return fcntl(file_, F_SETSIG, SIGURG) == 0 && fcntl(file_, F_SETLEASE, F_RDLCK) == 0;
}

}  // namespace parser
