#include "render/app/frames/window.h"

#include <fmt/format.h>

namespace app {

namespace {

/// Truncated; 0, which names no row, where it is no number that a row can have.
int whole(float value)
{
    constexpr float kMost = 1e9f;
    return value >= 0.0f && value < kMost ? static_cast<int>(value) : 0;
}

/// Single precision, truncated, as POV-Ray reads them.
int first_of(double start, int size, const char* what)
{
    const auto value = static_cast<float>(start);
    const int first = value >= 0.0f && value < 1.0f ? static_cast<int>(value * static_cast<float>(size))
                                                    : whole(value) - 1;
    if (first < 0 || first >= size) throw OptionError(std::string("invalid start ") + what);
    return first;
}

int last_of(double end, int size, const char* what)
{
    const auto value = static_cast<float>(end);
    const int last = value >= 0.0f && value <= 1.0f ? static_cast<int>(value * static_cast<float>(size)) - 1
                                                    : whole(value) - 1;
    if (last < 0 || last >= size) throw OptionError(std::string("invalid end ") + what);
    return last;
}

}  // namespace

Window window_of(const Settings& s)
{
    const Window window{first_of(s.start_column, s.width, "column"), last_of(s.end_column, s.width, "column"),
                        first_of(s.start_row, s.height, "row"), last_of(s.end_row, s.height, "row")};
    const auto refuse_empty = [](const char* what, int first, int last) {
        if (first > last)
            throw OptionError(fmt::format("nothing to render: the first {}, {}, stands behind the last, {}", what,
                                          first + 1, last + 1));
    };
    refuse_empty("column", window.first_column, window.last_column);
    refuse_empty("row", window.first_row, window.last_row);
    return window;
}

}  // namespace app
