#include "parser/stream/blocks/compiler.h"

#include "parser/stream/text.h"

namespace parser::blocks {
namespace {

constexpr std::size_t kMostOps = 20'000;  // of one block
constexpr std::uint32_t kMostOpen = 90;   // conditionals and loops inside each other; runner.cpp leaves room for them

}  // namespace

const Value* BlockCompiler::find(std::uint32_t name) const
{
    const auto found = known_.find(name);
    return found != known_.end() ? &found->second : symbols_.find(name);
}

int BlockCompiler::components(std::uint32_t name) const
{
    const auto found = elements_.find(name);
    return found == elements_.end() ? 0 : found->second;
}

bool BlockCompiler::literal(const Token& token, std::string& out) const
{
    const std::string& raw = (*source_.strings)[token.name];
    if (!source_.plain_texts || !is_ascii(raw)) return false;
    for (std::size_t i = 0; i < raw.size(); ++i) {
        const bool escape = raw[i] == '\\';
        if (escape && (i + 1 == raw.size() || escaped(raw[i + 1]) == 0)) return false;
        out += escape ? escaped(raw[++i]) : raw[i];
    }
    return true;
}

void BlockCompiler::sequence(std::uint32_t begin, std::uint32_t end)
{
    root_ = begin;
    program_.registers = kStackRegisters;
    emitter_.let_turn();
    block(begin, end, kNoIndex);
    stop(end, kNoIndex);
}

void BlockCompiler::macro(const Macro& macro)
{
    in_macro_ = true;
    program_.registers = kStackRegisters;
    block(macro.begin, macro.end, kNoIndex);
    emitter_.land(returns_);
    mark(macro.end, kNoIndex);
    emitter_.emit(kReturn);
}

bool BlockCompiler::block(std::uint32_t begin, std::uint32_t end, std::uint32_t place)
{
    const bool deep = place != kNoIndex && program_.places[place].depth > kMostOpen;
    for (std::uint32_t at = begin; at < end;)
        if (deep || program_.ops.size() > kMostOps || !statement(at, end, place)) {
            stop(at, place);
            return false;
        }
    return true;
}

/// Compiles one and goes behind it; false: it is not known, and nothing is left of it.
bool BlockCompiler::statement(std::uint32_t& at, std::uint32_t end, std::uint32_t place)
{
    const std::size_t ops = program_.ops.size(), statements = program_.statements.size(), calls = program_.calls.size();
    std::vector<std::size_t> jumps;
    for (const Leavable& one : open_) jumps.push_back(one.jumps.size());
    const std::size_t returns = returns_.size();
    std::uint32_t behind = at;
    emitter_.clear();
    if (directive(behind, end, place)) {
        at = behind;
        return true;
    }
    program_.ops.resize(ops);
    program_.statements.resize(statements);
    program_.calls.resize(calls);
    open_.resize(jumps.size());
    for (std::size_t i = 0; i < jumps.size(); ++i) open_[i].jumps.resize(jumps[i]);
    returns_.resize(returns);
    emitter_.clear();
    return false;
}

bool BlockCompiler::directive(std::uint32_t& at, std::uint32_t end, std::uint32_t place)
{
    if (kind(at) != Kind::Hash) {
        const Value* const meant = kind(at) == Kind::Identifier ? find(tokens_[at].name) : nullptr;
        const bool call = meant && meant->get_if<std::shared_ptr<const Macro>>();
        return call ? macro_call(at, end, place) : ready_statement(at, end, place);
    }
    if (at + 1 >= end) return false;
    switch (kind(at + 1)) {
    case Kind::Declare:
    case Kind::Local: return declare(at, end, place);
    case Kind::If:
    case Kind::Ifdef:
    case Kind::Ifndef: return if_directive(at, end, place);
    case Kind::While: return while_directive(at, end, place);
    case Kind::For: return for_directive(at, end, place);
    case Kind::Switch: return switch_directive(at, end, place);
    case Kind::Break: return break_directive(at, place);
    case Kind::Read: return read_numbers(at, end, place);
    case Kind::Write: return write_texts(at, end, place);
    default: return false;
    }
}

void BlockCompiler::stop(std::uint32_t at, std::uint32_t place)
{
    mark(at, place);
    emitter_.emit(kStop);
}

void BlockCompiler::mark(std::uint32_t token, std::uint32_t place)
{
    program_.statements.push_back({emitter_.size(), token, place, false});
    emitter_.at_place(place);
}

void BlockCompiler::mark_undoable(std::uint32_t token, std::uint32_t place, std::uint32_t end)
{
    mark(token, place);
    for (std::uint32_t i = token; i < end; ++i)
        if (has_effect(tokens_[i])) {
            program_.statements.back().undo = true;
            emitter_.emit(kBegin);
            return;
        }
}

/// Whether the token may change something before its statement is done: rand() its stream, trace() the normal, a macro
/// anything.
bool BlockCompiler::has_effect(const Token& token) const
{
    if (token.kind != Kind::Identifier) return token.kind == Kind::Rand || token.kind == Kind::Trace;
    const Value* const value = find(token.name);
    return value && value->get_if<std::shared_ptr<const Macro>>();
}

std::uint32_t BlockCompiler::open(std::uint32_t parent, PlaceKind kind, std::uint32_t branch)
{
    Place made;
    made.parent = parent;
    made.kind = kind;
    made.branch = branch;
    made.depth = 1 + (parent == kNoIndex ? 0 : program_.places[parent].depth);
    program_.places.push_back(made);
    return static_cast<std::uint32_t>(program_.places.size() - 1);
}

int BlockCompiler::expression(std::uint32_t& at, std::uint32_t end, const Form& form)
{
    if (at >= end) return 0;
    ExpressionCompiler reader(tokens_, at, end, *this, emitter_);
    const int count = reader.expression(form);
    at = reader.at();
    return count;
}

bool BlockCompiler::text(std::uint32_t& at, std::uint32_t end)
{
    ExpressionCompiler reader(tokens_, at, end, *this, emitter_);
    const bool known = reader.whole_text();
    at = reader.at();
    return known;
}

/// A number on the stack.
bool BlockCompiler::number(std::uint32_t& at, std::uint32_t end, bool full)
{
    return expression(at, end, {1, full, false}) == 1;
}

/// `( number )`
bool BlockCompiler::condition(std::uint32_t& at, std::uint32_t end)
{
    if (at >= end || kind(at) != Kind::LeftParen) return false;
    ++at;
    if (!number(at, end, true) || at >= end || kind(at) != Kind::RightParen) return false;
    ++at;
    return true;
}

/// `( number , number )`
bool BlockCompiler::range_of_case(std::uint32_t& at, std::uint32_t end)
{
    if (at >= end || kind(at) != Kind::LeftParen) return false;
    ++at;
    if (!number(at, end, false) || at >= end || kind(at) != Kind::Comma) return false;
    ++at;
    if (!number(at, end, false) || at >= end || kind(at) != Kind::RightParen) return false;
    ++at;
    return true;
}

/// The test of an `#if`, `#ifdef`, `#ifndef`, `#elseif` whose Hash is given; `at` goes behind it. `jump`: the operation
/// that jumps if it fails.
bool BlockCompiler::test(std::uint32_t hash, std::uint32_t& at, std::uint32_t end, std::uint32_t& jump)
{
    at = hash + 2;
    const Kind word = kind(hash + 1);
    if (word == Kind::If || word == Kind::Elseif) {
        if (!condition(at, end)) return false;
        jump = emitter_.jump_if(false);
        return true;
    }
    if (at + 2 >= end || kind(at) != Kind::LeftParen || kind(at + 1) != Kind::Identifier ||
        kind(at + 2) != Kind::RightParen)
        return false;
    Op& op = emitter_.emit(kSet);
    op.a = emitter_.slot(tokens_[at + 1].name, kAny);
    op.b = word == Kind::Ifndef ? 1 : 0;
    jump = emitter_.size() - 1;
    at += 3;
    return true;
}

}  // namespace parser::blocks
