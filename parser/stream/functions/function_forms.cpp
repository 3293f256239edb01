#include "parser/stream/functions/function_body.h"

#include <cmath>

/// Forms of a function's expression that are more than an operator over their arguments.
namespace parser {

BodyReader::Value BodyReader::power(const Token& token, const std::vector<Value>& operands)
{
    if (operands.size() == 1) return operands[0];
    if (operands.size() != 2) stream_.fail(stream_.place(token), "pow takes 2 arguments");
    const Value e = operands[0];
    const double n = build_.is_constant(operands[1]) ? build_.number(operands[1]) : -1.0;
    const auto times = [&](Value a, Value b) { return build_.binary(Op::Multiply, a, b); };
    if (n == 0.0) {
        stream_.warn(stream_.place(token), "the power of zero is taken as 1");
        return build_.constant(1.0);
    }
    if (!(n >= 2.0 && n <= 8.0 && n == std::floor(n))) return build_.binary(Op::Power, e, operands[1]);
    const Value e2 = times(e, e);
    if (n == 2.0) return e2;
    if (n == 3.0) return times(e2, e);
    const Value e4 = times(e2, e2);
    if (n == 4.0) return e4;
    if (n == 5.0) return times(e4, e);
    if (n == 6.0) return times(e4, e2);
    return n == 7.0 ? times(times(e4, e), e2) : times(e4, e4);
}

BodyReader::Value BodyReader::select(const Token& token)
{
    stream_.expect(Kind::LeftParen, "'(' and the function's arguments");
    const Value condition = read();
    std::vector<Value> branches;
    while (branches.size() < 3 && (branches.size() < 2 || stream_.peek().kind == Kind::Comma)) {
        comma();
        build_.begin_branch(condition);
        branches.push_back(build_.end_branch(read()));
    }
    if (stream_.peek().kind == Kind::Comma) stream_.fail(stream_.place(token), "select takes 3 or 4 arguments");
    stream_.expect(Kind::RightParen, "')' after the function's arguments");
    return build_.select(condition, branches);
}

/// sum(i, from, to, body): i is a name of its own while the body is read, where it hides a parameter or an outer
/// counter.
BodyReader::Value BodyReader::loop(const Token& token)
{
    stream_.expect(Kind::LeftParen, "'(' and the counter's name");
    const Token name = stream_.next_name();
    if (name.kind != Kind::Identifier || stream_.value_of(name))
        stream_.fail(stream_.place(name), "expected a new name for the counter");
    const std::string word = stream_.word(name);
    comma();
    const Value from = read();
    comma();
    const Value to = read();
    comma();
    const Value counter = build_.begin_loop(from, to);
    const auto outer = names_;
    names_[word] = counter;
    const Value value = build_.end_loop(counter, read(), token.kind == Kind::Prod);
    names_ = outer;
    stream_.expect(Kind::RightParen, "')' after the function's arguments");
    return value;
}

}  // namespace parser
