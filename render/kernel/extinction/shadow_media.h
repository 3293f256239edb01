#pragma once

#include "render/kernel/extinction/media_extinction.h"

namespace trace {

/// Media on the way of shadow rays, per thread.
struct ShadowMedia {
    MediaShadows shadows;
    MediaShadows area_shadows;  ///< of the samples of an area light
};

}  // namespace trace
