#pragma once

#include "render/scene/base/message.h"

namespace scene {

/// An error of a file that was found and could not be read: it lies with the machine as it is now, so that another try
/// may go well.
struct PassingError : Error {
    explicit PassingError(const Error& error) : Error(error) {}
};

/// Runs what throws an Error, which then is a passing one.
template <class Failing>
[[noreturn]] void fail_for_now(Failing&& fail)
{
    try {
        fail();
    } catch (const Error& told) {
        throw PassingError(told);
    }
    throw std::logic_error("this was to fail");
}

}  // namespace scene
