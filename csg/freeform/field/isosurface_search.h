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

    /// Takes a stretch of the way; the two below are asked about the last one. What its ranges or its polynomial say is
    /// found out here.
    void look(double from, double end);
    /// value(from) < 0.
    bool starts_inside() const;
    /// Where sign * value first falls below 0, as POV-Ray tells it: the farther end of the interval, shorter than the
    /// accuracy, that halving leads to.
    bool first(double sign, double& found);

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
    /// What is known of a stretch before the field is asked at any point of it.
    struct Stretch {
        double from = 0.0, end = 0.0;
        Grid grid{};
        int levels = 0;           ///< eighths of eighths that the grid has
        bool polynomial = false;  ///< known by that, not by ranges
        EightRanges ranges;
        FieldPolynomial along;
        double margin;  ///< of ordinates of `along`: no value of the field lies beyond them by more

        std::int64_t parts() const { return std::int64_t{1} << (3 * levels); }
    };
    /// Of a field that is convex along the ray: the place on the grid of so many parts that eighths() comes to.
    bool comes_in(const Grid& grid, std::int64_t parts, double& found) const;
    bool goes_out(const Grid& grid, std::int64_t parts, double& found) const;
    /// POV-Ray's interval that ends at a place of the grid or behind; what is thinner than it is found all the same.
    template <class IsMet>
    static double told(const Grid& grid, std::int64_t place, IsMet&& is_met)
    {
        const std::int64_t end = ((place + (std::int64_t{1} << grid.finer) - 1) >> grid.finer) << grid.finer;
        return grid.at(end == place || !is_met(end) ? place : end);
    }
    double told(const Grid& grid, std::int64_t place, double sign) const
    {
        return told(grid, place, [&](std::int64_t end) { return sign * value(grid.at(end)) < 0.0; });
    }
    bool by_ranges() const { return terms_.field->ranged() && !terms_.trusting; }
    void ranges_of(const Grid& grid, std::int64_t first, int level, EightRanges& f) const;
    bool eighths(const Grid& grid, std::int64_t first, int level, double sign, double& found) const;
    bool eighths(const EightRanges& f, const Grid& grid, std::int64_t first, int level, double sign,
                 double& found) const;
    bool find_polynomial();
    /// eighths() of a polynomial field, which comes to the same place.
    bool by_polynomial(double sign, double& found) const;
    struct Halving;
    /// b: ordinates of sign * (field - threshold) over the parts [first, first + width) of the grid.
    template <std::size_t count>
    bool halves(const std::array<double, count>& b, std::int64_t first, std::int64_t width, Halving& search) const;
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
    Stretch known_;
};

}  // namespace csg
