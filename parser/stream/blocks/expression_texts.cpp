#include "parser/stream/blocks/expression_compiler.h"

/// Texts, and numbers that are read off them.
namespace parser::blocks {

bool begins_text(const Token& token, const Meanings& meanings)
{
    if (token.kind == Kind::String || lexical_class(token.kind) == LexicalClass::String) return true;
    const Value* const value = token.kind == Kind::Identifier ? meanings.find(token.name) : nullptr;
    if (!value) return false;
    if (value->get_if<std::string>()) return true;
    const auto* const array = value->get_if<std::shared_ptr<Array>>();
    if (!array) return false;
    for (const Value& element : (*array)->elements)
        if (element.set()) return element.get_if<std::string>() != nullptr;
    return meanings.components(token.name) == kTextElements;
}

bool ExpressionCompiler::text()
{
    if (++nesting_ > kDeepestNesting || !meanings_.texts()) return false;
    const Kind first = kind();
    bool good = false;
    if (first == Kind::String) {
        std::string literal;
        if (!meanings_.literal(tokens_[at_], literal)) return false;
        ++at_;
        emitter_.text_constant(std::move(literal));
        good = true;
    } else if (lexical_class(first) == LexicalClass::String) {
        ++at_;
        good = take(Kind::LeftParen) && text_function(first) && take(Kind::RightParen);
    } else if (first == Kind::Identifier) {
        good = text_identifier();
    }
    --nesting_;
    return good;
}

/// Some, with commas between them or without: joined.
bool ExpressionCompiler::texts()
{
    if (!text()) return false;
    while (take(Kind::Comma) || begins_text(tokens_[at_], meanings_)) {
        if (!text()) return false;
        emitter_.append_text();
    }
    return true;
}

bool ExpressionCompiler::text_identifier()
{
    if (!begins_text(tokens_[at_], meanings_)) return false;
    const std::uint32_t name = tokens_[at_++].name;
    const auto* const array = meanings_.find(name)->get_if<std::shared_ptr<Array>>();
    if (!array) return emitter_.text_load(name);
    const std::size_t dimensions = (*array)->sizes.size();
    return subscripts(dimensions) && emitter_.text_element(name, dimensions);
}

bool ExpressionCompiler::text_function(Kind word)
{
    switch (word) {
    case Kind::Concat: return texts();
    case Kind::Chr:
        if (!number(true)) return false;
        emitter_.text_of_numbers(kTextCharacter, 1);
        return true;
    case Kind::Str:
        if (!numbers(3)) return false;
        emitter_.text_of_numbers(kTextNumber, 3);
        return true;
    case Kind::Vstr: {
        if (!number() || !comma()) return false;
        const int count = sum(1);
        if (count < 1 || !comma() || !text() || !comma() || !numbers(2)) return false;
        emitter_.change_text(kTextTuple, 3u + static_cast<std::size_t>(count)).b = static_cast<std::uint32_t>(count);
        return true;
    }
    case Kind::Substr:
        if (!text() || !comma() || !numbers(2)) return false;
        emitter_.change_text(kTextPart, 2);
        return true;
    case Kind::Strupr:
    case Kind::Strlwr:
        if (!text()) return false;
        emitter_.change_text(word == Kind::Strupr ? kTextUpper : kTextLower, 0);
        return true;
    default: return false;
    }
}

int ExpressionCompiler::number_of_text(Kind word)
{
    const bool two = word == Kind::Strcmp;
    if (!text() || (two && (!comma() || !text()))) return -1;
    emitter_.number_of_texts(word == Kind::Strlen ? kTextLength
                             : word == Kind::Asc  ? kTextFirst
                             : word == Kind::Val  ? kTextValue
                                                  : kTextOrder,
                             two ? 2 : 1);
    return 1;
}

/// `dimensions(A)`, `dimension_size(A, n)`: behind the parenthesis.
bool ExpressionCompiler::dimension_size(Kind word)
{
    if (!meanings_.texts() || kind() != Kind::Identifier) return false;
    const std::uint32_t name = tokens_[at_++].name;
    const Value* const value = meanings_.find(name);
    if (!value || !value->get_if<std::shared_ptr<Array>>()) return false;
    const bool sized = word == Kind::DimensionSize;
    return (!sized || (comma() && number())) && emitter_.dimension_size(name, sized);
}

}  // namespace parser::blocks
