#pragma once

// Templates of TokenStream; token_stream.h includes this at its end, and everybody else includes token_stream.h.
#include "parser/stream/token_stream.h"

namespace parser {

/// The stream reads other tokens as long as this lives, and then goes on where it was.
class TokenStream::Again {
public:
    Again(TokenStream& stream, const Token* begin, const Token* end);
    ~Again();
    Again(const Again&) = delete;
    Again& operator=(const Again&) = delete;

private:
    TokenStream& stream_;
    std::size_t depth_;
    const Token *ahead_, *last_;
    bool has_ahead_, ahead_raw_, raw_operators_;
    std::uint64_t left_;
};

template <class Read>
void TokenStream::read_again(const Token* begin, const Token* end, Read&& read)
{
    const Again again(*this, begin, end);
    read();
}

template <class T>
std::optional<T> TokenStream::accept_identifier()
{
    if (!at_name()) return std::nullopt;
    const Value* value = ahead_->kind == Kind::Identifier ? symbols_.find(ahead_->name) : nullptr;
    const bool parts = ahead_->kind != Kind::Identifier || (value && has_parts_of_any_type(*value));
    if (parts) value = named_ahead();
    if (!value) return std::nullopt;
    const T* const whole = value->template get_if<T>();
    if (whole && !parts) {
        T content = *whole;
        next();
        return content;
    }
    const auto* array = value->template get_if<std::shared_ptr<Array>>();
    if (!array && !whole) return std::nullopt;
    const Value* first = nullptr;  // arrays of arrays: look at the innermost elements
    for (const Array* level = whole ? nullptr : array->get(); level != nullptr;) {
        first = nullptr;
        for (const Value& element : level->elements)
            if (element.set()) {
                first = &element;
                break;
            }
        const auto* inner = first ? first->template get_if<std::shared_ptr<Array>>() : nullptr;
        level = inner ? inner->get() : nullptr;
    }
    if (!whole && (!first || !first->template get_if<T>())) return std::nullopt;
    Token name;
    const Cell taken = take_name(name);
    const Cell element = subscripted(taken, name, false);
    if (const T* content = element->template get_if<T>()) return *content;
    fail(place(name), "this element is of another kind");
}

}  // namespace parser
