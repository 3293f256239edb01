#pragma once

#include "render/solid/section/cutting_plane.h"

#include <array>
#include <string>
#include <vector>

/// Cuts as files.
namespace solid {

/// One object of a drawing.
struct DrawnPart {
    std::string name;
    std::array<double, 3> color{0.7, 0.7, 0.7};  ///< sRGB, 0 to 1
    std::vector<Loop> loops;                     ///< in scene units, y upward
};

enum class DrawingFormat { Svg, Dxf };

/// By the end of the name; throws std::runtime_error with those that there are.
DrawingFormat drawing_format_of(const std::string& path);

/// SVG: a group a part with its name and colour, one path in it, filled by the even-odd rule. Numbers are those of the
/// scene, y upward; a unit is a millimetre. `exact`: how finely, in scene units.
std::string svg_text(const std::vector<DrawnPart>& parts, const std::string& title, double exact);

/// DXF of AutoCAD's release 12, in ASCII: a layer a part, a closed POLYLINE a loop.
std::string dxf_text(const std::vector<DrawnPart>& parts, double exact);

}  // namespace solid
