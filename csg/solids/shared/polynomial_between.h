#pragma once

#include "numbers/polynomial_roots.h"
#include "csg/solids/shared/polynomial_row.h"

#include <array>
#include <cmath>

/// Sign changes of a polynomial in a range, by its Bernstein ordinates: they hold its values between them, and it
/// changes its sign no more often than they do (Farin, Curves and Surfaces for CAGD, 4), so most ranges without any are
/// told without a root, and the others need but as many brackets as there are changes.
namespace csg {

inline constexpr int kUnsureChanges = -1;

namespace detail {

inline constexpr int kMostRowDegree = 15;

/// 1 / (k of n)
inline constexpr auto kRowShares = [] {
    std::array<std::array<double, kMostRowDegree + 1>, kMostRowDegree + 1> out{};
    for (std::size_t n = 0; n < out.size(); ++n) {
        double ways = 1.0;
        for (std::size_t k = 0; k <= n; ++k) {
            out[n][k] = 1.0 / ways;
            ways = ways * static_cast<double>(n - k) / static_cast<double>(k + 1);
        }
    }
    return out;
}();

template <int blocks>
class RangeOfPolynomial {
public:
    RangeOfPolynomial(const PolynomialCoefficients& c, int degree, double* out) : c_(c), degree_(degree), out_(out) {}

    int changes(double lo, double hi)
    {
        if (!(lo < hi)) return 0;
        // Horner's scheme for a t that goes from lo to hi while the row's goes from 0 to 1.
        const double width = hi - lo, reach = std::abs(lo) + width;
        Row b;
        double size = 0.0;
        for (int k = degree_; k >= 0; --k) {
            const double c = c_[static_cast<std::size_t>(k)];
            b.times(lo, width);
            b.add(c);
            size = size * reach + std::abs(c);
        }
        // Two roundings a step of Horner's, then the share and one sum a step, in parts of what has no signs.
        error_ = kRounding * degree_ * size;
        const auto& shares = kRowShares[static_cast<std::size_t>(degree_)];
        Row share;
        std::memcpy(share.v, shares.data(), sizeof share.v);
        for (int i = 0; i < blocks; ++i) b.v[i] *= share.v[i];
        const Row place = row_places<blocks>();
        for (int k = 1; k <= degree_; ++k) {
            const Row up = b.raised();
            for (int i = 0; i < blocks; ++i) b.v[i] += place.v[i] >= static_cast<double>(k) ? up.v[i] : EightNumbers{};
        }
        return search(b, lo, hi, kMostHalvings) ? count_ : kUnsureChanges;
    }

private:
    using Row = PolynomialRow<blocks>;
    static constexpr double kRounding = 8 * 0x1p-53;  ///< a degree
    static constexpr int kMostHalvings = 8;           ///< what is not parted by then is a touch, or nearly one

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
                out_[count_++] = bracketed(c_.data(), degree_, lo, hi, first < 0.0, chord, 1e-16);
                return true;
            }
        }
        if (halvings == 0) return false;
        Row left, right = b;
        const Row place = row_places<blocks>();
        for (int k = 0; k <= degree_; ++k) {
            const double head = right.v[0][0];
            const Row down = right.lowered();
            for (int i = 0; i < blocks; ++i) {
                left.v[i] = place.v[i] == static_cast<double>(k) ? EightNumbers{} + head : left.v[i];
                right.v[i] = place.v[i] < static_cast<double>(degree_ - k) ? 0.5 * (right.v[i] + down.v[i])
                                                                           : right.v[i];
            }
        }
        const double middle = 0.5 * (lo + hi);
        return search(left, lo, middle, halvings - 1) && search(right, middle, hi, halvings - 1);
    }

    const PolynomialCoefficients& c_;
    int degree_, count_ = 0;
    double* out_;
    double error_ = 0.0;
};

}  // namespace detail

/// sign_changes() between lo and hi, for a polynomial that has none beyond them; kUnsureChanges where roots are so near
/// to each other that it has to be asked.
inline int sign_changes_between(const PolynomialCoefficients& c, int degree, double lo, double hi,
                                double (&out)[kMostPolynomialDegree])
{
    if (degree > detail::kMostRowDegree) return kUnsureChanges;
    return degree < PolynomialRow<1>::kSize ? detail::RangeOfPolynomial<1>(c, degree, out).changes(lo, hi)
                                            : detail::RangeOfPolynomial<2>(c, degree, out).changes(lo, hi);
}

}  // namespace csg
