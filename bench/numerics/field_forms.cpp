#include "bench/numerics/forms.h"
#include "csg/freeform/freeform.h"

#include <cmath>

// Solids that a function of space decides.
namespace numerics {
namespace {

using csg::Transform;

template <class Shape, class... Args>
std::function<csg::Solid(const Transform&, double)> freeform(Args&&... args)
{
    const auto shape = csg::make_freeform<Shape>(std::forward<Args>(args)...);
    return [shape](const Transform& frame, double) { return csg::Solid(csg::Freeform{shape, frame}); };
}

Form superellipsoid_form(const std::string& name, double e, double n)
{
    const auto holds = [e, n](const WidePoint& p) {
        const Wide across = 2 / static_cast<Wide>(e), along = 2 / static_cast<Wide>(n);
        const Wide flat =
            std::pow(std::pow(std::abs(p.x), across) + std::pow(std::abs(p.y), across), static_cast<Wide>(e) / n);
        return flat + std::pow(std::abs(p.z), along) <= 1;
    };
    // Within the cube of 1 the point's rounding of 2^-53 moves a power of 0.8 or more, and their sum's power of 0.57 or
    // more of a number that is itself such a power, by at most 1e-12 (at 0; 1e-15 elsewhere), pow() itself by 1e-15.
    constexpr double kDoubt = 1e-10;
    return {.name = name,
            .make = freeform<csg::Superellipsoid>(e, n),
            .holds = holds,
            .quick = [e, n, holds](const WidePoint& p) {
                const double x = std::abs(static_cast<double>(p.x)), y = std::abs(static_cast<double>(p.y)),
                             z = std::abs(static_cast<double>(p.z));
                if (glm::max(x, glm::max(y, z)) > 1.0 + kDoubt) return false;
                const double past = std::pow(std::pow(x, 2 / e) + std::pow(y, 2 / e), e / n) + std::pow(z, 2 / n) - 1.0;
                return std::abs(past) > kDoubt ? past < 0.0 : holds(p);
            }};
}

Form blob_form()
{
    using Component = csg::Blob::Component;
    const auto ball = [](const glm::dvec3& center, double radius, double strength) {
        return Component{
            .frame = Transform::translate(center), .length = 0.0, .radius = radius, .strength = strength, .part = 0};
    };
    const std::vector<Component> all{
        ball({-0.5, 0, 0}, 1.1, 1.0),
        ball({0.6, 0.3, -0.1}, 0.9, 1.2),
        ball({0.1, 0.9, 0.3}, 0.7, -0.6),
        {Transform::translate({0, -0.8, -0.4}) * Transform::rotate_degrees({30, 50, 0}), 0.9, 0.5, 1.5, 0}};
    return {.name = "blob",
            .make = freeform<csg::Blob>(0.4, all),
            .holds =
                [all](const WidePoint& p) {
                    Wide sum = -static_cast<Wide>(0.4);
                    for (const Component& c : all) {
                        const WidePoint o{p.x - c.frame.offset.x, p.y - c.frame.offset.y, p.z - c.frame.offset.z};
                        const auto row = [&](int i) {
                            return c.frame.inverse_linear[0][i] * o.x + c.frame.inverse_linear[1][i] * o.y +
                                   c.frame.inverse_linear[2][i] * o.z;
                        };
                        const Wide x = row(0), y = row(1), z = row(2),
                                   up = z - std::min(std::max(z, Wide(0)), static_cast<Wide>(c.length));
                        const Wide q = (x * x + y * y + up * up) / (static_cast<Wide>(c.radius) * c.radius);
                        if (q < 1) sum += c.strength * (1 - q) * (1 - q);
                    }
                    return sum >= 0;
                },
            .blur = 2e-6};  // POV-Ray's inside reaches 1e-6 of the field below its threshold (spec 5a, 2.4), which
                            // rises by 0.5 a length or more
}

/// x^2 + y^2 + z^2 + 0.5 x y - 1 with its ranges by the rules of intervals.
class Saddle final : public csg::Field {
public:
    double value(const glm::dvec3& p) const override
    {
        return p.x * p.x + p.y * p.y + p.z * p.z + 0.5 * p.x * p.y - 1.0;
    }
    void values(const csg::EightPoints& p, csg::Eight& out) const override
    {
        for (int k = 0; k < 8; ++k) out.v[k] = value({p.x.v[k], p.y.v[k], p.z.v[k]});
    }
    void ranges(const csg::EightBoxes& b, csg::EightRanges& out) const override
    {
        for (int k = 0; k < 8; ++k) {
            double low = -1.0 - 1e-14, high = -1.0 + 1e-14;
            const auto add = [&](const csg::EightRanges& s, const csg::EightRanges& t, double factor, bool square) {
                const double all[4] = {s.low.v[k] * t.low.v[k], s.low.v[k] * t.high.v[k], s.high.v[k] * t.low.v[k],
                                       s.high.v[k] * t.high.v[k]};
                const double least = *std::min_element(all, all + 4);
                low += factor * (square ? std::max(least, 0.0) : least);
                high += factor * *std::max_element(all, all + 4);
            };
            for (const csg::EightRanges* side : {&b.x, &b.y, &b.z}) add(*side, *side, 1.0, true);
            add(b.x, b.y, 0.5, false);
            out.low.v[k] = low;
            out.high.v[k] = high;
        }
    }
    bool ranged() const override { return true; }
};

constexpr double kAccuracy = 1e-7, kParts = 1e-4;

Form isosurface_form()
{
    // Told up to the accuracy too far, as POV-Ray does: a setting of the scene, here in parts of the object's size.
    return {.name = "isosurface",
            .make =
                [](const Transform& frame, double scale) {
                    csg::IsosurfaceTerms terms;
                    terms.field = std::make_shared<Saddle>();
                    terms.accuracy = kAccuracy * glm::min(scale, 1.0);
                    terms.max_gradient = 5.0;
                    terms.max_trace = 10;
                    terms.container = csg::Container::box(glm::dvec3(-1.6), glm::dvec3(1.6));
                    return csg::Solid(csg::Freeform{csg::make_freeform<csg::Isosurface>(terms), frame});
                },
            .holds = [](const WidePoint& p) { return p.x * p.x + p.y * p.y + p.z * p.z + p.x * p.y / 2 <= 1; },
            .bar = kAccuracy,
            .band = 10.0 * kAccuracy};
}

Form parametric_form()
{
    const auto plain = [](double (*f)(double, double)) {
        struct Plain final : csg::Field {
            explicit Plain(double (*of)(double, double)) : g(of) {}
            double value(const glm::dvec3& p) const override { return g(p.x, p.y); }
            void values(const csg::EightPoints& p, csg::Eight& out) const override
            {
                for (int k = 0; k < 8; ++k) out.v[k] = g(p.x.v[k], p.y.v[k]);
            }
            void ranges(const csg::EightBoxes&, csg::EightRanges& out) const override
            {
                for (int k = 0; k < 8; ++k) out.low.v[k] = -numbers::kInfinity, out.high.v[k] = numbers::kInfinity;
            }
            bool ranged() const override { return false; }
            double (*g)(double, double);
        };
        return std::make_shared<Plain>(f);
    };
    csg::ParametricTerms terms;
    terms.field = {plain([](double u, double v) { return std::sin(u) * std::cos(v); }),
                   plain([](double u, double v) { return std::sin(u) * std::sin(v); }),
                   plain([](double u, double) { return std::cos(u); })};
    terms.upper = {2.0 * 3.14159265358979, 3.14159265358979};
    terms.max_gradient = 1.5;
    terms.container = csg::Container::sphere(glm::dvec3(0.0), 1.2);
    // The accuracy is a length of the world too: a setting of the scene, as the isosurface's.
    const auto make = [terms](const Transform& frame, double scale) mutable {
        terms.accuracy = kParts * glm::min(scale, 1.0);
        csg::Parametric surface(terms);
        surface.prepare();
        return csg::Solid(csg::Freeform{csg::make_freeform<csg::Parametric>(surface), frame});
    };
    return {.name = "parametric",
            .make = make,
            .meets = [](const WidePoint& from, const WidePoint& way) -> std::vector<Wide> {
                const Wide a = way.x * way.x + way.y * way.y + way.z * way.z,
                           b = from.x * way.x + from.y * way.y + from.z * way.z;
                const Wide room = b * b - a * (from.x * from.x + from.y * from.y + from.z * from.z - 1);
                if (room <= 0) return {};
                return {(-b - std::sqrt(room)) / a, (-b + std::sqrt(room)) / a};
            },
            .slope = [](const WidePoint& p) { return p; },
            // A hit is told where the ray enters what z spans in a part (spec 5b, 14.2); the parts are as large as the
            // accuracy, and the ray comes as near to the surface.
            .spread =
                [](const glm::dvec3& way, const glm::dvec3& normal) {
                    return 1.0 / glm::min(std::abs(way.z), std::abs(glm::dot(way, normal)));
                },
            .bar = 1e-3,
            .band = 0.1,
            .first_only = true};
}

Form julia_form()
{
    csg::JuliaTerms terms;
    terms.constant = {-0.2, 0.6, 0.2, 0.2};
    terms.iterations = 5;
    terms.precision = 100.0;
    // The orbit begins at p; asked before each of its five maps is made (spec 5b, 12.2).
    const Wide size = std::sqrt(0.48L), reach = 1 + size + 1e-7L, escape = reach * reach + 1e-7L;
    const auto last = [escape](const WidePoint& p, bool all) {
        Wide x = p.x, y = p.y, z = p.z, w = 0, square = 0;
        for (int k = 0;; ++k) {
            square = x * x + y * y + z * z + w * w;
            if (k == 4 || (!all && square > escape)) return square;
            const Wide real = x * x - y * y - z * z - w * w;
            y = 2 * x * y + 0.6L, z = 2 * x * z + 0.2L, w = 2 * x * w + 0.2L, x = real - 0.2L;
        }
    };
    return {.name = "julia",
            .make = freeform<csg::Julia>(terms),
            .holds = [last, escape](const WidePoint& p) { return last(p, false) <= escape; },
            // It is lit by the slope after a map more.
            .slope = [last](const WidePoint& p) -> WidePoint {
                const Wide h = 1e-6L;
                return {last({p.x + h, p.y, p.z}, true) - last({p.x - h, p.y, p.z}, true),
                        last({p.x, p.y + h, p.z}, true) - last({p.x, p.y - h, p.z}, true),
                        last({p.x, p.y, p.z + h}, true) - last({p.x, p.y, p.z - h}, true)};
            },
            // What is thinner than ten of its steps, 1 / precision, may be stepped over: they follow POV-Ray's estimate
            // of the distance.
            .bar = 1e-7,
            .band = 0.1};
}

Form height_field_form()
{
    constexpr std::uint32_t kPoints = 9;
    csg::HeightField::Grid grid;
    grid.columns = grid.rows = kPoints;
    for (std::uint32_t k = 0; k < kPoints; ++k)
        for (std::uint32_t i = 0; i < kPoints; ++i)
            grid.levels.push_back(
                static_cast<std::uint16_t>(20000.0 + 15000.0 * std::sin(1.7 * i) * std::cos(2.3 * k)));
    const auto levels = grid.levels;
    const auto shape = csg::make_freeform<csg::HeightField>(grid);
    return {.name = "height_field",
            .make =
                [shape](const Transform& frame, double) {
                    return csg::Solid(csg::Freeform{shape, frame * Transform::translate({-0.5, -0.25, -0.5})});
                },
            .holds =
                [levels](const WidePoint& p) {
                    if (!(p.x > 0 && p.x < 1 && p.z > 0 && p.z < 1)) return false;
                    const Wide x = p.x * (kPoints - 1), z = p.z * (kPoints - 1);
                    const auto i = static_cast<std::size_t>(x), k = static_cast<std::size_t>(z);
                    const Wide u = x - static_cast<Wide>(i), v = z - static_cast<Wide>(k);
                    const auto level = [&](std::size_t right, std::size_t behind) {
                        return static_cast<Wide>(levels[(k + behind) * kPoints + i + right]);
                    };
                    // Two triangles a cell, parted from (1, 0) to (0, 1).
                    const Wide h = u + v <= 1
                                       ? level(0, 0) + u * (level(1, 0) - level(0, 0)) + v * (level(0, 1) - level(0, 0))
                                       : level(1, 1) + (1 - u) * (level(0, 1) - level(1, 1)) +
                                             (1 - v) * (level(1, 0) - level(1, 1));
                    return p.y * 65536 < h;
                },
            .reach = 1.5};
}

}  // namespace

std::vector<Form> field_forms()
{
    return {superellipsoid_form("superellipsoid", 0.4, 0.7),
            superellipsoid_form("superellipsoid_star", 2.5, 1.6),
            blob_form(),
            isosurface_form(),
            parametric_form(),
            julia_form(),
            height_field_form()};
}

}  // namespace numerics
