#pragma once

#include <exception>
#include <stdexcept>

namespace app {

inline constexpr int kSuccess = 0, kError = 1, kCancelled = 2;  // POV-Ray's exit codes
/// What failed lies with the machine as it is now: a full disk, memory that is gone, a file that went while it was
/// read. sysexits.h calls the number EX_TEMPFAIL, and queues know it.
inline constexpr int kTryAgain = 75;

/// An error of that kind.
struct TryAgain : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The exit status of a run that this error ends: kError or kTryAgain.
int status_of(const std::exception& error);

}  // namespace app
