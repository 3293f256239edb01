#pragma once

#include "render/app/options/settings.h"

namespace app {

/// The part of the picture to render: columns and rows from 0, inclusive.
struct Window {
    int first_column, last_column, first_row, last_row;
};

/// From +SC +EC +SR +ER (spec 1, 18.6): a start below 1 or an end of at most 1 is a share of the picture, other numbers
/// are columns and rows counted from 1.
/// Throws OptionError for a window that leaves the picture.
Window window_of(const Settings& settings);

}  // namespace app
