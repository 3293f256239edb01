#pragma once

#include "render/app/run/stage_options.h"
#include "render/image/pixels/image.h"
#include "render/image/levels/quantise.h"
#include "render/picture/blocks.h"

#include <string>

namespace app {

/// As the picture's file would have its samples, but 8 bits, in colour and undithered: what a page shows.
image::Encoding page_encoding(const Settings& settings, const scene::Description& description);

/// A block of one pass as JSON: its samples, as the picture's file would have them, in base64.
/// \param pass  its number
/// \param picture  of that pass, which covers the view whatever its size
std::string block_event(int generation, int pass, const trace::Block& block, const image::Image& picture,
                        const image::Encoding& encoding);

}  // namespace app
