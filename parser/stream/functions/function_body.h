#pragma once

#include "function/build/builder.h"
#include "parser/stream/token_stream.h"

#include <map>
#include <string>
#include <vector>

namespace parser {

/// Reads the expression in a function into a builder. Precedence, loosest first: `|`, `&`, relations, `+ -`, `* /`, one
/// sign. What POV-Ray's own reading changes in the last bit is done alike (spec 5b, 15.3): constants added one after
/// the other are added first, division by a constant is multiplication by its reciprocal, small whole powers are
/// products.
class BodyReader {
public:
    using Value = function::Builder::Value;
    using Op = function::Op;

    BodyReader(TokenStream& stream, function::Builder& build, const std::map<std::string, Value>& parameters)
        : stream_(stream), build_(build), names_(parameters)
    {}

    Value read();

private:
    Value level(int which);
    Value sum();
    Value product();
    Value signed_operand();
    Value operand();
    Value named(const Token& token);
    Value user_function(const Token& name, const function::FunctionPtr& called);
    Value built_in(const Token& token);
    Value power(const Token& token, const std::vector<Value>& arguments);
    Value select(const Token& token);
    Value loop(const Token& token);
    Value component(Value vector, std::uint32_t count);
    std::vector<Value> arguments();
    void comma();

    TokenStream& stream_;
    function::Builder& build_;
    std::map<std::string, Value> names_;  ///< parameters, and the counters of sum and prod
};

}  // namespace parser
