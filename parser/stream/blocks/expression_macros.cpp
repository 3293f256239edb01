#include "parser/stream/blocks/expression_compiler.h"

#include <algorithm>
#include <utility>

/// Macros that give a value where they are called.
namespace parser::blocks {

const std::shared_ptr<const Macro>* ExpressionCompiler::macro_at(std::uint32_t at) const
{
    if (at >= limit_ || tokens_[at].kind != Kind::Identifier) return nullptr;
    const Value* const value = meanings_.find(tokens_[at].name);
    return value ? value->get_if<std::shared_ptr<const Macro>>() : nullptr;
}

/// Whether a macro call begins here and is all of a sum.
bool ExpressionCompiler::stands_alone() const
{
    if (!meanings_.texts() || !macro_at(at_) || at_ + 1 >= limit_ || tokens_[at_ + 1].kind != Kind::LeftParen)
        return false;
    const std::uint32_t close = closing_parenthesis(tokens_, at_ + 1, limit_);
    const Kind behind = close + 1 < limit_ ? tokens_[close + 1].kind : Kind::EndOfText;
    return behind == Kind::Semicolon || behind == Kind::Comma || behind == Kind::RightParen ||
           behind == Kind::RightSquare;
}

/// An argument: the same forms as in TokenStream::call_macro. What it needs lies on the stacks.
bool ExpressionCompiler::macro_argument(Argument& out)
{
    const auto ends = [&](std::uint32_t i) {
        return i < limit_ && (tokens_[i].kind == Kind::Comma || tokens_[i].kind == Kind::RightParen);
    };
    const std::uint32_t begin = at_;
    const Value* const meant = kind() == Kind::Identifier ? meanings_.find(tokens_[at_].name) : nullptr;
    const auto* const array = meant ? meant->get_if<std::shared_ptr<Array>>() : nullptr;
    if (meant && ends(at_ + 1)) {
        out.kind = Argument::Kind::Name;
        out.name = tokens_[at_++].name;
        return array || meant->get_if<Tuple>() || meant->get_if<std::string>() ||
               meant->get_if<std::shared_ptr<const scene::Object>>();
    }
    if (array) {  // an element alone is given by reference
        const Emitter::State before = emitter_.state();
        ++at_;
        out.kind = Argument::Kind::Element;
        out.count = static_cast<std::uint8_t>((*array)->sizes.size());
        out.slot = emitter_.slot(tokens_[begin].name, kArray);
        if (out.slot == kNoIndex || !subscripts(out.count)) return false;
        if (ends(at_)) return true;
        emitter_.back_to(before);
        at_ = begin;
    }
    if (begins_text(tokens_[at_], meanings_)) {
        out.kind = Argument::Kind::Text;
        return text() && ends(at_);
    }
    const bool called = macro_at(begin) != nullptr;
    const std::size_t calls = emitter_.calls().size();
    const int count = sum(1);
    if (count < 1 || !ends(at_)) return false;
    if (called && emitter_.calls().size() > calls) {
        const Call& last = emitter_.calls().back();
        if (last.value->named && last.after == at_) return false;
    }
    out.kind = Argument::Kind::Number;
    out.count = static_cast<std::uint8_t>(count);
    return true;
}

/// Behind the macro's name. Texts of the statement around it would lie where the macro puts its own.
int ExpressionCompiler::macro_call(const std::shared_ptr<const Macro>& macro, int requested)
{
    const auto& optional = macro->optional;
    if (!meanings_.texts() || std::find(optional.begin(), optional.end(), true) != optional.end()) return -1;
    Call call;
    call.macro = macro;
    call.token = at_ - 1;
    call.guards = static_cast<std::uint32_t>(nesting_) + 3;
    const ValueCall wanted{macro, {requested, false, brackets_ == 0}, alone_ == call.token};
    if (emitter_.texts() != 0 || ++nesting_ > kDeepestNesting || !take(Kind::LeftParen)) return -1;
    const std::size_t base = emitter_.depth();
    const int brackets = std::exchange(brackets_, 0);
    nesting_ += 2;  // call_macro and read_value are guards, too
    for (std::size_t i = 0; i < macro->parameters.size(); ++i) {
        if (kind() == Kind::RightParen || !macro_argument(call.arguments.emplace_back())) return -1;
        take(Kind::Comma);
    }
    brackets_ = brackets;
    nesting_ -= 3;
    if (!take(Kind::RightParen) || kind() == Kind::LeftSquare || kind() == Kind::LeftParen) return -1;
    call.after = at_;
    call.value = meanings_.value_of(wanted, call.arguments);
    if (!call.value || call.value->result < 1) return -1;
    const int count = call.value->result;
    emitter_.call_value(std::move(call), base, static_cast<std::size_t>(count));
    return count;
}

}  // namespace parser::blocks
