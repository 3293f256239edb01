#include "render/image/pixels/passing_failure.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace image {

bool failure_may_pass(int number)
{
    constexpr int kPassing[] = {ENOSPC, EDQUOT, EIO,       ESTALE,    ENOMEM,       EMFILE,
                                ENFILE, EAGAIN, ETIMEDOUT, EHOSTDOWN, EHOSTUNREACH, ENOTCONN};
    return std::find(std::begin(kPassing), std::end(kPassing), number) != std::end(kPassing);
}

void fail_by_system(int number, const std::string& text)
{
    const std::string words = text.empty() ? std::strerror(number) : text;
    if (failure_may_pass(number)) throw PassingFailure(words);
    throw FileError(words);
}

void fail_named(const std::string& what, const FileError& error)
{
    if (dynamic_cast<const PassingFailure*>(&error) != nullptr) throw PassingFailure(what + error.what());
    throw FileError(what + error.what());
}

}  // namespace image
