#pragma once

namespace web {

/// The whole page: HTML with its style and its script (render/web/page).
extern const char* const kPage;

}  // namespace web
