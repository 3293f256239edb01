#include "parser/grammar/statement.h"

#include <fmt/format.h>

/// Surfaces given by the coefficients of a polynomial (reference manual: poly, cubic, quartic, polynomial).
namespace parser {
namespace {

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
void cubic(StatementReader& s) { coefficients(s, 3); sturm(s); }
void quartic(StatementReader& s) { coefficients(s, 4); sturm(s); }

void polynomial(StatementReader& s)
{
    const int order = read_order(s);
    s.in().accept_comma();
    while (s.accept(Kind::Xyz)) {
        s.in().expect(Kind::LeftParen, "'(' and the powers of x, y and z");
        auto term = s.operands("fff");
        if (number_of(term[0]) + number_of(term[1]) + number_of(term[2]) > order) s.fail("the powers of this term are above the order");
        s.in().expect(Kind::RightParen, "')' after the powers");
        s.in().expect(Kind::Colon, "':' and the coefficient");
        term.emplace_back(float_expr(s.in()));
        s.add("xyz", std::move(term));
        s.in().accept_comma();
    }
    sturm(s);
}

}  // namespace

HeadReader polynomial_head(Kind keyword)
{
    switch (keyword) {
    case Kind::Poly: return poly;
    case Kind::Cubic: return cubic;
    case Kind::Quartic: return quartic;
    case Kind::Polynomial: return polynomial;
    default: return nullptr;
    }
}

}  // namespace parser
