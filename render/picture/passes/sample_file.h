#pragma once

#include "render/kernel/radiosity/samples/sample_grid.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trace::radiosity {

/// POV-Ray's files of samples (`.rca`): one a line, without quality, directions in steps of 1/127 (spec 6, 4.9).
std::string line_of(const Found& found);
/// Nothing for lines that hold no sample.
std::optional<Found> sample_of(std::string_view line);

/// All samples of a file, by line. Throws std::runtime_error if it cannot be read.
std::vector<Found> read_samples(const std::string& path);
/// Throws std::runtime_error if it cannot be written. samples: by bounce.
void write_samples(const std::string& path, const std::vector<SampleGrid>& samples);

}  // namespace trace::radiosity
