#pragma once

#include "parser/grammar/core/productions.h"
#include "parser/stream/token_input.h"

/// What a rule reads, told from its type: PEGTL's combinators, tokens and operands; a rule that has a form() of its own
/// tells that.
namespace parser {

template <class Rule>
Form form_of();

namespace forms {

template <class... Rules>
Form all(pegtl::type_list<Rules...>)
{
    return Form::sequence({form_of<Rules>()...});
}

/// By Rule::rule_t. Sequences, and what only changes how a failure is told, are their parts.
template <class Rule>
struct of {
    static Form form() { return all(typename Rule::subs_t{}); }
};
template <Kind kind>
struct of<token<kind>> {
    static Form form() { return Form::token(kind); }
};
template <Kind... kinds>
struct of<any_token<kinds...>> {
    static Form form() { return Form::choice({Form::token(kinds)...}); }
};
template <class... Rules>
struct of<pegtl::internal::sor<Rules...>> {
    static Form form() { return Form::choice({form_of<Rules>()...}); }
};
template <class Rule>
struct of<pegtl::internal::opt<Rule>> {
    static Form form() { return Form::optional(form_of<Rule>()); }
};
template <class Rule>
struct of<pegtl::internal::star<Rule>> {
    static Form form() { return Form::repeated(form_of<Rule>()); }
};
template <class Rule>
struct of<pegtl::internal::plus<Rule>> {
    static Form form() { return Form::repeated(form_of<Rule>(), 1); }
};
template <unsigned count, class Rule>
struct of<pegtl::internal::rep<count, Rule>> {
    static Form form() { return Form::sequence(std::vector<Form>(count, form_of<Rule>())); }
};
template <>
struct of<rules::float_expr> {
    static Form form() { return Form::named(number_form); }
};
template <>
struct of<rules::vector2_expr> {
    static Form form() { return Form::named(pair_form); }
};
template <>
struct of<rules::vector_expr> {
    static Form form() { return Form::named(vector_form); }
};
template <>
struct of<rules::vector4_expr> {
    static Form form() { return Form::named(vector4_form); }
};
template <>
struct of<rules::color_expr> {
    static Form form() { return Form::named(color_form); }
};
template <>
struct of<rules::string_expr> {
    static Form form() { return Form::named(text_form); }
};

/// What a value of that type is in a text.
template <class T>
struct value {
    static Form form()
    {
        if constexpr (std::is_same_v<T, bool>) return Form::optional(Form::named(number_form));
        else if constexpr (std::is_arithmetic_v<T>) return Form::named(number_form);
        else if constexpr (std::is_same_v<T, glm::dvec2>) return Form::named(pair_form);
        else if constexpr (std::is_same_v<T, glm::dvec3>) return Form::named(vector_form);
        else if constexpr (std::is_same_v<T, glm::dvec4>) return Form::named(vector4_form);
        else if constexpr (std::is_same_v<T, std::string>) return Form::named(text_form);
        else return Form::named(color_form);
    }
};
template <class T>
struct value<std::optional<T>> : value<T> {};
template <class T>
Form of_value(const T*)
{
    return value<T>::form();
}

}  // namespace forms

template <class Rule>
Form form_of()
{
    if constexpr (requires { Rule::form(); }) {
        Form form = Rule::form();
        if constexpr (requires { Rule::rare; }) form.rare = true;
        return form;
    } else {
        Form form = forms::of<typename Rule::rule_t>::form();
        if constexpr (requires { Rule::rare; }) form.rare = true;
        return form;
    }
}

}  // namespace parser
