#include "render/image/pixels/passing_failure.h"

#include "render/files/whole_file.h"

#include <cstring>

namespace image {

void fail_by_system(int number, const std::string& text)
{
    const std::string words = text.empty() ? std::strerror(number) : text;
    if (files::failure_may_pass(number)) throw PassingFailure(words);
    throw FileError(words);
}

void fail_named(const std::string& what, const FileError& error)
{
    if (dynamic_cast<const PassingFailure*>(&error) != nullptr) throw PassingFailure(what + error.what());
    throw FileError(what + error.what());
}

}  // namespace image
