#pragma once

#include "numbers/polynomial_roots.h"
#include "csg/solids/shared/polynomial_row.h"
#include "numbers/lane_arithmetic.h"

#include <array>
#include <cmath>

/// Sign changes of a polynomial in a range, by its Bernstein ordinates: they hold its values between them, and it
/// changes its sign no more often than they do (Farin, Curves and Surfaces for CAGD, 4), so most ranges without any are
/// told without a root, and the others need but as many brackets as there are changes.
namespace csg {

inline constexpr int kUnsureChanges = -1;

namespace detail {

inline constexpr double kRangeRounding = 8 * 0x1p-53;  ///< a degree

/// `out`, empty before, becomes the ordinates of c between lo and hi. \return what they are off by, at most
template <class V, class Row>
[[gnu::always_inline]] inline V ordinates_between(const V* c, std::size_t degree, const V& lo, const V& hi, Row& out)
{
    // Horner's scheme for a t that goes from lo to hi while the row's goes from 0 to 1.
    const V width = hi - lo, reach = lanes::size_of(lo) + width;
    V size(0.0);
    for (std::size_t k = degree + 1; k-- > 0;) {
        out.times(lo, width);
        out.add(c[k]);
        size = size * reach + lanes::size_of(c[k]);
    }
    out.to_ordinates(degree);
    // Two roundings a step of Horner's, then the share and one sum a step, in parts of what has no signs.
    return V(kRangeRounding * static_cast<double>(degree)) * size;
}

template <int blocks>
class RangeOfPolynomial {
public:
    RangeOfPolynomial(const PolynomialCoefficients& c, int degree, double enough, double* out)
        : c_(c), degree_(degree), enough_(enough), out_(out)
    {}

    int changes(double lo, double hi)
    {
        if (!(lo < hi)) return 0;
        Row b;
        error_ = ordinates_between(c_.data(), static_cast<std::size_t>(degree_), lo, hi, b);
        return search(b, lo, hi, kMostHalvings) ? count_ : kUnsureChanges;
    }

private:
    using Row = PolynomialRow<blocks>;
    static constexpr int kMostHalvings = 8;  ///< what is not parted by then is a touch, or nearly one

    bool search(const Row& b, double lo, double hi, int halvings)
    {
        double ordinates[Row::kSize];
        b.store(ordinates, Row::kSize);
        int clear = 0, positive = 0, turns = 0;
        for (int i = 0; i <= degree_; ++i) {
            clear += std::abs(ordinates[i]) > error_ ? 1 : 0;
            positive += ordinates[i] > 0.0 ? 1 : 0;
        }
        if (clear > degree_) {
            if (positive == 0 || positive > degree_) return true;
            for (int i = 0; i < degree_; ++i) turns += (ordinates[i] > 0.0) != (ordinates[i + 1] > 0.0) ? 1 : 0;
            if (turns == 1) {
                const double first = ordinates[0], last = ordinates[degree_];
                const double chord = lo + (hi - lo) * (first / (first - last));
                out_[count_] = bracketed(c_.data(), degree_, lo, hi, first < 0.0, chord, 1e-16);
                done_ = out_[count_++] > enough_;
                return true;
            }
        }
        if (halvings == 0) return false;
        Row left, right = b;
        right.halve(static_cast<std::size_t>(degree_), left);
        const double middle = 0.5 * (lo + hi);
        return search(left, lo, middle, halvings - 1) && (done_ || search(right, middle, hi, halvings - 1));
    }

    const PolynomialCoefficients& c_;
    int degree_, count_ = 0;
    double enough_;
    bool done_ = false;
    double* out_;
    double error_ = 0.0;
};

}  // namespace detail

/// sign_changes() between lo and hi, at least as far as the first above `enough`; kUnsureChanges where roots are so
/// near to each other that it has to be asked.
inline int sign_changes_between(const PolynomialCoefficients& c, int degree, double lo, double hi, double enough,
                                double (&out)[kMostPolynomialDegree])
{
    if (degree > kMostRowDegree) return kUnsureChanges;
    return degree < PolynomialRow<1>::kSize ? detail::RangeOfPolynomial<1>(c, degree, enough, out).changes(lo, hi)
                                            : detail::RangeOfPolynomial<2>(c, degree, enough, out).changes(lo, hi);
}

}  // namespace csg
