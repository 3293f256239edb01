#include "parser/stream/expressions/compiler.h"

/// Texts, and numbers that are read off them.
namespace parser {

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

bool Compiler::text()
{
    if (++nesting_ > kDeepestNesting || !meanings_.texts()) return false;
    const Kind first = kind();
    bool good = false;
    if (first == Kind::String) {
        std::string literal;
        if (!meanings_.literal(tokens_[at_], literal)) return false;
        ++at_;
        emit(Code::TextConstant, 0).name = static_cast<std::uint32_t>(out_.texts.size());
        out_.texts.push_back(std::move(literal));
        good = push_text();
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
bool Compiler::texts()
{
    if (!text()) return false;
    while (take(Kind::Comma) || begins_text(tokens_[at_], meanings_)) {
        if (!text()) return false;
        --text_depth_;
        emit(Code::TextAppend, 0);
    }
    return true;
}

bool Compiler::text_identifier()
{
    if (!begins_text(tokens_[at_], meanings_)) return false;
    const std::uint32_t name = tokens_[at_++].name;
    const Value* const value = meanings_.find(name);
    if (value->get_if<std::string>()) {
        emit(Code::TextLoad, 0).name = name;
        return push_text();
    }
    const auto dimensions = static_cast<int>((*value->get_if<std::shared_ptr<Array>>())->sizes.size());
    for (int i = 0; i < dimensions; ++i)
        if (!take(Kind::LeftSquare) || !number() || !take(Kind::RightSquare)) return false;
    CompiledOp& op = emit(Code::TextElement, -dimensions);
    op.name = name;
    op.a = static_cast<std::uint8_t>(dimensions);
    return push_text();
}

bool Compiler::text_function(Kind word)
{
    switch (word) {
    case Kind::Concat: return texts();
    case Kind::Chr:
        if (!number(true)) return false;
        emit(Code::TextCharacter, -1);
        return push_text();
    case Kind::Str:
        if (!number() || !comma() || !number() || !comma() || !number()) return false;
        emit(Code::TextNumber, -3);
        return push_text();
    case Kind::Vstr: {
        if (!number() || !comma()) return false;
        const int count = sum(1);
        if (count < 1 || !comma() || !text() || !comma() || !number() || !comma() || !number()) return false;
        emit(Code::TextTuple, -3 - count).a = static_cast<std::uint8_t>(count);
        return true;
    }
    case Kind::Substr:
        if (!text() || !comma() || !number() || !comma() || !number()) return false;
        emit(Code::TextPart, -2);
        return true;
    case Kind::Strupr:
    case Kind::Strlwr:
        if (!text()) return false;
        emit(word == Kind::Strupr ? Code::TextUpper : Code::TextLower, 0);
        return true;
    default: return false;
    }
}

int Compiler::number_of_text(Kind word)
{
    if (!text()) return -1;
    if (word == Kind::Strcmp) {
        take(Kind::Comma);
        if (!text()) return -1;
        --text_depth_;
    }
    --text_depth_;
    emit(word == Kind::Strlen ? Code::TextLength
         : word == Kind::Asc  ? Code::TextFirst
         : word == Kind::Val  ? Code::TextValue
                              : Code::TextOrder,
         1);
    return 1;
}

/// `dimensions(A)`, `dimension_size(A, n)`: behind the parenthesis.
bool Compiler::dimension_size(Kind word)
{
    if (!meanings_.texts() || kind() != Kind::Identifier) return false;
    const std::uint32_t name = tokens_[at_++].name;
    const Value* const value = meanings_.find(name);
    if (!value || !value->get_if<std::shared_ptr<Array>>()) return false;
    const bool sized = word == Kind::DimensionSize;
    if (sized && (!comma() || !number())) return false;
    CompiledOp& op = emit(Code::DimensionSize, sized ? 0 : 1);
    op.name = name;
    op.a = sized ? 1 : 0;
    return true;
}

}  // namespace parser
