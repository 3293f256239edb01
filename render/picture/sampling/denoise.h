#pragma once

#include "render/image/pixels/image.h"
#include "render/kernel/path/path_tracer.h"
#include "render/picture/sampling/sampled_picture.h"

#include <vector>

namespace trace {

/// What the paths of each pixel have seen first, added up: what a filter goes by that must not mix different surfaces.
class PathFeatures {
public:
    PathFeatures(int width, int height)
        : width_(width), pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    {}

    struct Pixel {
        glm::vec3 albedo{0}, normal{0};
        float depth = 0;
    };
    static constexpr double kBytesPerPixel = sizeof(Pixel) + 96;  ///< with what denoise() needs

    void add(int x, int y, const PathFound& found)
    {
        Pixel& at = pixels_[index(x, y)];
        at.albedo += found.albedo;
        at.normal += found.normal;
        at.depth += found.depth;
    }
    const Pixel& sum(int x, int y) const { return pixels_[index(x, y)]; }

private:
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    int width_;
    std::vector<Pixel> pixels_;
};

/// Writes filtered means of the samples into `image`, as SampledPicture::show() writes plain ones:
/// docs/path_tracing.md. threads: 0 for all cores; the same for any number.
void denoise(const SampledPicture& samples, const PathFeatures& features, int threads, image::Image& image);

}  // namespace trace
