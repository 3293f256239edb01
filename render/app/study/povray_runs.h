#pragma once

#include "render/image/files.h"
#include "render/study/study.h"

#include <optional>
#include <string>
#include <vector>

namespace app {

/// Runs the real POV-Ray, to compare pictures and times with.
class PovrayRuns {
public:
    /// \param program name or path; empty or not POV-Ray's: there is none
    explicit PovrayRuns(const std::string& program);
    bool found() const { return !version_.empty(); }
    const std::string& version() const { return version_; }  ///< as it tells it

    struct Found {
        study::Shown picture;
        double seconds;  ///< of photons, radiosity and trace, as it tells them
    };
    /// \param longest seconds after which it is stopped
    /// Nothing: it failed, told no times, or was stopped.
    std::optional<Found> render(const std::string& scene, const std::vector<std::string>& switches,
                                const image::Files& files, double longest) const;

private:
    std::string program_, version_;
};

/// Wall seconds of photons, radiosity and trace together, from the statistics that POV-Ray prints; nothing if there are
/// none.
std::optional<double> povray_seconds(const std::string& text);

}  // namespace app
