#pragma once

#include "parser/stream/values/symbols.h"

#include <map>
#include <string>

namespace parser {

/// Numbers, vectors, colours and texts that names stand for now, as a scene would write them: what an editor shows.
/// Long texts and names beyond some thousands are left out.
std::map<std::string, std::string> told_values(const Symbols& symbols, const Names& names);

}  // namespace parser
