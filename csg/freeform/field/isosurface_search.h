#pragma once

#include "csg/freeform/field/isosurface.h"

#include <array>
#include <cstdint>

namespace csg {

inline constexpr double kPointRoom = 4 * 0x1p-52;  ///< relative error of a point of the ray, generously

/// One ray through the field of an isosurface.
class IsosurfaceSearch {
public:
    /// Of a ray that is within the container along `way`. Nothing beyond `to` matters.
    IsosurfaceSearch(const IsosurfaceTerms& terms, const Ray& ray, const Interval& way, double to);

    /// No interval is parted that is shorter: the scene's, unless the way is so long that numbers are coarser.
    double accuracy() const { return accuracy_; }
    static double accuracy_along(const IsosurfaceTerms& terms, const Interval& way);
    /// Whether the ray begins so far off that its points need one rounding each.
    static bool is_far(const Container& container, const Ray& ray);

    /// The field above the threshold.
    double value(double t) const
    {
        const glm::dvec3 p = far_ ? near_point(t) : ray_.at(t);
        return (box_ != nullptr ? (*box_)(p) : terms_.field->value(p)) - terms_.threshold;
    }

    /// value(from) < 0. What is found out for that first() need not find out again, if it is asked for the same stretch
    /// next.
    bool inside(double from, double end);

    /// Where sign * value first falls below 0 between `from` and `end`, as POV-Ray tells it: the farther end of the
    /// interval, shorter than the accuracy, that halving leads to.
    bool first(double from, double end, double sign, double& found);

private:
    struct Sample {
        double t, f;
    };
    /// Where intervals end. POV-Ray's are 2^finer of these.
    struct Grid {
        double from, step;
        int finer;
        double at(std::int64_t i) const { return from + step * static_cast<double>(i); }
    };
    /// Bernstein's of the field above the threshold along a part of the ray: no value lies outside of them all by more
    /// than `margin`, nor does what value() answers.
    struct Ordinates {
        std::array<double, FieldPolynomial::kMost + 1> b;
        int degree;
        double margin;

        bool above() const;
        void turn();                                         ///< changes all signs
        void part(Ordinates& left, Ordinates& right) const;  ///< over both halves
    };
    /// Of a field that is convex along the ray: the place on the grid of so many parts that eighths() comes to.
    bool comes_in(const Grid& grid, std::int64_t parts, double& found) const;
    bool goes_out(const Grid& grid, std::int64_t parts, double& found) const;
    /// POV-Ray's interval that ends at a place of the grid or behind; what is thinner than it is found all the same.
    double told(const Grid& grid, std::int64_t place, double sign) const
    {
        const std::int64_t end = ((place + (std::int64_t{1} << grid.finer) - 1) >> grid.finer) << grid.finer;
        return grid.at(end == place || !(sign * value(grid.at(end)) < 0.0) ? place : end);
    }
    bool by_ranges() const { return terms_.field->ranged() && !terms_.trusting; }
    Grid grid_between(double from, double end, int& levels) const;
    void ranges_of(const Grid& grid, std::int64_t first, int level, EightRanges& f) const;
    bool eighths(const Grid& grid, std::int64_t first, int level, double sign, double& found) const;
    bool eighths(const EightRanges& f, const Grid& grid, std::int64_t first, int level, double sign,
                 double& found) const;
    /// What first() knows of a polynomial field over the grid; false: it is not known to be one there.
    bool find_ordinates(const Grid& grid, std::int64_t parts, Ordinates& out) const;
    /// eighths() of a polynomial field, which comes to the same place. `leaves`: how many may be asked for their
    /// values; none are left where it gave up.
    bool halves(const Grid& grid, const Ordinates& of, std::int64_t first, std::int64_t width, double sign,
                double& found, int& leaves) const;
    /// Those of the eight finest parts from `first` on whose bit is set in `open`.
    bool in_leaves(const Grid& grid, std::int64_t first, std::uint32_t open, double sign, double& found) const;
    bool bisect(const Sample& left, const Sample& right, double sign, double& found);
    void sample(const Eight& t, double sign, Eight& f) const;
    /// With one rounding of where it is, whatever the ray comes from.
    glm::dvec3 near_point(double t) const;

    const IsosurfaceTerms& terms_;
    const Ray& ray_;
    const RoundedBox* box_;  ///< what the field is, or null
    double to_, speed_, gradient_, accuracy_;
    bool far_;  ///< the ray begins so far off that its points need near_point()
    struct {
        double from = 0.0, end = -1.0;
        bool polynomial = false;  ///< known by its ordinates, not by ranges of eighths
        EightRanges ranges;
        Ordinates ordinates;
    } asked_;  ///< by inside(): of a stretch; before that nothing
};

}  // namespace csg
