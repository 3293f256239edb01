#include "render/app/output/partial_picture.h"

#include "render/image/picture_writer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace app {

namespace {

/// Pixels that are rounded and written in 0.1 s.
constexpr double kMostPixels = 4e6;
/// Of a picture in strips: they have memory of their own, 16 MB.
constexpr double kMostInStrips = 1e6;

std::string name_beside(const std::string& picture)
{
    std::filesystem::path path(picture);
    path.replace_extension(".partial.png");
    return path.string();
}

int step_for(int width, int height, bool in_strips)
{
    const double most = in_strips ? kMostInStrips : kMostPixels;
    return static_cast<int>(std::ceil(std::sqrt(std::max(1.0, static_cast<double>(width) * height / most))));
}

}  // namespace

PartialPicture::PartialPicture(const image::Files& files, const std::string& path, int width, int height,
                               image::FileSettings settings, bool in_strips)
    : files_(files), path_(name_beside(path)), settings_(std::move(settings)),
      step_(step_for(width, height, in_strips)), in_strips_(in_strips)
{
    settings_.type = image::FileType::Png;
    settings_.encoding.bits = std::min(settings_.encoding.bits, 8);
    settings_.encoding.dither = image::Dither::None;
    settings_.quick = true;
    settings_.fingerprint.clear();
    small_.width = (width - 1) / step_ + 1;
    small_.height = (height - 1) / step_ + 1;
    if (in_strips_) small_.hold(0, small_.height);
}

void PartialPicture::show_row(int left, int width, int row, const float* samples)
{
    if (row % step_ != 0) return;
    for (int x = (left + step_ - 1) / step_ * step_; x < left + width; x += step_)
        std::copy_n(samples + 4 * (x - left), 4, small_.at(x / step_, row / step_));
}

void PartialPicture::show(const trace::Block& block, const float* samples)
{
    if (!in_strips_) return;
    for (int row = 0; row < block.height; ++row)
        show_row(block.left, block.width, block.top + row,
                 samples + std::size_t{4} * static_cast<std::size_t>(row) * static_cast<std::size_t>(block.width));
}

void PartialPicture::show(const image::Image& picture)
{
    if (!in_strips_) return;
    const auto rows = static_cast<int>(picture.pixels.size() / 4 / static_cast<std::size_t>(picture.width));
    for (int row = picture.top; row < picture.top + rows; ++row) show_row(0, picture.width, row, picture.at(0, row));
}

std::string PartialPicture::write(const image::Image& picture)
{
    try {
        show(picture);
        const auto writer = files_.start(path_, small_.width, small_.height, settings_);
        std::vector<float> reduced(4 * static_cast<std::size_t>(small_.width));
        for (int row = 0; row < small_.height; ++row) {
            if (in_strips_ || step_ == 1) {
                writer->put((in_strips_ ? small_ : picture).at(0, row));
                continue;
            }
            for (int x = 0; x < small_.width; ++x)
                std::copy_n(picture.at(x * step_, row * step_), 4, &reduced[4 * static_cast<std::size_t>(x)]);
            writer->put(reduced.data());
        }
        writer->finish();
    } catch (const std::exception&) {
        return "";  // the state is what counts
    }
    return path_;
}

void PartialPicture::remove() const { std::remove(path_.c_str()); }

}  // namespace app
