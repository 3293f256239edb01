#include "parser/form/form.h"

#include <algorithm>

namespace parser {
namespace {

constexpr std::size_t kWidth = 100;

void add_named(const Form& form, std::vector<Production (*)()>& functions)
{
    if (form.is == Form::Is::Named && std::find(functions.begin(), functions.end(), form.production) == functions.end())
        functions.push_back(form.production);
    for (const Form& part : form.parts) add_named(part, functions);
}

std::string text_of(const Form& form);

/// In parentheses where more than one thing stands there.
std::string enclosed(const Form& form)
{
    const bool many = (form.is == Form::Is::Sequence || form.is == Form::Is::Choice) && form.parts.size() != 1;
    return many ? "(" + text_of(form) + ")" : text_of(form);
}

std::string text_of(const Form& form)
{
    switch (form.is) {
    case Form::Is::Word: return "'" + std::string(spelling(form.word)) + "'";
    case Form::Is::Operand: return std::string(form.name);
    case Form::Is::Named: return std::string(form.production().name);
    case Form::Is::Optional: return enclosed(form.parts.front()) + "?";
    case Form::Is::Repeated: return enclosed(form.parts.front()) + (form.least > 0 ? "+" : "*");
    default: break;
    }
    std::string text;
    for (const Form& part : form.parts) {
        if (!text.empty()) text += form.is == Form::Is::Choice ? " | " : " ";
        text += form.is == Form::Is::Sequence && part.is == Form::Is::Choice ? enclosed(part) : text_of(part);
    }
    return text;
}

/// Broken between words, but not within '...'.
std::string wrapped(const std::string& text, std::size_t indent)
{
    std::string lines;
    std::size_t column = indent;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t blank = std::min(text.find(' ', at), text.size());
        if (!lines.empty() && column + 1 + blank - at > kWidth) {
            lines += "\n" + std::string(indent + 2, ' ');
            column = indent + 2;
        } else if (!lines.empty()) {
            lines += ' ';
            ++column;
        }
        lines += text.substr(at, blank - at);
        column += blank - at;
        at = blank + 1;
    }
    return lines;
}

}  // namespace

Form::Form() = default;
Form::Form(const Form&) = default;
Form::Form(Form&&) noexcept = default;
Form& Form::operator=(const Form&) = default;
Form& Form::operator=(Form&&) noexcept = default;
Form::~Form() = default;

Form Form::token(Kind kind)
{
    Form form;
    form.is = Is::Word;
    form.word = kind;
    return form;
}

Form Form::operand(std::string_view name)
{
    Form form;
    form.is = Is::Operand;
    form.name = name;
    return form;
}

Form Form::named(Production (*production)())
{
    Form form;
    form.is = Is::Named;
    form.production = production;
    return form;
}

Form Form::sequence(std::vector<Form> parts) { return joined(Is::Sequence, std::move(parts)); }

Form Form::choice(std::vector<Form> parts) { return joined(Is::Choice, std::move(parts)); }

Form Form::optional(Form part)
{
    Form form;
    form.is = Is::Optional;
    form.parts.push_back(std::move(part));
    return form;
}

Form Form::repeated(Form part, int least)
{
    Form form = optional(std::move(part));
    form.is = Is::Repeated;
    form.least = least;
    return form;
}

bool Form::empty() const
{
    const bool inner = is == Is::Optional || is == Is::Repeated;
    return inner ? parts.front().empty() : is == Is::Sequence && parts.empty();
}

Form Form::joined(Is is, std::vector<Form> parts)
{
    Form whole;
    whole.is = is;
    for (Form& part : parts) {
        if (part.is == is && !part.rare)
            std::move(part.parts.begin(), part.parts.end(), std::back_inserter(whole.parts));
        else if (!part.empty()) whole.parts.push_back(std::move(part));
    }
    return whole.parts.size() == 1 ? Form(std::move(whole.parts.front())) : whole;
}

Form Form::braces(std::vector<Form> parts)
{
    parts.insert(parts.begin(), token(Kind::LeftBrace));
    parts.push_back(token(Kind::RightBrace));
    return sequence(std::move(parts));
}

std::vector<Production> productions_from(Production (*first)())
{
    std::vector<Production (*)()> functions{first};
    std::vector<Production> all;
    for (std::size_t i = 0; i < functions.size(); ++i) {
        all.push_back(functions[i]());
        add_named(all.back().form, functions);
    }
    return all;
}

std::string ebnf(const std::vector<Production>& productions)
{
    std::string text;
    for (const Production& one : productions) {
        text += std::string(one.name) + " ::=";
        if (one.form.is == Form::Is::Choice) {
            for (const Form& part : one.form.parts)
                text += (&part == &one.form.parts.front() ? "\n    " : "\n  | ") + wrapped(text_of(part), 4);
            text += "\n\n";
        } else {
            text += "\n    " + wrapped(text_of(one.form), 4) + "\n\n";
        }
    }
    return text;
}

}  // namespace parser
