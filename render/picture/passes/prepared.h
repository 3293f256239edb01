#pragma once

#include "render/kernel/radiosity/samples/sample.h"
#include "render/picture/passes/photon_file.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trace {

struct IndirectLight;

/// What the passes before a picture find, and what one ray costs where (cut.h): found once, for many parts of one
/// picture. The samples of radiosity are as they were, where files of samples round them.
struct Prepared {
    PhotonFile photons;
    std::vector<radiosity::Found> samples;  ///< bounce after bounce, in their order
    std::vector<double> costs;

    Prepared() = default;
    /// \param light  null: the scene has none
    Prepared(const IndirectLight* light, std::vector<double> of_places);
};

std::string bytes_of(const Prepared& prepared);
/// Nothing for bytes that are none, or not all.
std::optional<Prepared> prepared_of(std::string_view bytes);

}  // namespace trace
