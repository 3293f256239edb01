#pragma once

#include "render/image/files.h"
#include "render/picture/blocks.h"

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace app {

/// --partial: the picture as far as it is done, under its own name, replaced at once every so many seconds; what is not
/// done is black. Holds a copy of the pixels, since others are being traced while it writes.
class GrowingPicture {
public:
    GrowingPicture(const image::Files& files, std::string path, int width, int height,
                   const image::FileSettings& settings, double seconds);
    GrowingPicture(const GrowingPicture&) = delete;
    GrowingPicture& operator=(const GrowingPicture&) = delete;
    ~GrowingPicture() { stop(); }

    /// A block of the picture is done; from any thread.
    void show(const trace::Block& block, const image::Image& picture);
    /// All of it has changed.
    void show(const image::Image& picture);
    /// Nothing is written by itself any more: the whole picture is about to come.
    void stop();
    /// What is done now. False: nothing is, or the file cannot be written.
    bool write();

private:
    void run();
    const image::Files& files_;
    const std::string path_;
    image::FileSettings settings_;
    const double seconds_;
    std::mutex mutex_, writing_;
    std::condition_variable stopping_;
    image::Image shown_;
    bool changed_ = false, any_ = false, stopped_ = false;
    std::thread thread_;
};

}  // namespace app
