#include "render/image/picture_writer.h"

#include "render/image/file_types.h"
#include "render/image/pixels/passing_failure.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace image {

namespace {

/// Machines that share a folder have processes of the same number.
std::string own_name()
{
    std::array<char, 64> host{};
    gethostname(host.data(), host.size() - 1);
    constexpr std::size_t kShort = 16;  // names of files have an end
    return std::string(host.data()).substr(0, kShort) + "." + std::to_string(getpid());
}

bool on_disk(const char* path, int flags)
{
    const int file = open(path, flags | O_CLOEXEC);
    if (file < 0) return false;
    const bool done = fsync(file) == 0 || errno == EINVAL;  // some file systems have nothing to do for a folder
    close(file);
    return done;
}

}  // namespace

Replacement::Replacement(const std::string& path) : path_(path), temporary_(path + "." + own_name() + ".part") {}

Replacement::~Replacement()
{
    if (!placed_) std::remove(temporary_.c_str());
}

void Replacement::put_in_place(bool lasting)
{
    if ((lasting && !on_disk(temporary_.c_str(), O_RDONLY)) || std::rename(temporary_.c_str(), path_.c_str()) != 0)
        fail_by_system(errno, "cannot write '" + path_ + "': " + std::strerror(errno));
    placed_ = true;
    const std::size_t slash = path_.rfind('/');
    if (lasting) on_disk(slash == std::string::npos ? "." : path_.substr(0, slash + 1).c_str(), O_RDONLY | O_DIRECTORY);
}

/// The sinks' messages name no file.
template <class Work>
void PictureWriter::named(Work&& work) const
{
    try {
        work();
    } catch (const FileError& error) {
        fail_named("cannot write '" + replacement_.path() + "': ", error);
    }
}

PictureWriter::PictureWriter(IoLoader& loader, const std::string& path, int width, int height,
                             const FileSettings& settings)
    : width_(width), height_(height), bottom_up_(settings.type == FileType::Bmp), lasting_(settings.lasting),
      replacement_(path)
{
    const TypeFacts& type = facts(settings.type);
    Encoding encoding = settings.encoding;
    encoding.alpha = encoding.alpha && type.alpha;
    FileShape shape{
        width,           height, encoding.alpha ? 4 : 3, 16, encoding.curves.file, kSoftware, settings.fingerprint,
        settings.carried};
    if (type.linear_light) {
        working_ = encoding.curves.working;
        alpha_ = encoding.alpha;
        named([&] { levels_ = level_sink(loader, settings.type, replacement_.temporary(), shape); });
        return;
    }
    if (!type.sixteen_bits) encoding.bits = 8;
    if (settings.type == FileType::Jpeg) encoding.dither = Dither::None;  // it would lose the pattern
    rounding_ = std::make_unique<RowQuantiser>(width, height, encoding);
    shape.channels = rounding_->channels();
    shape.bits = rounding_->bits();
    row_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(shape.channels));
    named([&] {
        sink_ = integer_sink(settings.type, replacement_.temporary(), shape, settings.jpeg_quality, settings.quick);
    });
}

PictureWriter::~PictureWriter()
{
    sink_.reset();  // before their file is removed
    levels_.reset();
}

/// Linear light, colours weighted by opacity, as OpenEXR and Radiance store it.
void PictureWriter::put_linear(const float* pixels)
{
    level_row_.clear();
    for (int x = 0; x < width_; ++x, pixels += 4) {
        for (std::size_t c = 0; c < 3; ++c) level_row_.push_back(working_.decode(pixels[c]));
        if (alpha_) level_row_.push_back(1.0f - pixels[3]);
    }
    named([&] { levels_->put(level_row_.data()); });
}

void PictureWriter::put(const float* pixels)
{
    const int row = next_row();
    ++taken_;
    if (!rounding_) return put_linear(pixels);
    rounding_->round(row, pixels, row_.data());
    named([&] { sink_->put(row_.data()); });
}

void PictureWriter::finish()
{
    named([&] { sink_ ? sink_->finish() : levels_->finish(); });
    replacement_.put_in_place(lasting_);
}

}  // namespace image
