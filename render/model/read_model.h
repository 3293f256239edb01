#pragma once

#include "render/model/base/model.h"

#include <string_view>

namespace model {

/// A file of any of the kinds that there are readers for: what it is is told by its bytes, else by the end of its name.
/// Throws ModelError.
/// \param name the file's, for its ending
Model model_of(std::string_view bytes, std::string_view name);

}  // namespace model
