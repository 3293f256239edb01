#include "parser/stream/expression.h"
#include "parser/stream/function.h"

#include <fmt/format.h>

#include <map>
#include <utility>

namespace parser {
namespace {

using Op = Function::Op;

/// Reads a body into nodes. Precedence, loosest first: `|`, `&`, relations, `+ -`, `* /`, one sign.
class BodyReader {
public:
    BodyReader(TokenStream& stream, Function& function, const std::map<std::string, std::uint32_t>& parameters)
        : stream_(stream), function_(function), parameters_(parameters) {}

    std::uint32_t read(int level = 0)
    {
        const auto guard = stream_.nest();
        if (level == kLevels) return signed_operand();
        std::uint32_t left = read(level + 1);
        for (Op op = operation(stream_.peek().kind, level); op != Op::Constant; op = operation(stream_.peek().kind, level)) {
            stream_.next();
            const std::uint32_t right = read(level + 1);
            left = add(op, {left, right});
        }
        return left;
    }

private:
    static constexpr int kLevels = 5;

    static Op operation(Kind kind, int level)
    {
        switch (kind) {
        case Kind::Bar: return level == 0 ? Op::Or : Op::Constant;
        case Kind::Ampersand: return level == 1 ? Op::And : Op::Constant;
        case Kind::Less: return level == 2 ? Op::Less : Op::Constant;
        case Kind::Greater: return level == 2 ? Op::Greater : Op::Constant;
        case Kind::LessEqual: return level == 2 ? Op::LessEqual : Op::Constant;
        case Kind::GreaterEqual: return level == 2 ? Op::GreaterEqual : Op::Constant;
        case Kind::Equal: return level == 2 ? Op::Equal : Op::Constant;
        case Kind::NotEqual: return level == 2 ? Op::NotEqual : Op::Constant;
        case Kind::Plus: return level == 3 ? Op::Add : Op::Constant;
        case Kind::Minus: return level == 3 ? Op::Subtract : Op::Constant;
        case Kind::Star: return level == 4 ? Op::Multiply : Op::Constant;
        case Kind::Slash: return level == 4 ? Op::Divide : Op::Constant;
        default: return Op::Constant;
        }
    }

    std::uint32_t add(Op op, std::vector<std::uint32_t> operands, double number = 0)
    {
        Function::Node node;
        node.op = op;
        node.operands = std::move(operands);
        node.number = number;
        function_.nodes.push_back(std::move(node));
        return static_cast<std::uint32_t>(function_.nodes.size() - 1);
    }

    void block(std::string why)
    {
        if (function_.unavailable.empty()) function_.unavailable = std::move(why);
    }

    std::uint32_t signed_operand()
    {
        if (stream_.accept(Kind::Plus)) return operand();
        if (stream_.accept(Kind::Minus)) return add(Op::Negate, {operand()});
        return operand();
    }

    std::uint32_t operand()
    {
        const Token token = stream_.peek();
        if (token.kind == Kind::Number) return stream_.next(), add(Op::Constant, {}, token.number);
        if (stream_.accept(Kind::LeftParen)) {
            const std::uint32_t inner = read();
            stream_.expect(Kind::RightParen, "')'");
            return inner;
        }
        if (token.kind == Kind::Identifier || is_keyword(token.kind)) {
            const auto parameter = parameters_.find(stream_.word(token));
            if (parameter != parameters_.end()) return stream_.next(), add(Op::Parameter, {parameter->second});
        }
        switch (token.kind) {
        case Kind::X: case Kind::U: stream_.next(); return add(Op::Parameter, {0});
        case Kind::Y: case Kind::V: stream_.next(); return add(Op::Parameter, {1});
        case Kind::Z: stream_.next(); return add(Op::Parameter, {2});
        case Kind::Pi: case Kind::Clock: return add(Op::Constant, {}, number_here());
        case Kind::Identifier: return identifier(token);
        default: break;
        }
        if (lexical_class(token.kind) == LexicalClass::Float) return built_in(token);
        stream_.fail_expected("a number, a parameter or a function");
    }

    /// A constant or float identifier alone: taken by value now.
    double number_here()
    {
        const Token token = stream_.next();
        return token.kind == Kind::Pi ? 3.14159265358979323846
                                      : static_cast<double>(static_cast<float>(stream_.options().clock));
    }

    std::uint32_t identifier(const Token& token)
    {
        stream_.next();
        Cell cell = stream_.symbols().find_cell(token.name);
        if (!cell) stream_.fail_undeclared(token);
        if (cell->get_if<std::shared_ptr<Array>>()) cell = stream_.subscripted(cell, token, false);
        if (const Tuple* tuple = cell->get_if<Tuple>(); tuple && tuple->count == 1)
            return add(Op::Constant, {}, tuple->at[0]);
        const auto* function = cell->get_if<std::shared_ptr<const Function>>();
        if (!function) stream_.fail(stream_.place(token), fmt::format("'{}' is no number and no function", stream_.word(token)));
        const std::shared_ptr<const Function> user = *function;
        if (!user->unavailable.empty()) block(user->unavailable);
        auto operands = arguments();
        if (user->unavailable.empty() && operands.size() != user->registers.size())
            stream_.fail(stream_.place(token), fmt::format("function {} takes {} arguments", stream_.word(token), user->registers.size()));
        if (stream_.accept(Kind::Period)) stream_.next();  // a component of a vector function: those are unavailable
        const std::uint32_t at = add(Op::User, std::move(operands));
        function_.nodes[at].user = user;
        return at;
    }

    std::uint32_t built_in(const Token& token)
    {
        stream_.next();
        if (token.kind == Kind::Sum || token.kind == Kind::Prod)
            stream_.fail(stream_.place(token), "sum and prod are not available yet");
        auto operands = arguments();
        const std::size_t needed = arity(token.kind);
        const bool some = token.kind == Kind::Min || token.kind == Kind::Max;
        const bool select = token.kind == Kind::Select && operands.size() == 4;
        if (needed == 0 || (some ? operands.size() < 2 : operands.size() != needed && !select))
            stream_.fail(stream_.place(token), fmt::format("{} cannot stand here like this", spelling(token.kind)));
        const std::uint32_t at = add(Op::Call, std::move(operands));
        function_.nodes[at].function = token.kind;
        return at;
    }

    static std::size_t arity(Kind kind)
    {
        switch (kind) {
        case Kind::Atan2: case Kind::Div: case Kind::Mod: case Kind::Pow: case Kind::Min: case Kind::Max: return 2;
        case Kind::Select: return 3;
        case Kind::Abs: case Kind::Acos: case Kind::Acosh: case Kind::Asin: case Kind::Asinh: case Kind::Atan:
        case Kind::Atanh: case Kind::Ceil: case Kind::Cos: case Kind::Cosh: case Kind::Degrees: case Kind::Exp:
        case Kind::Floor: case Kind::Int: case Kind::Ln: case Kind::Log: case Kind::Radians: case Kind::Sin: case Kind::Sinh:
        case Kind::Sqrt: case Kind::Tan: case Kind::Tanh: return 1;
        default: return 0;
        }
    }

    std::vector<std::uint32_t> arguments()
    {
        std::vector<std::uint32_t> operands;
        stream_.expect(Kind::LeftParen, "'(' and the function's arguments");
        do operands.push_back(read());
        while (stream_.accept_comma());
        stream_.expect(Kind::RightParen, "')' after the function's arguments");
        return operands;
    }

    TokenStream& stream_;
    Function& function_;
    const std::map<std::string, std::uint32_t>& parameters_;
};

bool is_special(Kind kind)
{
    return kind == Kind::Pigment || kind == Kind::Transform || kind == Kind::Spline || kind == Kind::Pattern ||
           kind == Kind::Internal;
}

/// Takes everything up to the brace that closes the one already taken, which it leaves.
void pass_body(TokenStream& stream)
{
    for (int depth = 0;;) {
        const Kind kind = stream.peek().kind;
        if (kind == Kind::EndOfText) stream.fail_expected("'}' at the end of the function");
        if (kind == Kind::RightBrace && depth-- == 0) return;
        depth += kind == Kind::LeftBrace;
        stream.next();
    }
}

}  // namespace

std::shared_ptr<const Function> read_function_value(TokenStream& stream)
{
    stream.next();
    const bool raw = stream.raw_operators();
    stream.set_raw_operators(false);
    auto function = std::make_shared<Function>();
    std::map<std::string, std::uint32_t> parameters;
    if (stream.accept(Kind::LeftParen)) {
        do {
            const Token name = stream.next();
            std::uint32_t at = 0;
            switch (name.kind) {
            case Kind::X: case Kind::U: at = 0; break;
            case Kind::Y: case Kind::V: at = 1; break;
            case Kind::Z: at = 2; break;
            case Kind::Identifier: at = function->register_count++; break;
            default: stream.fail(stream.place(name), "expected a parameter's name");
            }
            parameters[stream.word(name)] = at;
            function->registers.push_back(at);
            stream.accept_comma();
        } while (stream.peek().kind != Kind::RightParen);
        stream.next();
    } else {
        function->registers = {0, 1, 2};
    }
    stream.expect(Kind::LeftBrace, "'{' and the function's body");
    if (is_special(stream.peek().kind)) {
        function->unavailable = fmt::format("functions made of {} are not available yet", spelling(stream.peek().kind));
        pass_body(stream);
    } else {
        BodyReader(stream, *function, parameters).read();
    }
    stream.expect(Kind::RightBrace, "'}' at the end of the function");
    stream.set_raw_operators(raw);
    return function;
}

}  // namespace parser
