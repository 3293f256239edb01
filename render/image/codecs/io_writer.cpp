#include "render/image/codecs/io_writer.h"

#include "render/image/pixels/passing_failure.h"

#include <cerrno>

namespace image {

namespace {

constexpr std::size_t kRowsAtOnce = 64;

}  // namespace

IoWriter::IoWriter(const IoModule& module, const std::string& path, const FileShape& shape, WriteRequest request)
    : module_(module), row_samples_(static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.channels))
{
    request.path = path.c_str();
    request.width = shape.width;
    request.height = shape.height;
    request.channels = shape.channels;
    request.software = shape.software;
    check(module_.open(request, picture_));
}

IoWriter::~IoWriter()
{
    if (picture_) module_.discard(picture_);
}

void IoWriter::check(const char* message) const
{
    if (message) fail_by_system(errno, message);
}

void IoWriter::write()
{
    const int rows = static_cast<int>(levels_.size() / row_samples_);
    if (rows > 0) check(module_.put(*picture_, written_, rows, levels_.data()));
    written_ += rows;
    levels_.clear();
}

void IoWriter::put(const float* levels)
{
    levels_.insert(levels_.end(), levels, levels + row_samples_);
    if (levels_.size() >= kRowsAtOnce * row_samples_) write();
}

void IoWriter::finish()
{
    write();
    OpenPicture* const ending = picture_;
    picture_ = nullptr;
    check(module_.close(ending));
}

}  // namespace image
