#pragma once

namespace app {

/// Takes addresses for the memory that a run is going to ask for, so that it comes in pages of 2 MB past the first few
/// and is not given back only to be asked for again. Once, at the beginning: nothing is touched, so nothing is used.
/// In pages of 4 kB a scene of 100 MB spent half of its reading in the kernel.
void prepare_heap();

}  // namespace app
