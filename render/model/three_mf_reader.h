#pragma once

#include "render/model/base/model.h"

#include <string_view>

namespace model {

/// Whether bytes begin as those of a ZIP file do.
bool is_zip(std::string_view bytes);

/// A 3MF file (3MF Core Specification 1.3, with colours of the Materials and parts of the Production extension): all
/// that its build names, in the scene's space (3MF is right-handed with z up: y and z change places) and in
/// millimetres, with the names and colours of base materials and colours of corners. Throws ModelError.
Model three_mf_of(std::string_view bytes);

}  // namespace model
