#pragma once

#include "render/kernel/gather/photon.h"

#include <string>
#include <vector>

/// Photon maps in files, as POV-Ray writes them: the number of photons on surfaces, those, the same of media; all
/// numbers with their low bytes first (spec 6, 3.6).
namespace trace {

struct PhotonFile {
    std::vector<Photon> surface, media;
};

/// Throws std::runtime_error that says what is wrong with the file.
PhotonFile read_photon_file(const std::string& path);

/// The same of bytes; `path` is for messages.
PhotonFile decode_photons(const std::vector<char>& bytes, const std::string& path);

/// Throws std::runtime_error where it cannot be written.
void write_photon_file(const std::string& path, const std::vector<Photon>& surface, const std::vector<Photon>& media);

}  // namespace trace
