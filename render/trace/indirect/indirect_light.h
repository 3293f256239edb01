#pragma once

namespace trace {

/// Light that the passes before the picture have found; read by all threads while the picture is traced.
struct IndirectLight {};

}  // namespace trace
