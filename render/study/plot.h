#pragma once

#include <string>
#include <vector>

namespace study {

/// Points of one kind. Where `line` says so, those are joined that lie lower than all to the left of them.
struct Series {
    struct Point {
        double x, y;
        std::string name;  ///< shown when pointed at
    };
    std::string name, color;
    bool line = true, dashed = false;
    std::vector<Point> points;
};

struct Axes {
    std::string x, y;        ///< what they measure, with the unit
    std::string unit = "s";  ///< of x, behind a point's value
    double floor = 0.0;      ///< y below which differences mean nothing, drawn as a band; 0: none
    double wanted = 0.0;     ///< y of a line across; 0: none
};

/// A plot with logarithmic axes as an SVG element. Points that are not above 0 lie on the lower edge.
std::string plot(const std::vector<Series>& series, const Axes& axes);

/// A color for the i-th series: distinct for a dozen.
std::string series_color(std::size_t i);

/// Text for HTML and SVG.
std::string escaped(const std::string& text);

}  // namespace study
