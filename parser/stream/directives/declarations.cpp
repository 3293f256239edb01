#include "parser/stream/expression.h"
#include "parser/stream/functions/function.h"
#include "parser/stream/token_stream.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace parser {
/// What a declaration writes to, up to the '='.
DeclarationTarget TokenStream::read_declaration_target()
{
    DeclarationTarget target;
    const Token& name = target.name;
    Cell cell;
    if (at_pseudo_scope() != Kind::EndOfText) {
        const Kind scope = read_pseudo_name(target.name);
        target.global = scope == Kind::Global;
        target.local = !target.global;
        cell = in_scope(scope, name.name);
    } else {
        target.name = raw_next();
        if (name.kind != Kind::Identifier) fail_expected_at(name, "a name to declare that is no reserved word");
    }
    const Value* whole = target.global || target.local ? cell.get() : symbols_.find(name.name);
    target.known = whole != nullptr;
    if (!whole || whole->get_if<Tuple>()) return target;
    if (whole->get_if<std::shared_ptr<const Macro>>()) fail(place(name), fmt::format("'{}' is a macro", word(name)));
    if (whole->get_if<std::shared_ptr<DataFile>>()) fail(place(name), fmt::format("'{}' is an open file", word(name)));
    if (whole->get_if<function::FunctionPtr>())
        fail(place(name), fmt::format("'{}' is a function already; #undef it first", word(name)));
    const Kind next = is_container(*whole) ? peek_raw().kind : Kind::EndOfText;
    if (next == Kind::LeftSquare || next == Kind::Period)
        target.element = subscripted(cell ? cell : symbols_.find_cell(name.name), name, true, &target.array);
    return target;
}

void TokenStream::store(const DeclarationTarget& target, Value value, bool local, std::uint32_t scope)
{
    const std::uint32_t name = target.name.name;
    if (target.element && target.array)
        return set_element(*target.array, target.element, std::move(value), target.name);
    if (target.element) {
        *target.element = std::move(value);
    } else if (target.global) {
        *symbols_.global(name) = std::move(value);
    } else if (local || target.local) {
        if (symbols_.depth() >= scope) *symbols_.local(name, scope) = std::move(value);
    } else {
        *symbols_.declare(name) = std::move(value);
    }
}

void TokenStream::declare(bool local)
{
    std::optional<Deprecation> deprecation;
    if (peek_raw().kind == Kind::Deprecated) deprecation = read_deprecation();
    if (peek_raw().kind == Kind::LeftParen || ahead_->kind == Kind::LeftBrace) return declare_several(local);
    const std::uint32_t scope = symbols_.depth();
    const DeclarationTarget target = read_declaration_target();
    if (Token equal = raw_next(); equal.kind != Kind::Equal)
        fail_expected_at(equal, fmt::format("'=' and a value for '{}'", word(target.name)));

    const std::uint32_t outer = std::exchange(declaring_, target.known ? kNoIndex : target.name.name);
    raw_operators_ = true;
    Value value = read_value();
    raw_operators_ = false;
    declaring_ = outer;
    if (deprecation && !target.known) deprecated_[target.name.name] = std::move(*deprecation);
    const bool numeric = may_go_on(value) && last_->kind != Kind::RightBrace;  // else a function's or spline's own text
    store(target, std::move(value), local, scope);
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
    Token name;
    if (at_pseudo_scope() != Kind::EndOfText) read_pseudo_name(name);
    else name = raw_next();
    if (name.kind != Kind::Identifier) fail_expected_at(name, "the name to forget");
    const Cell whole = symbols_.find_cell(name.name);
    const Kind behind = whole && is_container(*whole) ? peek_raw().kind : Kind::EndOfText;
    if (behind == Kind::LeftSquare || behind == Kind::Period) {
        *subscripted(whole, name, true) = Value{};
    } else if (!symbols_.undefine(name.name)) {
        warn(place(name), fmt::format("'{}' is not declared, so #undef changes nothing", word(name)));
    }
    end_declaration(false);
}

/// Whether the scene, or the header that goes ahead of it, begins with the directive at `hash`.
bool TokenStream::nothing_before(std::uint32_t hash) const
{
    const std::size_t first = options_.include_header.empty() ? 1 : 2;  // depth of what is read first
    return hash == 0 && cursors_.size() == first && (first == 1 || cursors_.front().position == 0);
}

void TokenStream::set_version(std::uint32_t hash)
{
    const scene::SourceRef at = last();
    if (!language_.version_directive && !nothing_before(hash)) language_.late_version = at;
    language_.version_directive = true;
    if (peek_raw().kind == Kind::Identifier && word(*ahead_) == "unofficial") raw_next();
    raw_operators_ = true;
    const double wanted = float_expr(*this);
    raw_operators_ = false;
    const double version = std::floor(100.0 * wanted + 0.5);
    constexpr double kLatest = 380.0, kPatched = 371.0;
    if (!(version <= kLatest)) fail(at, "this scene asks for a later version of the language than 3.8");
    if (version >= kPatched && version < kLatest) warn(at, "this version has the words of 3.8, but it is not 3.8");
    language_.version = static_cast<int>(std::max(version, 0.0));
    language_.version_set = true;
    const bool in_scene = cursors_.back().file == 0;  // an include may restore a version that it was not drawn with
    if (in_scene && version >= kPatched && !options_.povray) language_.povray = scene::PovRay::V38;
    hooks_.version_changed(language_.version, options_);
    if (peek_raw().kind != Kind::Semicolon) warn(at, "#version should end in ';'");
    end_declaration(false);
}

Value TokenStream::read_identifier_value(Named* named)
{
    const bool plain = ahead_->kind == Kind::Identifier;
    Token name = *ahead_;
    Cell cell = plain ? symbols_.find_cell(name.name) : take_name(name);
    if (!cell) fail_undeclared(name);
    if (cell->get_if<std::shared_ptr<DataFile>>()) fail(place(name), "a file handle is no value");
    const std::uint32_t scope = symbols_.scope_of(name.name);
    if (plain) next();
    if (is_container(*cell)) cell = subscripted(cell, name, false);
    if (cell->get_if<function::FunctionPtr>() || cell->get_if<SplinePtr>()) {
        const Value copy = *cell;  // reading may change what the name stands for
        if (peek_operator().kind != Kind::LeftParen) {
            if (!named) return copy;
            *named = {copy.get_if<SplinePtr>() ? std::move(cell) : make_cell(copy), scope};
            return {};
        }
        if (const auto* called = copy.get_if<function::FunctionPtr>())
            return continue_sum(*this, call_function(*this, *called, name, 1), 1);
        return continue_sum(*this, call_spline(*this, **copy.get_if<SplinePtr>(), name), 1);
    }
    if (const Tuple* tuple = cell->get_if<Tuple>()) {
        const std::uint64_t before = taken_;
        const Tuple value = continue_sum(*this, *tuple, 1);
        if (taken_ != before) return value;
    }
    if (named) {
        *named = {std::move(cell), scope};
        return {};
    }
    return deep_copy(*cell);
}

Value TokenStream::read_value(Named* named)
{
    Value value = read_any_value(named);
    if (Tuple* tuple = value.get_if<Tuple>()) *tuple = tuple->stored();
    return value;
}

Value TokenStream::read_any_value(Named* named)
{
    const auto guard = nest();
    if (!named)
        if (Tuple known; run_compiled_here(1, false, known)) return known;
    const Token& token = peek();
    if (token.kind != Kind::Identifier && at_pseudo_scope() != Kind::EndOfText) return read_identifier_value(named);
    if (token.kind == Kind::Identifier) {
        if (language_.version < 350)  // a declared colour begins a colour, as in `C transmit 0.5`
            if (const Value* value = value_of(token); value && kind_of(*value) == kind_of(Tuple{{}, 5}))
                return Tuple::of(color_expr(*this));
        return read_identifier_value(named);
    }
    if (at_string(*this)) return string_expr(*this);
    if (lexical_class(token.kind) == LexicalClass::Color) return Tuple::of(color_expr(*this));
    if (at_expression(*this)) return untyped_expr(*this);
    if (token.kind == Kind::Array) return read_array();
    if (token.kind == Kind::Dictionary) return read_dictionary();
    if (token.kind == Kind::Function) return read_function_value(*this);
    if (token.kind == Kind::Spline) return read_spline(*this);
    const bool raw = std::exchange(raw_operators_, false);
    auto value = hooks_.parse_declared_value(*this);
    raw_operators_ = raw;
    if (!value) fail_expected("a value");
    return std::move(*value);
}

}  // namespace parser
