#include "bench/numerics/forms.h"
#include "csg/freeform/freeform.h"

#include <cmath>

// Solids made of outlines: a point is inside where a line from it crosses the outline an odd number of times.
namespace numerics {
namespace {

using csg::OutlinePiece;
using csg::Transform;
using Outline = std::vector<OutlinePiece>;

struct WideCubic {
    Wide a, b, c, d;
    Wide operator()(Wide w) const { return ((a * w + b) * w + c) * w + d; }
};

/// The ends of a cubic's stretches without a turn in [0, 1], ascending.
struct Stretches {
    Wide ends[4] = {0, 1, 1, 1};
    int count = 1;

    explicit Stretches(const WideCubic& p)
    {
        const Wide a = 3 * p.a, b = 2 * p.b, room = b * b - 4 * a * p.c;
        Wide turns[2] = {-1, -1};
        if (a == 0) turns[0] = b != 0 ? -p.c / b : -1;
        else if (room > 0) {
            const Wide q = -(b + std::copysign(std::sqrt(room), b)) / 2;
            turns[0] = std::min(q / a, q != 0 ? p.c / q : Wide(-1));
            turns[1] = std::max(q / a, q != 0 ? p.c / q : Wide(-1));
        }
        for (const Wide t : turns)
            if (t > 0 && t < 1) ends[count++] = t;
        ends[count] = 1;
    }
};

/// f(w) for each w in [0, 1] where the cubic changes sign: between its turns.
template <class F>
void each_change(const WideCubic& p, F&& f)
{
    const Stretches s(p);
    for (int i = 0; i < s.count; ++i) {
        Wide lo = s.ends[i], hi = s.ends[i + 1];
        const bool rises = p(hi) > 0;
        if ((p(lo) > 0) == rises) continue;
        for (int k = 0; k < 66; ++k) ((p((lo + hi) / 2) > 0) == rises ? hi : lo) = (lo + hi) / 2;
        f((lo + hi) / 2);
    }
}

/// Whether the outline passes a line from (x, y) towards +x an odd number of times.
bool odd(const Outline& outline, Wide x, Wide y)
{
    bool is = false;
    for (const OutlinePiece& p : outline) {
        const WideCubic across{p.a.x, p.b.x, p.c.x, p.d.x};
        each_change({p.a.y, p.b.y, p.c.y, p.d.y - y}, [&](Wide w) { is ^= across(w) > x; });
    }
    return is;
}

/// The same answers as `odd`, from what a piece's box already tells and halving only until the side is certain.
class QuickOutline {
public:
    explicit QuickOutline(const Outline& outline)
    {
        for (const OutlinePiece& p : outline) pieces_.emplace_back(p);
    }

    bool odd(Wide x, Wide y) const
    {
        const auto near_x = static_cast<double>(x), near_y = static_cast<double>(y);
        bool is = false;
        for (const Piece& p : pieces_) {
            if (near_y < p.low_y || near_y > p.high_y || near_x > p.high_x) continue;
            if (near_x < p.low_x) is ^= (p.y.d - y > 0) != (p.y.a + p.y.b + p.y.c + (p.y.d - y) > 0);
            else is ^= p.odd(x, y);
        }
        return is;
    }

private:
    /// Far above the roundings of doubles and of `Wide` for outlines of size 1.
    static constexpr double kMargin = 1e-12;

    struct Piece {
        WideCubic x, y;
        Stretches stretches;
        Wide steepest;                        ///< |dx/dw| is nowhere more
        double low_x, high_x, low_y, high_y;  ///< holds the piece, with the margin

        explicit Piece(const OutlinePiece& p)
            : x{p.a.x, p.b.x, p.c.x, p.d.x}, y{p.a.y, p.b.y, p.c.y, p.d.y}, stretches(y),
              steepest(3 * std::abs(x.a) + 2 * std::abs(x.b) + std::abs(x.c))
        {
            const auto range = [](const WideCubic& c, double& low, double& high) {
                const Stretches s(c);
                Wide least = c(0), most = c(0);
                for (int i = 1; i <= s.count; ++i)
                    least = std::min(least, c(s.ends[i])), most = std::max(most, c(s.ends[i]));
                low = static_cast<double>(least) - kMargin;
                high = static_cast<double>(most) + kMargin;
            };
            range(x, low_x, high_x);
            range(y, low_y, high_y);
        }

        bool odd(Wide at_x, Wide at_y) const
        {
            const WideCubic level{y.a, y.b, y.c, y.d - at_y};
            bool is = false;
            for (int i = 0; i < stretches.count; ++i) {
                const bool rises = level(stretches.ends[i + 1]) > 0;
                if ((level(stretches.ends[i]) > 0) != rises)
                    is ^= beyond(level, rises, at_x, stretches.ends[i], stretches.ends[i + 1]);
            }
            return is;
        }

        /// Whether the change of `level` between lo and hi lies at more than at_x.
        bool beyond(const WideCubic& level, bool rises, Wide at_x, Wide lo, Wide hi) const
        {
            for (int k = 0; k < 66; ++k) {
                const Wide middle = (lo + hi) / 2, gap = x(middle) - at_x;
                if (std::abs(gap) > steepest * (hi - lo) / 2 + kMargin) return gap > 0;
                ((level(middle) > 0) == rises ? hi : lo) = middle;
            }
            return x((lo + hi) / 2) > at_x;
        }
    };
    std::vector<Piece> pieces_;
};

Outline spline(const std::vector<glm::dvec2>& points)
{
    Outline curve;
    for (std::size_t i = 0; i + 3 < points.size(); ++i) {
        const glm::dvec2 &p0 = points[i], &p1 = points[i + 1], &p2 = points[i + 2], &p3 = points[i + 3];
        curve.push_back({-0.5 * p0 + 1.5 * p1 - 1.5 * p2 + 0.5 * p3, p0 - 2.5 * p1 + 2.0 * p2 - 0.5 * p3,
                         0.5 * (p2 - p0), p1, p1, p2});
    }
    return curve;
}

Wide rho(const WidePoint& p) { return std::sqrt(p.x * p.x + p.z * p.z); }

Form extrusion(const std::string& name, const Outline& outline)
{
    const auto shape = std::make_shared<csg::OutlineShape>(outline);
    return {.name = name,
            .make =
                [shape](const Transform& frame, double) {
                    return csg::Solid(csg::Extrusion{shape, -0.5, 0.5, false, false, frame});
                },
            .holds = [outline](const WidePoint& p) { return p.z >= -0.5 && p.z <= 0.5 && odd(outline, p.x, p.y); },
            .quick = [quick = QuickOutline(outline)](
                         const WidePoint& p) { return p.z >= -0.5 && p.z <= 0.5 && quick.odd(p.x, p.y); }};
}

const std::vector<glm::dvec2> kRing{{1, 0},    {0.3, 0.9}, {-0.8, 0.7}, {-0.6, -0.6}, {0.2, -0.3},
                                    {0.4, -1}, {1, 0},     {0.3, 0.9},  {-0.8, 0.7}};

Form prism_form() { return extrusion("prism", spline(kRing)); }

/// Bowls of quadratic curves and straight lines, as a font has them.
Form text_form()
{
    Outline letter;
    const auto loop = [&](const std::vector<glm::dvec2>& corners) {
        for (std::size_t i = 0; i < corners.size(); i += 2) {
            const glm::dvec2 &a = corners[i], &b = corners[i + 1], &c = corners[(i + 2) % corners.size()];
            letter.push_back(2.0 * b == a + c ? OutlinePiece::line(a, c) : OutlinePiece::quadratic(a, b, c));
        }
    };
    loop({{-1, -1},
          {-0.4, -1},
          {0.2, -1},
          {1, -0.9},
          {0.8, -0.2},
          {0.7, 0},
          {0.3, 0.1},
          {0.9, 0.2},
          {0.7, 0.8},
          {0.4, 1},
          {-0.3, 1},
          {-0.65, 1},
          {-1, 1},
          {-1, 0}});
    loop({{-0.5, -0.6}, {-0.5, -0.3}, {-0.5, 0}, {0.4, 0.1}, {0.3, -0.4}, {0.2, -0.6}});
    return extrusion("text", letter);
}

Form conic_prism_form()
{
    const Outline outline = spline(kRing);
    constexpr glm::dvec2 kReach[2] = {glm::dvec2(-1.0), glm::dvec2(1.0)};
    const auto shape =
        csg::make_freeform<csg::ConicPrism>(std::make_shared<csg::OutlineShape>(outline), 0.2, 1.0, false, kReach);
    return {.name = "conic_prism",
            .make =
                [shape](const Transform& frame, double) {
                    return csg::Solid(csg::Freeform{shape, frame * Transform::translate({0, -0.6, 0})});
                },
            .holds = [outline](
                         const WidePoint& p) { return p.y >= 0.2 && p.y <= 1.0 && odd(outline, p.x / p.y, p.z / p.y); },
            .quick = [quick = QuickOutline(outline)](
                         const WidePoint& p) { return p.y >= 0.2 && p.y <= 1.0 && quick.odd(p.x / p.y, p.z / p.y); }};
}

Form lathe_form()
{
    const Outline vase = spline({{0, -1.3}, {0, -1}, {1, -0.8}, {0.3, -0.1}, {0.9, 0.6}, {0, 1}, {-1, 1}});
    const auto shape = csg::make_freeform<csg::Lathe>(vase, csg::Aabb{}, 0.0);
    return {.name = "lathe",
            .make =
                [shape](const Transform& frame, double) {
                    return csg::Solid(csg::Freeform{shape, frame});
                },
            .holds = [vase](const WidePoint& p) { return odd(vase, rho(p), p.y); },
            .quick = [quick = QuickOutline(vase)](const WidePoint& p) { return quick.odd(rho(p), p.y); }};
}

Form sor_form()
{
    const std::vector<glm::dvec2> points{{0.5, -1.3}, {0.6, -1}, {1, -0.5}, {0.3, 0.2}, {0.7, 0.9}, {0.5, 1.1}};
    const auto shape = csg::make_freeform<csg::Sor>(points, false);
    return {.name = "sor",
            .make =
                [shape](const Transform& frame, double) {
                    return csg::Solid(csg::Freeform{shape, frame});
                },
            .holds =
                [points](const WidePoint& p) {
                    for (std::size_t i = 1; i + 2 < points.size(); ++i) {
                        const glm::dvec2 &b = points[i - 1], &l = points[i], &h = points[i + 1], &n = points[i + 2];
                        if (!(p.y >= l.y && p.y <= h.y)) continue;
                        // Hermite's cubic of the squared radius; slopes from the neighbours (spec 5b, 8).
                        const Wide height = static_cast<Wide>(h.y) - l.y, w = (p.y - l.y) / height;
                        const Wide low = static_cast<Wide>(l.x) * l.x, high = static_cast<Wide>(h.x) * h.x;
                        const Wide up = height * 2 * l.x * (static_cast<Wide>(h.x) - b.x) /
                                        (static_cast<Wide>(h.y) - b.y);
                        const Wide down = height * 2 * h.x * (static_cast<Wide>(n.x) - l.x) /
                                          (static_cast<Wide>(n.y) - l.y);
                        const Wide square = low * (1 + 2 * w) * (1 - w) * (1 - w) + up * w * (1 - w) * (1 - w) +
                                            high * w * w * (3 - 2 * w) - down * w * w * (1 - w);
                        return p.x * p.x + p.z * p.z <= square;
                    }
                    return false;
                }};
}

Form ovus_form()
{
    const auto shape = csg::make_freeform<csg::Ovus>(1.0, 0.5);
    return {.name = "ovus",
            .make =
                [shape](const Transform& frame, double) {
                    return csg::Solid(csg::Freeform{shape, frame});
                },
            .holds =
                [](const WidePoint& p) {
                    // Spec 5a, 5.12, for radii of 1 and 0.5.
                    const Wide around = p.x * p.x + p.z * p.z, arc = 2, height = -0.125L,
                               offset = std::sqrt(1 - height * height);
                    if (around + p.y * p.y < 1 || around + (p.y - 1) * (p.y - 1) < 0.25L) return true;
                    const Wide r = std::sqrt(around) + offset;
                    return p.y > 0.125L && p.y < 1.375L && r * r + (p.y - height) * (p.y - height) < arc * arc;
                }};
}

}  // namespace

std::vector<Form> outline_forms()
{
    return {prism_form(), text_form(), conic_prism_form(), lathe_form(), sor_form(), ovus_form()};
}

}  // namespace numerics
