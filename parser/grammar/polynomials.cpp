#include "parser/grammar/statement.h"

#include <cmath>

/// Solids of the statements poly, cubic, quartic and polynomial (reference manual: poly).
namespace parser {
namespace {

using scene::StatementItem;

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
            if (i >= 0 && j >= 0 && k >= 0 && i + j + k <= degree) all[place(degree, i, j, k)] = number_of(item.operands[3]);
        }
    }
    return all;
}

}  // namespace

bool draw_polynomial(const scene::Statement& statement, scene::Object& object)
{
    const std::string& keyword = statement.keyword;
    if (keyword != "poly" && keyword != "cubic" && keyword != "quartic" && keyword != "polynomial") return false;
    const int degree = degree_of(statement);
    std::vector<double> c = coefficients_of(statement, degree);
    for (const double v : c)
        if (!std::isfinite(v)) return false;
    // Of degree 2 as well: a quadric's extents would not be POV-Ray's, which are those of any polynomial.
    object.shape = scene::Polynomial{std::make_shared<csg::PolynomialShape>(degree, std::move(c))};
    return true;
}

}  // namespace parser
