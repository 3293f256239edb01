#include "parser/stream/values/elements.h"
#include "parser/stream/expression.h"
#include "parser/stream/token_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

/// Arrays and dictionaries: how they are written and how their parts are named.
namespace parser {
namespace {

constexpr double kMostElements = 100'000'000;

/// To so many elements. References into the old memory stay readable.
void grow(Array& array, std::size_t elements)
{
    if (elements > array.elements.capacity()) {
        std::vector<Value> wider;
        wider.reserve(std::max<std::size_t>({8, elements, 2 * array.elements.size()}));
        wider = array.elements;
        array.retired.push_back(std::exchange(array.elements, std::move(wider)));
    }
    array.elements.resize(elements);
    array.sizes[0] = static_cast<std::uint32_t>(array.elements.size());
}

}  // namespace

Cell TokenStream::element_cell(const std::shared_ptr<Array>& array, const Token& name, bool may_create)
{
    std::size_t index = 0;
    for (std::size_t dimension = 0; dimension < array->sizes.size(); ++dimension) {
        if (!accept(Kind::LeftSquare)) fail_expected("'[' and the next subscript");
        const bool raw = std::exchange(raw_operators_, false);
        const double at = float_expr(*this) + kSubscriptSlack;
        expect(Kind::RightSquare, "']'");
        raw_operators_ = raw;
        if (!(at >= 0.0)) fail(last(), fmt::format("a subscript of '{}' is negative", word(name)));
        if (array->growing && may_create && at >= array->sizes[0] && at < kMostElements)
            grow(*array, static_cast<std::size_t>(at) + 1);
        const std::uint32_t size = array->sizes[dimension];
        if (at >= size)
            fail(last(),
                 fmt::format("a subscript of '{}' is {}, its size there is {}", word(name), std::floor(at), size));
        index = index * size + static_cast<std::size_t>(at);
    }
    return Cell(array, &array->elements[index]);
}

Cell TokenStream::member_cell(const std::shared_ptr<Dictionary>& dictionary, const Token& name, bool may_create)
{
    const std::string key = read_key();
    const auto found = dictionary->members.find(key);
    if (found != dictionary->members.end()) return found->second;
    if (!may_create) fail(last(), fmt::format("'{}' has no member '{}'", word(name), key));
    return dictionary->members.emplace(key, std::make_shared<Value>()).first->second;
}

/// `.Key` or `["Key"]`.
std::string TokenStream::read_key()
{
    if (accept(Kind::Period)) {
        const Token key = raw_next();
        if (key.kind != Kind::Identifier && !is_keyword(key.kind)) fail_expected_at(key, "a member's name");
        return word(key);
    }
    expect(Kind::LeftSquare, "'.' and a member's name");
    const bool raw = std::exchange(raw_operators_, false);
    std::string key = string_expr(*this);
    expect(Kind::RightSquare, "']'");
    raw_operators_ = raw;
    return key;
}

Cell TokenStream::subscripted(Cell cell, const Token& name, bool may_create, std::shared_ptr<Array>* innermost)
{
    while (is_container(*cell)) {
        const Kind next = peek_operator().kind;
        const auto* held = cell->get_if<std::shared_ptr<Array>>();
        if (next != Kind::LeftSquare && (held || next != Kind::Period)) break;
        if (held) {
            const std::shared_ptr<Array> array = *held;  // reading may change what the name stands for
            cell = element_cell(array, name, may_create);
            if (innermost) *innermost = array;
        } else {
            const auto dictionary = *cell->get_if<std::shared_ptr<Dictionary>>();
            cell = member_cell(dictionary, name, may_create);
            if (innermost) innermost->reset();
        }
        if (!cell->set()) {
            if (may_create) return cell;
            fail(place(name), fmt::format("this element of '{}' has no value yet", word(name)));
        }
    }
    return cell;
}

void TokenStream::set_element(Array& array, const Cell& element, Value value, const Token& name)
{
    const std::uint32_t kind = kind_of(value);
    if (array.kind == 0) array.kind = kind;
    if (array.kind != kind && !array.mixed)
        fail(place(name),
             fmt::format("the elements of '{}' are of another type than {}", word(name), type_name(value)));
    *element = std::move(value);
}

std::shared_ptr<Array> TokenStream::read_array()
{
    next();
    const bool raw = std::exchange(raw_operators_, false);
    auto array = std::make_shared<Array>();
    if (accept(Kind::Mixed)) array->mixed = true;
    double elements = 1;
    if (peek_raw().kind != Kind::LeftSquare) {
        array->growing = true;
        array->sizes.push_back(0);
        elements = 0;
    }
    while (!array->growing && array->sizes.size() < 5 &&
           (array->sizes.empty() || peek_raw().kind == Kind::LeftSquare)) {
        expect(Kind::LeftSquare, "'[' and the array's size");
        const double size = std::floor(float_expr(*this) + kSubscriptSlack);
        expect(Kind::RightSquare, "']'");
        elements *= size;
        if (!(size >= 1.0 && elements <= kMostElements)) fail(last(), "this array has no or too many elements");
        array->sizes.push_back(static_cast<std::uint32_t>(size));
    }
    array->elements.resize(static_cast<std::size_t>(elements));
    if (as_word(peek_raw()).kind == Kind::Optional) next(), array->gaps = true;
    if (peek_raw().kind == Kind::LeftBrace) {
        std::size_t at = 0;
        raw_operators_ = !new_language();
        read_elements(*array, 0, at);
    }
    raw_operators_ = raw;
    return array;
}

/// POV-Ray executes nothing in the list of an array's elements.
void TokenStream::refuse_directive_in_array()
{
    if (new_language() || plain_ahead() || (peek_raw().kind != Kind::Hash && !is_macro(*ahead_))) return;
    fail(place(*ahead_), ahead_->kind == Kind::Hash
                             ? "a directive cannot stand between the elements of an array"
                             : "a macro call cannot be an element of an array: parentheses around it make it one");
}

void TokenStream::read_elements(Array& array, std::size_t dimension, std::size_t& at)
{
    const scene::SourceRef opened = here();
    expect(Kind::LeftBrace, "'{' and the array's elements");
    for (std::uint32_t i = 0; array.growing || i < array.sizes[dimension]; ++i) {
        if (array.growing && peek().kind == Kind::RightBrace) break;
        refuse_directive_in_array();
        if (dimension + 1 < array.sizes.size()) {
            read_elements(array, dimension + 1, at);
        } else if (array.gaps && (peek().kind == Kind::Comma || peek().kind == Kind::RightBrace)) {
            if (array.growing) grow(array, at + 1);
            ++at;
            if (peek().kind == Kind::RightBrace) continue;
        } else {
            Value value = read_element(i + 1 == array.sizes[dimension] && !array.growing);
            if (array.growing) grow(array, at + 1);
            if (array.kind == 0) array.kind = kind_of(value);
            if (array.kind != kind_of(value) && !array.mixed)
                fail(last(), fmt::format("the elements of this array are of type {}, this is {}",
                                         type_name(array.elements[0]), type_name(value)));
            array.elements[at++] = std::move(value);
        }
        refuse_directive_in_array();
        accept_comma();
    }
    refuse_directive_in_array();
    expect_closing(fmt::format("'}}' after {} elements", array.sizes[dimension]), "the array", opened);
}

/// An element. Where a function or spline is named without being called and no comma follows it, the name behind it
/// counts in its place, as among a macro's arguments (taken_instead()).
Value TokenStream::read_element(bool is_last)
{
    const Token& first = peek();
    Value value = read_value();
    const bool named = may_go_on(value) && !value.get_if<Tuple>() && last_->kind != Kind::RightBrace;
    if (!named || is_last) return value;
    check_uncalled(value);
    const Cell next = taken_instead(first, value);
    return next ? deep_copy(*next) : value;
}

/// `dictionary { .Key: value, ["Key"]: value }` or the word alone.
std::shared_ptr<Dictionary> TokenStream::read_dictionary()
{
    next();
    const bool raw = std::exchange(raw_operators_, false);
    auto dictionary = std::make_shared<Dictionary>();
    if (peek_raw().kind == Kind::LeftBrace) {
        next();
        while (peek().kind != Kind::RightBrace) {
            const std::string key = read_key();
            expect(Kind::Colon, "':' and the member's value");
            dictionary->members.insert_or_assign(key, std::make_shared<Value>(read_value()));
            accept_comma();
        }
        next();
    }
    raw_operators_ = raw;
    return dictionary;
}

}  // namespace parser
