#pragma once

#include "render/scene/base/message.h"
#include "render/kernel/gather/photon_map.h"
#include "render/kernel/radiosity/samples/field.h"

#include <memory>
#include <optional>

namespace trace {

/// Light that the passes before the picture have found; read by all threads while the picture is traced.
struct IndirectLight {
    std::optional<scene::Error> failed_save;      ///< why a file that was asked for could not be written
    PhotonMap photons, media_photons;             ///< on surfaces; in media
    std::unique_ptr<radiosity::Field> radiosity;  ///< null: off
};

}  // namespace trace
