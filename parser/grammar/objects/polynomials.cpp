#include "parser/grammar/core/solid_reader.h"

#include <fmt/format.h>

#include <cmath>

/// Surfaces given by the coefficients of a polynomial (reference manual: poly, cubic, quartic, polynomial).
namespace parser {
namespace {

using scene::PolynomialSurface;

std::vector<double> read_coefficients(SolidReader& s, int order)
{
    const int count = PolynomialSurface::count_of(order);
    s.in().expect(Kind::Less, "'<' and the coefficients");
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
        if (i > 0) s.in().accept_comma();
        values.push_back(number(s.in()));
    }
    s.in().expect(Kind::Greater, fmt::format("'>' after {} coefficients", count));
    return values;
}

int read_order(SolidReader& s)
{
    constexpr int kLeastOrder = 2, kMostOrder = 35;
    const double order = number(s.in());
    if (!(order >= kLeastOrder && order < kMostOrder + 1)) s.fail("the order must lie from 2 to 35");
    s.in().accept_comma();
    return static_cast<int>(order);
}

/// Place of a term in POV-Ray's order (spec 5a, 5.9).
std::size_t place(int degree, const std::array<int, 3>& powers)
{
    const int a = degree - powers[0], b = a - powers[1];
    return static_cast<std::size_t>(a * (a + 1) * (a + 2) / 6 + b * (b + 1) / 2 + (b - powers[2]));
}

void read_terms(SolidReader& s, PolynomialSurface& solid)
{
    solid.coefficients.resize(static_cast<std::size_t>(PolynomialSurface::count_of(solid.order)));
    while (s.in().accept(Kind::Xyz)) {
        s.in().expect(Kind::LeftParen, "'(' and the powers of x, y and z");
        glm::dvec3 powers;
        read_values(s.in(), powers.x, powers.y, powers.z);
        for (int k = 0; k < 3; ++k)
            if (powers[k] < 0.0) s.fail("the powers of a term must not be negative");
        if (powers.x + powers.y + powers.z > solid.order) s.fail("the powers of this term are above the order");
        s.in().expect(Kind::RightParen, "')' after the powers");
        s.in().expect(Kind::Colon, "':' and the coefficient");
        const PolynomialSurface::Term term{{whole_number(powers.x), whole_number(powers.y), whole_number(powers.z)},
                                           number(s.in())};
        solid.terms.push_back(term);
        solid.coefficients[place(solid.order, term.powers)] = term.coefficient;
        s.in().accept_comma();
    }
}

}  // namespace

Form parameters_form(const SolidReader*, const PolynomialSurface*, Kind keyword)
{
    using terms = pegtl::star<token<Kind::Xyz>, token<Kind::LeftParen>, a_number, opt_comma, a_number, opt_comma,
                              a_number, token<Kind::RightParen>, token<Kind::Colon>, a_number, opt_comma>;
    using coefficients = seq<token<Kind::Less>, pegtl::plus<a_number, opt_comma>, token<Kind::Greater>>;
    if (keyword == Kind::Polynomial) return form_of<seq<a_number, opt_comma, terms, sturms>>();
    return keyword == Kind::Poly ? form_of<seq<a_number, opt_comma, coefficients, sturms>>()
                                 : form_of<seq<coefficients, sturms>>();
}

bool read_parameters(SolidReader& s, PolynomialSurface& solid)
{
    if (s.keyword() == Kind::Cubic) solid.order = 3;
    else if (s.keyword() == Kind::Quartic) solid.order = 4;
    else solid.order = read_order(s);
    if (s.keyword() == Kind::Polynomial) read_terms(s, solid);
    else solid.coefficients = read_coefficients(s, solid.order);
    if (s.in().accept(Kind::Sturm)) optional_flag(s.in());
    for (const double v : solid.coefficients)
        if (!std::isfinite(v)) return false;
    // Of degree 2 as well: a quadric's extents would not be POV-Ray's, which are those of any polynomial.
    s.object().shape = scene::Polynomial{std::make_shared<csg::PolynomialShape>(solid.order, solid.coefficients)};
    return true;
}

}  // namespace parser
