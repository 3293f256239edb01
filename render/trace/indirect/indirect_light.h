#pragma once

#include "render/trace/photon/photon_map.h"
#include "render/trace/radiosity/field.h"

#include <memory>
#include <string>

namespace trace {

/// Light that the passes before the picture have found; read by all threads while the picture is traced.
struct IndirectLight {
    std::string failed_save;                      ///< why a file that was asked for could not be written; empty: it was
    PhotonMap photons, media_photons;             ///< on surfaces; in media
    std::unique_ptr<radiosity::Field> radiosity;  ///< null: off
};

}  // namespace trace
