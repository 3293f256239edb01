#include "parser/stream/expression.h"
#include "parser/stream/function.h"
#include "parser/stream/token_stream.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace parser {
namespace {

constexpr double kSubscriptSlack = 1e-10;       // 0.9999999999999 means 1 (spec of the language 11)
constexpr double kMostElements = 100'000'000;

}  // namespace

void TokenStream::declare(bool local)
{
    std::optional<Deprecation> deprecation;
    if (peek_raw().kind == Kind::Deprecated) deprecation = read_deprecation();
    const Token name = raw_next();
    if (name.kind != Kind::Identifier) fail_expected_at(name, "a name to declare that is no reserved word");
    Cell whole = symbols_.find_cell(name.name);
    if (whole && whole->get_if<std::shared_ptr<const Macro>>())
        fail(place(name), fmt::format("'{}' is a macro", word(name)));
    if (whole && whole->get_if<std::shared_ptr<DataFile>>())
        fail(place(name), fmt::format("'{}' is an open file", word(name)));
    if (whole && whole->get_if<function::FunctionPtr>())
        fail(place(name), fmt::format("'{}' is a function already; #undef it first", word(name)));
    Cell target;
    const bool element = whole && whole->get_if<std::shared_ptr<Array>>() && peek_raw().kind == Kind::LeftSquare;
    std::shared_ptr<Array> array;
    if (element) target = subscripted(whole, name, true, &array);
    if (Token equal = raw_next(); equal.kind != Kind::Equal)
        fail_expected_at(equal, fmt::format("'=' and a value for '{}'", word(name)));

    const std::uint32_t scope = symbols_.depth();
    const std::uint32_t outer = std::exchange(declaring_, whole ? kNoIndex : name.name);
    raw_operators_ = true;
    Value value = read_value();
    raw_operators_ = false;
    declaring_ = outer;
    if (deprecation && !whole) deprecated_[name.name] = std::move(*deprecation);
    const bool numeric = value.get_if<Tuple>() != nullptr;
    if (!target && (!local || symbols_.depth() >= scope)) target = local ? symbols_.local(name.name, scope) : symbols_.declare(name.name);
    if (element && array) set_element(*array, target, std::move(value), name);
    else if (target) *target = std::move(value);
    end_declaration(numeric);
}

Deprecation TokenStream::read_deprecation()
{
    Deprecation deprecation;
    raw_next();
    if (peek_raw().kind == Kind::Once) deprecation.once = raw_next().kind == Kind::Once;
    if (peek_raw().kind == Kind::String) deprecation.message = string_text(raw_next(), false);
    return deprecation;
}

void TokenStream::warn_deprecated(const Token& name)
{
    const auto found = deprecated_.find(name.name);
    if (found == deprecated_.end()) return;
    const std::string& message = found->second.message;
    warn(place(name), message.empty() ? fmt::format("'{}' is deprecated", word(name)) : message);
    if (found->second.once) deprecated_.erase(found);
}

void TokenStream::set_element(Array& array, const Cell& element, Value value, const Token& name)
{
    const std::uint32_t kind = kind_of(value);
    if (array.kind == 0) array.kind = kind;
    if (array.kind != kind)
        fail(place(name), fmt::format("the elements of '{}' are of another type than {}", word(name), type_name(value)));
    *element = std::move(value);
}

void TokenStream::end_declaration(bool numeric)
{
    const bool mandatory = numeric && language_.version >= 350;
    if (peek_raw().kind != Kind::Semicolon) {
        if (mandatory) fail_expected_at(*ahead_, "';' at the end of the declaration");
        if (numeric && language_.version >= 310) warn(place(*ahead_), "the declaration before this should end in ';'");
        return;
    }
    raw_next();
    if (mandatory && peek_raw().kind == Kind::Semicolon) raw_next();
}

void TokenStream::undefine()
{
    const Token name = raw_next();
    if (name.kind != Kind::Identifier) fail_expected_at(name, "the name to forget");
    const Cell whole = symbols_.find_cell(name.name);
    if (whole && whole->get_if<std::shared_ptr<Array>>() && peek_raw().kind == Kind::LeftSquare) {
        *subscripted(whole, name, true) = Value{};
    } else if (!symbols_.undefine(name.name)) {
        warn(place(name), fmt::format("'{}' is not declared, so #undef changes nothing", word(name)));
    }
    end_declaration(false);
}

void TokenStream::set_version()
{
    const scene::SourceRef at = last();
    if (peek_raw().kind == Kind::Identifier && word(*ahead_) == "unofficial") raw_next();
    raw_operators_ = true;
    const double wanted = float_expr(*this);
    raw_operators_ = false;
    const double version = std::floor(100.0 * wanted + 0.5);
    if (!(version <= 370.0)) fail(at, "this scene asks for a later version of the language than 3.7");
    language_.version = static_cast<int>(std::max(version, 0.0));
    language_.version_set = true;
    if (peek_raw().kind != Kind::Semicolon) warn(at, "#version should end in ';'");
    end_declaration(false);
}

Cell TokenStream::subscripted(Cell cell, const Token& name, bool may_create, std::shared_ptr<Array>* innermost)
{
    while (cell->get_if<std::shared_ptr<Array>>()) {
        if (peek_operator().kind != Kind::LeftSquare) break;
        const std::shared_ptr<Array> array = *cell->get_if<std::shared_ptr<Array>>();
        std::size_t index = 0;
        for (const std::uint32_t size : array->sizes) {
            if (!accept(Kind::LeftSquare)) fail_expected("'[' and the next subscript");
            const bool raw = std::exchange(raw_operators_, false);
            const double at = float_expr(*this) + kSubscriptSlack;
            expect(Kind::RightSquare, "']'");
            raw_operators_ = raw;
            if (!(at >= 0.0)) fail(last(), fmt::format("a subscript of '{}' is negative", word(name)));
            if (at >= size)
                fail(last(), fmt::format("a subscript of '{}' is {}, its size there is {}", word(name), std::floor(at), size));
            index = index * size + static_cast<std::size_t>(at);
        }
        cell = Cell(array, &array->elements[index]);
        if (innermost) *innermost = array;
        if (!cell->set()) {
            if (may_create) return cell;
            fail(place(name), fmt::format("this element of '{}' has no value yet", word(name)));
        }
    }
    return cell;
}

Value TokenStream::read_identifier_value(Cell* by_reference)
{
    const Token name = *ahead_;
    Cell cell = symbols_.find_cell(name.name);
    if (!cell) fail_undeclared(name);
    if (cell->get_if<std::shared_ptr<DataFile>>()) fail(place(name), "a file handle is no value");
    next();
    if (cell->get_if<std::shared_ptr<Array>>()) cell = subscripted(cell, name, false);
    if (cell->get_if<function::FunctionPtr>() || cell->get_if<SplinePtr>()) {
        if (peek_operator().kind != Kind::LeftParen) return *cell;
        const Value copy = *cell;  // reading may change what the name stands for
        if (const auto* called = copy.get_if<function::FunctionPtr>())
            return continue_sum(*this, call_function(*this, *called, name, 1), 1);
        return continue_sum(*this, call_spline(*this, **copy.get_if<SplinePtr>(), name), 1);
    }
    if (const Tuple* tuple = cell->get_if<Tuple>()) {
        const std::uint64_t before = taken_;
        const Tuple value = continue_sum(*this, *tuple, 1);
        if (taken_ != before) return value;
    }
    if (by_reference) {
        *by_reference = std::move(cell);
        return {};
    }
    return deep_copy(*cell);
}

Value TokenStream::read_value(Cell* by_reference)
{
    const auto guard = nest();
    if (!by_reference)
        if (Tuple known; run_compiled_here(1, false, known)) return known;
    const Token& token = peek();
    if (token.kind == Kind::Identifier) {
        if (language_.version < 350)  // a declared colour begins a colour, as in `C transmit 0.5`
            if (const Value* value = value_of(token); value && kind_of(*value) == kind_of(Tuple{{}, 5})) return Tuple::of(color_expr(*this));
        return read_identifier_value(by_reference);
    }
    if (at_string(*this)) return string_expr(*this);
    if (lexical_class(token.kind) == LexicalClass::Color) return Tuple::of(color_expr(*this));
    if (at_expression(*this)) return untyped_expr(*this);
    if (token.kind == Kind::Array) return read_array();
    if (token.kind == Kind::Function) return read_function_value(*this);
    if (token.kind == Kind::Spline) return read_spline(*this);
    const bool raw = std::exchange(raw_operators_, false);
    auto value = hooks_.parse_declared_value(*this);
    raw_operators_ = raw;
    if (!value) fail_expected("a value");
    return std::move(*value);
}

std::shared_ptr<Array> TokenStream::read_array()
{
    next();
    const bool raw = std::exchange(raw_operators_, false);
    auto array = std::make_shared<Array>();
    double elements = 1;
    while (array->sizes.size() < 5 && (array->sizes.empty() || peek_raw().kind == Kind::LeftSquare)) {
        expect(Kind::LeftSquare, "'[' and the array's size");
        const double size = std::floor(float_expr(*this) + kSubscriptSlack);
        expect(Kind::RightSquare, "']'");
        elements *= size;
        if (!(size >= 1.0 && elements <= kMostElements)) fail(last(), "this array has no or too many elements");
        array->sizes.push_back(static_cast<std::uint32_t>(size));
    }
    array->elements.resize(static_cast<std::size_t>(elements));
    if (peek_raw().kind == Kind::LeftBrace) {
        std::size_t at = 0;
        read_elements(*array, 0, at);
    }
    raw_operators_ = raw;
    return array;
}

void TokenStream::read_elements(Array& array, std::size_t dimension, std::size_t& at)
{
    expect(Kind::LeftBrace, "'{' and the array's elements");
    for (std::uint32_t i = 0; i < array.sizes[dimension]; ++i) {
        if (dimension + 1 < array.sizes.size()) {
            read_elements(array, dimension + 1, at);
        } else {
            Value value = read_value();
            if (at == 0) array.kind = kind_of(value);
            if (array.kind != kind_of(value))
                fail(last(), fmt::format("the elements of this array are of type {}, this is {}",
                                         type_name(array.elements[0]), type_name(value)));
            array.elements[at++] = std::move(value);
        }
        accept_comma();
    }
    expect(Kind::RightBrace, fmt::format("'}}' after {} elements", array.sizes[dimension]));
}

}  // namespace parser
