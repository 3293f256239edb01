#include "parser/stream/expressions/compiler.h"
#include "parser/stream/language_state.h"

#include <algorithm>
#include <utility>

/// Macros that give a value where they are called.
namespace parser {

const std::shared_ptr<const Macro>* Compiler::macro_at(std::uint32_t at) const
{
    if (at >= limit_ || tokens_[at].kind != Kind::Identifier) return nullptr;
    const Value* const value = meanings_.find(tokens_[at].name);
    return value ? value->get_if<std::shared_ptr<const Macro>>() : nullptr;
}

/// Whether a macro call begins here and is all of a sum.
bool Compiler::stands_alone() const
{
    if (!meanings_.texts() || !macro_at(at_) || at_ + 1 >= limit_ || tokens_[at_ + 1].kind != Kind::LeftParen)
        return false;
    std::uint32_t at = at_ + 1;
    for (int open = 0; at < limit_; ++at) {
        open += tokens_[at].kind == Kind::LeftParen ? 1 : tokens_[at].kind == Kind::RightParen ? -1 : 0;
        if (open == 0) break;
    }
    const Kind behind = at + 1 < limit_ ? tokens_[at + 1].kind : Kind::EndOfText;
    return behind == Kind::Semicolon || behind == Kind::Comma || behind == Kind::RightParen ||
           behind == Kind::RightSquare;
}

/// An argument: the same forms as in TokenStream::call_macro. What it needs lies on the stacks.
bool Compiler::macro_argument(CompiledArgument& out)
{
    const auto ends = [&](std::uint32_t i) {
        return i < limit_ && (tokens_[i].kind == Kind::Comma || tokens_[i].kind == Kind::RightParen);
    };
    const std::uint32_t begin = at_;
    const Value* const meant = kind() == Kind::Identifier ? meanings_.find(tokens_[at_].name) : nullptr;
    const auto* const array = meant ? meant->get_if<std::shared_ptr<Array>>() : nullptr;
    if (meant && ends(at_ + 1)) {
        out.kind = CompiledArgument::Kind::Name;
        out.name = tokens_[at_++].name;
        return array || meant->get_if<Tuple>() || meant->get_if<std::string>() ||
               meant->get_if<std::shared_ptr<const scene::Object>>();
    }
    if (array) {  // an element alone is given by reference
        const std::size_t ops = out_.ops.size();
        const int depth = depth_;
        ++at_;
        out.kind = CompiledArgument::Kind::Element;
        out.count = static_cast<std::uint8_t>((*array)->sizes.size());
        out.name = tokens_[begin].name;
        for (std::size_t i = 0; i < out.count; ++i)
            if (!take(Kind::LeftSquare) || !number() || !take(Kind::RightSquare)) return false;
        if (ends(at_)) return true;
        out_.ops.resize(ops);
        depth_ = depth;
        at_ = begin;
    }
    if (begins_text(tokens_[at_], meanings_)) {
        out.kind = CompiledArgument::Kind::Text;
        return text() && ends(at_);
    }
    const bool called = macro_at(begin) != nullptr;
    const std::size_t calls = out_.calls.size();
    const int count = sum(1);
    if (count < 1 || !ends(at_)) return false;
    if (called && out_.calls.size() > calls && out_.calls.back().named && out_.calls.back().after == at_) return false;
    out.kind = CompiledArgument::Kind::Number;
    out.count = static_cast<std::uint8_t>(count);
    return true;
}

/// Behind the macro's name.
int Compiler::macro_call(const std::shared_ptr<const Macro>& macro, int requested)
{
    const auto& optional = macro->optional;
    if (!meanings_.texts() || std::find(optional.begin(), optional.end(), true) != optional.end()) return -1;
    CompiledCall call;
    call.macro = macro;
    call.token = at_ - 1;
    call.guards = static_cast<std::uint32_t>(nesting_) + 3;
    call.requested = requested;
    call.raw = brackets_ == 0;
    call.alone = alone_ == call.token;
    if (text_depth_ != 0 || ++nesting_ > kDeepestNesting || !take(Kind::LeftParen)) return -1;
    const int base = depth_, brackets = std::exchange(brackets_, 0);
    nesting_ += 2;  // call_macro and read_value are guards, too
    for (std::size_t i = 0; i < macro->parameters.size(); ++i) {
        if (kind() == Kind::RightParen || !macro_argument(call.arguments.emplace_back())) return -1;
        take(Kind::Comma);
    }
    brackets_ = brackets;
    nesting_ -= 3;
    if (!take(Kind::RightParen) || kind() == Kind::LeftSquare || kind() == Kind::LeftParen) return -1;
    call.after = at_;
    const int count = meanings_.value_of(call);
    if (count < 1) return -1;
    text_depth_ = 0;
    CompiledOp& op = emit(Code::MacroCall, base + count - depth_);
    op.name = static_cast<std::uint32_t>(out_.calls.size());
    op.a = static_cast<std::uint8_t>(count);
    out_.calls.push_back(std::move(call));
    return too_deep_ ? -1 : count;
}

}  // namespace parser
