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
    if (peek().kind != Kind::Identifier) return std::nullopt;
    const Value* value = symbols_.find(ahead_->name);
    if (value && value->template get_if<std::shared_ptr<Dictionary>>())
        if (const Value* member = member_ahead(); member && member != value) {
            if (!member->template get_if<T>()) return std::nullopt;
            const Token name = next();
            const Cell element = subscripted(symbols_.find_cell(name.name), name, false);
            if (const T* content = element->template get_if<T>()) return *content;
            fail(place(name), "this member is of another kind");
        }
    if (!value) return std::nullopt;
    if (const T* whole = value->template get_if<T>()) {
        T content = *whole;
        next();
        return content;
    }
    const auto* array = value->template get_if<std::shared_ptr<Array>>();
    if (!array) return std::nullopt;
    Cell cell = symbols_.find_cell(ahead_->name);
    const Value* first = nullptr;  // arrays of arrays: look at the innermost elements
    for (const Array* level = array->get(); level != nullptr;) {
        first = nullptr;
        for (const Value& element : level->elements)
            if (element.set()) {
                first = &element;
                break;
            }
        const auto* inner = first ? first->template get_if<std::shared_ptr<Array>>() : nullptr;
        level = inner ? inner->get() : nullptr;
    }
    if (!first || !first->template get_if<T>()) return std::nullopt;
    const Token name = next();
    const scene::SourceRef at = place(name);
    const Cell element = subscripted(std::move(cell), name, false);
    if (const T* content = element->template get_if<T>()) return *content;
    fail(at, "this array element is of another kind");
}

}  // namespace parser
