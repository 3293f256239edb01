#pragma once

#include <string>
#include <vector>

namespace study {

enum class Mark { Disc, Square, Triangle, Diamond, Count };

/// How a series is told from others: by its color for most eyes, by color and mark for all.
struct Look {
    std::string color;
    Mark mark = Mark::Disc;
};

/// Points of one kind. Where `line` says so, those are joined that lie lower than all to the left of them.
struct Series {
    struct Point {
        double x, y;
        std::string name;  ///< shown when pointed at
    };
    std::string name;
    Look look;
    bool line = true, dashed = false;  ///< dashed: another program's, its marks are open
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

/// The i-th of seven colors that are told apart with any common color blindness (Okabe and Ito 2008, the yellow
/// darkened, black made grey).
Look look(std::size_t color, Mark mark);
/// The i-th of all: one color after another, then all with the next mark.
Look look(std::size_t i);

/// Text for HTML and SVG.
std::string escaped(const std::string& text);

}  // namespace study
