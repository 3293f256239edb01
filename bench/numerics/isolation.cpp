#include "bench/numerics/isolation.h"

#include <array>
#include <limits>
#include <type_traits>

namespace numerics {
namespace {

constexpr std::size_t kMostDegree = 36;
/// Halvings of a piece; touching roots nearer than 2^-20 of the range are left to the slow way.
constexpr int kDeepest = 20;

/// From here on a piece whose signs doubles leave in doubt is looked at in 113 bits.
constexpr int kWider = 3;

template <class T>
using Coefficients = std::array<T, kMostDegree + 1>;

enum class Roots { None, One, Several, Doubt };

/// b[k] <- coefficient k of b(t + a).
template <class T>
void shift(Coefficients<T>& b, std::size_t n, T a)
{
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = n; j-- > i;) b[j] += a * b[j + 1];
}

/// A polynomial of units u in numbers of type T: doubles, each coefficient within half a last bit, or the 113 bits
/// themselves.
template <class T>
class Isolation {
public:
    Isolation(const QuadPolynomial& p, std::size_t degree, Quad unit) : n_(degree)
    {
        Coefficients<Quad> scaled;
        Quad power = 1, largest = 0;
        for (std::size_t k = 0; k <= n_; ++k, power *= unit) {
            scaled[k] = p.c[k] * power;
            largest = std::max(largest, absolute(scaled[k]));
        }
        // 2 n additions and multiplications shift, n scale, n(n - 1)/2 additions of which no path is longer than n
        // change the basis, and the ends and coefficients are rounded themselves: 6 n + 3 roundings at most, doubled
        // for those of the bound.
        const T rounding = std::is_same_v<T, double> ? T(0x1p-53) : T(0x1p-113);
        slack_ = static_cast<T>(12 * n_ + 6) * rounding;
        for (std::size_t k = 0; k <= n_; ++k) {
            c_[k] = static_cast<T>(scaled[k] / largest);
            size_[k] = c_[k] < 0 ? -c_[k] : c_[k];
        }
    }

    /// How many roots lie between a and b, as far as signs that are beyond doubt prove it.
    Roots between(double a, double b) const
    {
        // From the end that is nearer to 0 outwards: the other way round terms would cancel.
        const T from = std::abs(a) <= std::abs(b) ? a : b,
                width = from == a ? static_cast<T>(b) - a : static_cast<T>(a) - b;
        Coefficients<T> value = c_, bound = size_;
        if (from != 0) shift(value, n_, from), shift(bound, n_, from < 0 ? -from : from);
        T power = 1;
        for (std::size_t k = 0; k <= n_; ++k, power *= width) value[k] *= power, bound[k] *= power < 0 ? -power : power;
        // (1 + x)^n p(1 / (1 + x)): its coefficients are Bernstein's times positive numbers.
        std::reverse(value.begin(), value.begin() + static_cast<std::ptrdiff_t>(n_) + 1);
        std::reverse(bound.begin(), bound.begin() + static_cast<std::ptrdiff_t>(n_) + 1);
        shift(value, n_, T(1));
        shift(bound, n_, T(1));
        return counted(value, bound);
    }

    /// The root between a and b, where there is one, up to what T can tell of it.
    double near_root(double a, double b) const
    {
        const bool rises = at(b).first > 0;
        double u = (a + b) / 2;
        for (int step = 0; step < 60; ++step) {
            const auto [value, slope] = at(u);
            if (value == 0) break;
            ((value > 0) == rises ? b : a) = u;
            double next = slope != 0 ? u - static_cast<double>(value / slope) : a;
            if (!(next > a && next < b) || step % 4 == 3) next = (a + b) / 2;
            if (next == u || next <= a || next >= b || std::abs(next - u) < 1e-14) break;
            u = next;
        }
        return u;
    }

private:
    /// A sign in doubt between two that differ changes nothing; any other doubt is one.
    Roots counted(const Coefficients<T>& value, const Coefficients<T>& bound) const
    {
        int changes = 0, last = 0;
        bool doubt = false;
        for (std::size_t k = 0; k <= n_; ++k) {
            const T size = value[k] < 0 ? -value[k] : value[k];
            if (!(size > slack_ * bound[k] + T(std::numeric_limits<double>::min()))) {
                if (doubt || k == 0 || k == n_) return Roots::Doubt;
                doubt = true;
                continue;
            }
            const int sign = value[k] > 0 ? 1 : -1;
            if (last != 0 && sign != last) ++changes;
            else if (doubt) return Roots::Doubt;
            doubt = false;
            last = sign;
        }
        return changes == 0 ? Roots::None : changes == 1 ? Roots::One : Roots::Several;
    }

    std::pair<T, T> at(T u) const
    {
        T value = 0, slope = 0;
        for (std::size_t k = n_ + 1; k-- > 0;) {
            slope = slope * u + value;
            value = value * u + c_[k];
        }
        return {value, slope};
    }

    std::size_t n_;
    Coefficients<T> c_{}, size_{};
    T slack_;
};

/// The one root of p between a and b, where p is `from` at a.
Quad newton_in(const QuadPolynomial& p, Quad a, Quad b, Quad t, Quad unit)
{
    // Newton doubles the digits: the step after one below 2^-70 of the unit would be below the last bit.
    constexpr Quad kSmallStep = 1.0 / 1073741824.0 / 1073741824.0 / 1024.0, kAside = kSmallStep / 16.0;
    for (int step = 0; step < 6; ++step) {
        Quad value = 0, slope = 0;
        for (std::size_t k = p.c.size(); k-- > 0;) {
            slope = slope * t + value;
            value = value * t + p.c[k];
        }
        if (slope == 0) break;
        const Quad next = t - value / slope;
        if (!(next > a && next < b)) break;
        const bool small = absolute(next - t) <= kSmallStep * unit;
        t = next;
        if (!small) continue;
        if ((p(t - kAside * unit) > 0) != (p(t + kAside * unit) > 0)) return t;
        break;
    }
    return halved_in(p, p.derivative(), a, b);
}

}  // namespace

std::optional<std::vector<Quad>> isolated_sign_changes(const QuadPolynomial& p, Quad low, Quad high)
{
    std::size_t degree = p.c.size() - 1;
    while (degree > 0 && p.c[degree] == 0) --degree;
    if (degree == 0) return std::vector<Quad>{};
    if (degree > kMostDegree || !(high > low)) return std::nullopt;
    // About the size of the solid: crossings lie within a few units of 0.
    const Quad unit = std::ldexp(1.0, std::ilogb(static_cast<double>(high - low)) - 5);
    const Isolation<double> quick(p, degree, unit);
    std::optional<Isolation<Quad>> wide;

    struct Piece {
        double a, b;
        int depth;
    };
    std::vector<Piece> open;  // the last is the leftmost
    double to = static_cast<double>(high / unit);
    const double start = static_cast<double>(low / unit);
    for (const double cut : {2.0, 0.0, -2.0})
        if (cut > start && cut < to) {
            open.push_back({cut, to, 0});
            to = cut;
        }
    open.push_back({start, to, 0});
    std::vector<Quad> roots;
    while (!open.empty()) {
        const Piece piece = open.back();
        open.pop_back();
        Roots held = quick.between(piece.a, piece.b);
        const bool wider = held == Roots::Doubt && piece.depth >= kWider;
        if (wider) {
            if (!wide) wide.emplace(p, degree, unit);
            held = wide->between(piece.a, piece.b);
        }
        if (held == Roots::None) continue;
        if (held == Roots::One) {
            const double near = wider ? wide->near_root(piece.a, piece.b) : quick.near_root(piece.a, piece.b);
            roots.push_back(newton_in(p, piece.a * unit, piece.b * unit, near * unit, unit));
            continue;
        }
        if (piece.depth == kDeepest) return std::nullopt;
        const double middle = piece.a + (piece.b - piece.a) / 2;
        open.push_back({middle, piece.b, piece.depth + 1});
        open.push_back({piece.a, middle, piece.depth + 1});
    }
    return roots;
}

}  // namespace numerics
