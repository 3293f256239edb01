#pragma once

#include "parser/form/form.h"

namespace parser {

/// The scene language from a whole scene down, told from the rules that read it: `whittle --grammar`, words for
/// editors.
const std::vector<Production>& grammar();

}  // namespace parser
