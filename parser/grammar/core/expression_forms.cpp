#include "parser/grammar/core/rules.h"

/// What stands below the rules and is read without them: expressions and directives.
namespace parser {
namespace {

struct an_identifier {
    static Form form() { return Form::operand("identifier"); }
};
struct any_value {
    static Form form() { return Form::named(declared_value); }
};
template <Production (*production)()>
struct the {
    static Form form() { return Form::named(production); }
};
template <Kind... kinds>
using one_of = any_token<kinds...>;
template <class Rule, class Between>
using list = seq<Rule, pegtl::star<Between, Rule>>;

/// All words that begin an expression in one way; `gray` only ends one.
template <LexicalClass kind>
struct words_of_class {
    static Form form()
    {
        std::vector<Form> all;
        for (std::size_t i = 0; i < kKindCount; ++i)
            if (lexical_class(static_cast<Kind>(i)) == kind && static_cast<Kind>(i) != Kind::Gray)
                all.push_back(Form::token(static_cast<Kind>(i)));
        return Form::choice(std::move(all));
    }
};
struct a_literal {
    static Form form() { return Form::operand("NUMBER"); }
};
struct a_string {
    static Form form() { return Form::operand("STRING"); }
};

Production condition();
Production sum();
Production number_word() { return {"number_word", words_of_class<LexicalClass::Float>::form()}; }
Production vector_word() { return {"vector_word", words_of_class<LexicalClass::Vector>::form()}; }
Production color_word() { return {"color_word", words_of_class<LexicalClass::Color>::form()}; }
Production text_word() { return {"text_word", words_of_class<LexicalClass::String>::form()}; }

using open = token<Kind::LeftParen>;
using close = token<Kind::RightParen>;
struct text_operand {
    static Form form() { return Form::named(text_form); }
};
struct argument : pegtl::sor<the<condition>, text_operand> {};
using arguments = seq<open, opt<list<argument, opt_comma>>, close>;

Production primary()
{
    using components = seq<token<Kind::Less>, list<the<sum>, opt_comma>, token<Kind::Greater>>;
    using element = pegtl::star<pegtl::sor<seq<token<Kind::LeftSquare>, the<sum>, token<Kind::RightSquare>>,
                                           seq<token<Kind::Period>, an_identifier>, arguments>>;
    using word = seq<pegtl::sor<the<number_word>, the<vector_word>>, opt<arguments>>;
    using axis = pegtl::sor<words_of_class<LexicalClass::Vector2>, words_of_class<LexicalClass::Vector4>>;
    using of_scope = seq<one_of<Kind::Local, Kind::Global>, token<Kind::Period>, an_identifier, element>;
    return {"primary", form_of<pegtl::sor<a_literal, seq<an_identifier, element>, of_scope,
                                          seq<open, the<condition>, close>, components, word, axis>>()};
}
Production factor()
{
    using sign = pegtl::star<one_of<Kind::Plus, Kind::Minus, Kind::Exclamation>>;
    using part = pegtl::sor<one_of<Kind::X, Kind::Y, Kind::Z, Kind::T, Kind::U, Kind::V, Kind::Red, Kind::Green,
                                   Kind::Blue, Kind::Filter, Kind::Transmit, Kind::Gray>>;
    return {"factor", form_of<seq<sign, the<primary>, opt<token<Kind::Period>, part>>>()};
}
Production product() { return {"product", form_of<list<the<factor>, one_of<Kind::Star, Kind::Slash>>>()}; }
Production sum() { return {"sum", form_of<list<the<product>, one_of<Kind::Plus, Kind::Minus>>>()}; }
Production relation()
{
    using compares =
        one_of<Kind::Less, Kind::LessEqual, Kind::Equal, Kind::NotEqual, Kind::GreaterEqual, Kind::Greater>;
    return {"relation", form_of<pegtl::sor<list<the<sum>, compares>, seq<text_operand, compares, text_operand>>>()};
}
Production condition()
{
    using choice = seq<token<Kind::Question>, the<condition>, token<Kind::Colon>, the<condition>>;
    return {"condition", form_of<seq<list<the<relation>, one_of<Kind::Ampersand, Kind::Bar>>, opt<choice>>>()};
}

}  // namespace

Production number_form() { return {"number", Form::named(sum)}; }
Production pair_form() { return {"pair", Form::named(sum)}; }
Production vector_form() { return {"vector", Form::named(sum)}; }
Production vector4_form() { return {"vector4", Form::named(sum)}; }
Production color_form()
{
    return {
        "color",
        form_of<
            pegtl::sor<the<condition>, seq<opt<token<Kind::Color>>, pegtl::plus<the<color_word>, the<condition>>>>>()};
}
Production text_form()
{
    return {"text", form_of<pegtl::sor<a_string, an_identifier, seq<the<text_word>, opt<arguments>>>>()};
}

Production function_value() { return {"function_value", form_of<seq<token<Kind::Function>, the<function_block>>>()}; }

Production function_block()
{
    using pattern = seq<token<Kind::Pattern>, open_brace, the<function_pattern_type>,
                        pegtl::star<the<pattern_modifier>>, close_brace>;
    using pigment = seq<token<Kind::Pigment>, the<pigment_block>>;
    using transform = seq<token<Kind::Transform>, the<transform_block>>;
    using spline = seq<token<Kind::Spline>, the<spline_block>>;
    using internal = seq<token<Kind::Internal>, open, a_number, close>;
    return {"function_block",
            form_of<seq<opt<open, list<an_identifier, comma>, close>, open_brace,
                        pegtl::sor<pattern, pigment, transform, internal, spline, the<condition>>, close_brace>>()};
}
Production spline_block()
{
    using kind = one_of<Kind::LinearSpline, Kind::QuadraticSpline, Kind::CubicSpline, Kind::NaturalSpline>;
    return {
        "spline_block",
        form_of<seq<open_brace, pegtl::sor<an_identifier, seq<opt<kind>, list<seq<a_number, comma, a_vector>, comma>>>,
                    close_brace>>()};
}

namespace {

Production value()
{
    using size = seq<token<Kind::LeftSquare>, the<sum>, token<Kind::RightSquare>>;
    using array = seq<token<Kind::Array>, opt<token<Kind::Mixed>>, pegtl::star<size>, opt<token<Kind::Optional>>,
                      opt<open_brace, list<the<value>, comma>, close_brace>>;
    using key = pegtl::sor<seq<token<Kind::Period>, an_identifier>,
                           seq<token<Kind::LeftSquare>, a_string, token<Kind::RightSquare>>>;
    using dictionary = seq<token<Kind::Dictionary>,
                           opt<open_brace, opt<list<seq<key, token<Kind::Colon>, the<value>>, comma>>, close_brace>>;
    using spline = seq<token<Kind::Spline>, the<spline_block>>;
    return {
        "value",
        form_of<pegtl::sor<any_value, the<sum>, a_color, a_text, the<function_value>, spline, array, dictionary>>()};
}
struct parameters : seq<open, opt<list<seq<opt<token<Kind::Optional>>, an_identifier>, comma>>, close> {};
using scope = seq<one_of<Kind::Local, Kind::Global>, token<Kind::Period>>;
using name = seq<opt<scope>, an_identifier,
                 pegtl::star<pegtl::sor<seq<token<Kind::LeftSquare>, the<sum>, token<Kind::RightSquare>>,
                                        seq<token<Kind::Period>, an_identifier>>>>;
using end = opt<token<Kind::Semicolon>>;

}  // namespace

Production rest_of_directive()
{
    using given = seq<name, token<Kind::Equal>, the<value>, end>;
    return {"rest_of_directive", form_of<pegtl::sor<given, seq<a_text>, seq<a_number, end>>>()};
}

Production directive()
{
    using some = seq<opt<token<Kind::Optional>>, opt<name>>;
    using tuple = seq<open, list<some, comma>, close, token<Kind::Equal>, open, list<the<value>, comma>, close>;
    using unpacked = seq<open_brace, list<opt<an_identifier>, comma>, close_brace, token<Kind::Equal>, the<value>>;
    using one =
        seq<opt<token<Kind::Deprecated>, opt<token<Kind::Once>>, opt<a_text>>, name, token<Kind::Equal>, the<value>>;
    using declares = seq<one_of<Kind::Declare, Kind::Local>, pegtl::sor<one, tuple, unpacked>, end>;
    using asks = seq<pegtl::sor<
        seq<one_of<Kind::If, Kind::Elseif, Kind::While, Kind::Switch, Kind::Case>, open, the<condition>, close>,
        seq<one_of<Kind::Ifdef, Kind::Ifndef>, open, name, close>,
        seq<token<Kind::Range>, open, the<sum>, comma, the<sum>, close>,
        seq<token<Kind::For>, open, list<seq<name>, comma>, comma, the<sum>, comma, the<sum>, opt<comma, the<sum>>,
            close>>>;
    using says = seq<one_of<Kind::Debug, Kind::Warning, Kind::Error, Kind::Render, Kind::Statistics>, a_text>;
    using opens = seq<token<Kind::Fopen>, an_identifier, a_text, one_of<Kind::Read, Kind::Write, Kind::Append>>;
    using bytes = one_of<Kind::Sint8, Kind::Uint8, Kind::Sint16be, Kind::Sint16le, Kind::Uint16be, Kind::Uint16le,
                         Kind::Sint32be, Kind::Sint32le>;
    using reads_file = seq<one_of<Kind::Read, Kind::Write>, open, an_identifier,
                           pegtl::star<comma, pegtl::sor<the<value>, seq<bytes, the<value>>>>, close>;
    using others = pegtl::sor<one_of<Kind::Else, Kind::End, Kind::Break>, seq<token<Kind::Undef>, an_identifier>,
                              seq<token<Kind::Macro>, an_identifier, parameters>, seq<token<Kind::Include>, a_text>,
                              seq<token<Kind::Version>, a_number, end>, seq<token<Kind::Default>, the<default_block>>,
                              seq<token<Kind::Fclose>, an_identifier>>;
    return {"directive",
            form_of<seq<token<Kind::Hash>, pegtl::sor<declares, asks, says, opens, reads_file, others>>>()};
}

}  // namespace parser
