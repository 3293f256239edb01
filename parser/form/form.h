#pragma once

#include "parser/lexer/token.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace parser {

struct Production;

/// What a rule of the grammar reads, as data: for those who want to know the language without reading a scene.
/// parser/grammar/core/forms.h makes it of the rule's type.
struct Form {
    enum class Is : std::uint8_t {
        Word,      ///< one token: `word`
        Operand,   ///< an expression or a name: `name` of it
        Sequence,  ///< all parts, in order
        Choice,    ///< one of the parts
        Optional,  ///< the part, or nothing
        Repeated,  ///< the part, any number of times from `least` on
        Named      ///< what stands in `production`
    };
    Is is = Is::Sequence;
    Kind word = Kind::EndOfText;
    std::string_view name;
    std::vector<Form> parts;
    int least = 0;
    Production (*production)() = nullptr;
    bool rare = false;  ///< understood, but nothing to propose to an author

    // None of these is worth its room in the hundreds of rules that call them.
    Form();
    Form(const Form&);
    Form(Form&&) noexcept;
    Form& operator=(const Form&);
    Form& operator=(Form&&) noexcept;
    ~Form();
    static Form token(Kind kind);
    static Form operand(std::string_view name);
    static Form named(Production (*production)());
    static Form sequence(std::vector<Form> parts);
    static Form choice(std::vector<Form> parts);
    static Form optional(Form part);
    static Form repeated(Form part, int least = 0);
    /// `{` parts `}`
    static Form braces(std::vector<Form> parts);

    /// Nothing at all stands there.
    bool empty() const;

private:
    /// Parts of the same kind become parts of the whole.
    static Form joined(Is is, std::vector<Form> parts);
};

/// A rule with a name. Productions name each other by functions, since blocks hold blocks.
struct Production {
    std::string_view name;
    Form form;
};

/// All productions that a text of the first can be made of, the first included, each once.
std::vector<Production> productions_from(Production (*first)());

/// One production a paragraph, in the notation of the W3C's recommendations: `name ::= 'word' other? more*`.
std::string ebnf(const std::vector<Production>& productions);

}  // namespace parser
