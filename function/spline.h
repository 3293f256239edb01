#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace function {

/// A curve through values at knots (reference manual 3.3.1.10; spec 1, 12). Immutable once shared.
class Spline {
public:
    enum class Kind : std::uint8_t { Linear, Quadratic, Cubic, Natural };
    using Values = std::array<double, 5>;

    Kind kind = Kind::Linear;

    /// A value of `count` components at t. A knot that is there is replaced, unless it is the last: then the new value
    /// is lost. The spline has as many components as its widest value.
    void add(double t, const Values& value, std::uint32_t count);
    std::uint32_t components() const { return components_; }
    std::size_t size() const { return knots_.size(); }

    /// The curve at t; constant beyond the ends. At least one knot. Components past components() are 0.
    Values at(double t) const { return at(t, kind); }
    Values at(double t, Kind as) const;
    /// After the last knot: what every value of a natural spline needs is worked out once.
    void finish();

private:
    struct Knot {
        double t;
        Values value;
    };
    std::vector<Values> second_derivatives() const;
    std::vector<Knot> knots_;          ///< by t
    std::vector<Values> derivatives_;  ///< of second order, at the knots; empty: not finished
    std::uint32_t components_ = 2;
};

}  // namespace function
