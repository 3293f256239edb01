#include "render/app/output/growing_picture.h"

#include <algorithm>
#include <chrono>

namespace app {

GrowingPicture::GrowingPicture(const image::Files& files, std::string path, int width, int height,
                               const image::FileSettings& settings, double seconds)
    : files_(files), path_(std::move(path)), settings_(settings), seconds_(seconds), shown_{width, height, {}, 0}
{
    settings_.fingerprint.clear();  // not the whole of it
    shown_.hold(0, height);
    thread_ = std::thread([this] { run(); });
}

void GrowingPicture::show(const trace::Block& block, const image::Image& picture)
{
    const std::lock_guard lock(mutex_);
    for (int row = block.top; row < block.top + block.height; ++row)
        std::copy_n(picture.at(block.left, row), 4 * block.width, shown_.at(block.left, row));
    changed_ = any_ = true;
}

void GrowingPicture::show(const image::Image& picture)
{
    const std::lock_guard lock(mutex_);
    shown_.pixels = picture.pixels;
    changed_ = any_ = true;
}

void GrowingPicture::stop()
{
    {
        const std::lock_guard lock(mutex_);
        stopped_ = true;
    }
    stopping_.notify_all();
    if (thread_.joinable()) thread_.join();
}

bool GrowingPicture::write()
{
    const std::lock_guard one(writing_);
    image::Image copy;
    {
        const std::lock_guard lock(mutex_);
        if (!any_) return false;
        copy = shown_;
        changed_ = false;
    }
    try {
        files_.write(path_, copy, settings_);
        return true;
    } catch (const std::exception&) {
        return false;  // the whole picture will tell why
    }
}

void GrowingPicture::run()
{
    for (;;) {
        {
            std::unique_lock lock(mutex_);
            if (stopping_.wait_for(lock, std::chrono::duration<double>(seconds_), [this] { return stopped_; })) return;
            if (!changed_) continue;
        }
        write();
    }
}

}  // namespace app
