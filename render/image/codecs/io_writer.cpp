#include "render/image/codecs/io_writer.h"

#include "render/image/pixels/passing_failure.h"

#include <cerrno>

namespace image {

namespace {

constexpr std::size_t kRowsAtOnce = 64;

}  // namespace

IoWriter::IoWriter(const IoModule& module, const std::string& path, const FileShape& shape, WriteRequest request)
    : module_(module), row_samples_(static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.channels)),
      bits_(shape.bits)
{
    request.path = path.c_str();
    request.width = shape.width;
    request.height = shape.height;
    request.channels = shape.channels;
    request.eight_bits = shape.bits <= 8;
    request.srgb = shape.curve.kind == TransferCurve::Kind::Srgb;
    request.gamma = shape.curve.approximate_gamma();
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

template <class Sample>
void IoWriter::write(std::vector<Sample>& run)
{
    if (run.empty()) return;
    const int rows = static_cast<int>(run.size() / row_samples_);
    check(module_.put(*picture_, written_, rows, run.data()));
    written_ += rows;
    run.clear();
}

template <class Sample>
void IoWriter::add(std::vector<Sample>& run)
{
    if (run.size() >= kRowsAtOnce * row_samples_) write(run);
}

void IoWriter::put(const std::uint16_t* samples)
{
    if (bits_ <= 8) {
        for (std::size_t i = 0; i < row_samples_; ++i)
            bytes_.push_back(static_cast<std::uint8_t>(widened(samples[i], bits_) >> 8));
        return add(bytes_);
    }
    for (std::size_t i = 0; i < row_samples_; ++i) integers_.push_back(widened(samples[i], bits_));
    add(integers_);
}

void IoWriter::put_levels(const float* levels)
{
    levels_.insert(levels_.end(), levels, levels + row_samples_);
    add(levels_);
}

void IoWriter::finish()
{
    write(bytes_);
    write(integers_);
    write(levels_);
    OpenPicture* const ending = picture_;
    picture_ = nullptr;
    check(module_.close(ending));
}

}  // namespace image
