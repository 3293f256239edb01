#include "render/app/run/exit_status.h"

#include "render/app/run/memory.h"
#include "render/files/whole_file.h"
#include "render/image/pixels/passing_failure.h"
#include "render/scene/base/passing_error.h"

#include <new>
#include <system_error>

namespace app {

int status_of(const std::exception& error)
{
    // What the streams of the library throw where a read fails half way, and what finds no memory or thread.
    const auto* system = dynamic_cast<const std::system_error*>(&error);
    const bool passing = dynamic_cast<const TryAgain*>(&error) != nullptr || refuses_thread(error) ||
                         dynamic_cast<const std::bad_alloc*>(&error) != nullptr ||
                         dynamic_cast<const image::PassingFailure*>(&error) != nullptr ||
                         dynamic_cast<const scene::PassingError*>(&error) != nullptr ||
                         (system != nullptr && files::failure_may_pass(system->code().value()));
    return passing ? kTryAgain : kError;
}

}  // namespace app
