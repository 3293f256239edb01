#include "parser/grammar/shape_makers.h"
#include "parser/grammar/statement.h"

#include <fmt/format.h>

#include <cmath>

/// Surfaces given by the coefficients of a polynomial (reference manual: poly, cubic, quartic, polynomial).
namespace parser {
namespace {

using scene::StatementItem;

void coefficients(StatementReader& s, int order)
{
    const int count = (order + 1) * (order + 2) * (order + 3) / 6;
    s.in().expect(Kind::Less, "'<' and the coefficients");
    std::vector<StatementReader::Operand> values;
    for (int i = 0; i < count; ++i) {
        if (i > 0) s.in().accept_comma();
        values.emplace_back(float_expr(s.in()));
    }
    s.in().expect(Kind::Greater, fmt::format("'>' after {} coefficients", count));
    s.add("coefficients", std::move(values));
}

int read_order(StatementReader& s)
{
    constexpr int kLeast = 2, kMost = 35;
    const double order = float_expr(s.in());
    if (!(order >= kLeast && order < kMost + 1)) s.fail("the order must lie from 2 to 35");
    s.add("order", {order});
    return static_cast<int>(order);
}

void sturm(StatementReader& s)
{
    static constexpr Form kForms[] = {{Kind::Sturm, "o"}};
    s.read_one(kForms);
}

void poly(StatementReader& s)
{
    const int order = read_order(s);
    s.in().accept_comma();
    coefficients(s, order);
    sturm(s);
}
void cubic_head(StatementReader& s) { coefficients(s, 3); sturm(s); }
void quartic(StatementReader& s) { coefficients(s, 4); sturm(s); }

void polynomial(StatementReader& s)
{
    const int order = read_order(s);
    s.in().accept_comma();
    while (s.accept(Kind::Xyz)) {
        s.in().expect(Kind::LeftParen, "'(' and the powers of x, y and z");
        auto term = s.operands("fff");
        for (const auto& power : term)
            if (number_of(power) < 0.0) s.fail("the powers of a term must not be negative");
        if (number_of(term[0]) + number_of(term[1]) + number_of(term[2]) > order) s.fail("the powers of this term are above the order");
        s.in().expect(Kind::RightParen, "')' after the powers");
        s.in().expect(Kind::Colon, "':' and the coefficient");
        term.emplace_back(float_expr(s.in()));
        s.add("xyz", std::move(term));
        s.in().accept_comma();
    }
    sturm(s);
}

/// Place of a term in POV-Ray's order (spec 5a, 5.9).
std::size_t place(int degree, int i, int j, int k)
{
    const int a = degree - i, b = a - j;
    return static_cast<std::size_t>(a * (a + 1) * (a + 2) / 6 + b * (b + 1) / 2 + (b - k));
}

int degree_of(const scene::Statement& statement)
{
    if (statement.keyword == "cubic") return 3;
    if (statement.keyword == "quartic") return 4;
    for (const StatementItem& item : statement.items)
        if (item.name == "order") return static_cast<int>(number_of(item.operands[0]));
    return 0;
}

std::vector<double> coefficients_of(const scene::Statement& statement, int degree)
{
    std::vector<double> all(static_cast<std::size_t>((degree + 1) * (degree + 2) * (degree + 3) / 6));
    for (const StatementItem& item : statement.items) {
        if (item.name == "coefficients") {
            for (std::size_t i = 0; i < all.size(); ++i) all[i] = number_of(item.operands[i]);
        } else if (item.name == "xyz") {
            const auto power = [&](std::size_t k) { return static_cast<int>(number_of(item.operands[k])); };
            const int i = power(0), j = power(1), k = power(2);
            all[place(degree, i, j, k)] = number_of(item.operands[3]);
        }
    }
    return all;
}

}  // namespace

HeadReader polynomial_head(Kind keyword)
{
    switch (keyword) {
    case Kind::Poly: return poly;
    case Kind::Cubic: return cubic_head;
    case Kind::Quartic: return quartic;
    case Kind::Polynomial: return polynomial;
    default: return nullptr;
    }
}

bool make_polynomial(SceneBuilder&, const scene::Statement& statement, scene::Object& object)
{
    const int degree = degree_of(statement);
    std::vector<double> c = coefficients_of(statement, degree);
    for (const double v : c)
        if (!std::isfinite(v)) return false;
    // Of degree 2 as well: a quadric's extents would not be POV-Ray's, which are those of any polynomial.
    object.shape = scene::Polynomial{std::make_shared<csg::PolynomialShape>(degree, std::move(c))};
    return true;
}

}  // namespace parser
