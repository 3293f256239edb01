#include "render/app/picture/picture_part.h"

#include "render/image/pixels/passing_failure.h"

#include <algorithm>
#include <cstring>

namespace app {

PicturePart::PicturePart(const std::string& path, BlocksOf of) : of_(std::move(of)), replacement_(path) {}

BlockWriter& PicturePart::writer()
{
    if (!writer_) writer_ = std::make_unique<BlockWriter>(replacement_.temporary(), of_, 0);
    return *writer_;
}

void PicturePart::put(std::size_t first, std::size_t last, const image::Image& picture)
{
    for (auto i = std::lower_bound(of_.wanted.begin(), of_.wanted.end(), first); i != of_.wanted.end() && *i < last;
         ++i)
        writer().put(std::size_t{*i}, of_.blocks[*i], picture);
}

void PicturePart::put(const image::Channels& layers)
{
    const std::size_t length = layers.names.size() * static_cast<std::size_t>(layers.width);
    std::uint64_t row = static_cast<std::uint64_t>(layers.top);
    for (auto at = layers.values.begin(); at != layers.values.end(); at += static_cast<std::ptrdiff_t>(length), ++row)
        writer().put(Record::kLayerRow | row, {at, at + static_cast<std::ptrdiff_t>(length)});
}

void PicturePart::finish()
{
    if (!writer().finish())
        image::fail_by_system(writer_->error(),
                              "cannot write '" + replacement_.path() + "': " + std::strerror(writer_->error()));
    replacement_.put_in_place(true);
}

}  // namespace app
