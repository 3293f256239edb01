#pragma once

#include "render/study/plot.h"
#include "render/study/study.h"

#include <string>
#include <vector>

namespace study {

/// How results of a kind look, the same on every page.
/// \param family  as the ladder names it
Look look_of(const std::string& family);

/// Whether a kind stands for light between surfaces: radiosity, photons or paths.
bool is_between_surfaces(const std::string& family);

/// The results of each kind, in the order in which the kinds come.
/// \param between  those of light between surfaces, or all others
std::vector<Series> series_of(const std::vector<Result>& results, bool between);

}  // namespace study
