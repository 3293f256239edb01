#include "parser/stream/blocks/compiler.h"

/// Macros that give a value: directives, and then a number or vector at the end of the body or of each branch.
namespace parser::blocks {

const Program* BlockCompiler::value_of(const ValueCall& call, const std::vector<Argument>& arguments) const
{
    constexpr std::uint32_t kWithoutValues = 3;  // the last attempt at a block that is left again and again
    if (program_.attempt >= kWithoutValues) return nullptr;
    Known known = known_;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const Argument& one = arguments[i];
        const std::uint32_t parameter = call.macro->parameters[i];
        const Value* const meant = one.kind == Argument::Kind::Name ? find(one.name) : nullptr;
        if (meant) known.insert_or_assign(parameter, *meant);
        else if (one.kind == Argument::Kind::Text) known.insert_or_assign(parameter, Value(std::string()));
        else if (one.kind == Argument::Kind::Number) known.insert_or_assign(parameter, Value(Tuple{{}, one.count}));
        else known.insert_or_assign(parameter, Value(Tuple::of(0.0)));
    }
    return library_.value_of(call, known);
}

bool BlockCompiler::value(const ValueCall& call, Known known)
{
    known_ = std::move(known);
    in_macro_ = gives_value_ = true;
    program_.registers = kStackRegisters;
    program_.named = true;  // as long as it is not known
    if (!value_block(call.macro->begin, call.macro->end, kNoIndex, call) || !returns_.empty()) return false;
    program_.named = named_;
    return true;
}

/// Directives and a value behind them.
bool BlockCompiler::value_block(std::uint32_t begin, std::uint32_t end, std::uint32_t place, const ValueCall& call)
{
    for (std::uint32_t at = begin; at < end;) {
        if (kind(at) != Kind::Hash) return value_at(at, end, place, call);
        const Kind word = kind(at + 1);
        if (word == Kind::If || word == Kind::Ifdef || word == Kind::Ifndef) {
            std::vector<Branch> branches;
            if (!branches_of(at, call.macro->end, branches)) return false;
            if (branches.back().hash + 2 == end) return !call.form.raw && value_branches(at, end, place, call);
        }
        if (!statement(at, end, place)) return false;
    }
    return false;
}

bool BlockCompiler::value_branches(std::uint32_t hash, std::uint32_t end, std::uint32_t place, const ValueCall& call)
{
    std::vector<Branch> branches;
    if (!branches_of(hash, call.macro->end, branches) || branches[branches.size() - 2].word != Kind::Else) return false;
    mark(hash, place);
    for (const Branch& branch : branches) {
        if (branch.word == Kind::End) break;
        std::uint32_t begin = branch.begin, failed = kNoIndex;
        emitter_.clear();
        if (branch.word != Kind::Else && !test(branch.hash, begin, end, failed)) return false;
        if (!value_block(begin, branch.end, open(place, PlaceKind::If, branch.hash), call)) return false;
        if (failed != kNoIndex) emitter_.land(failed);
        mark(hash, place);
    }
    return true;
}

/// One operand, or a sum where nothing stands around the call; then the macro ends, or the branch.
bool BlockCompiler::value_at(std::uint32_t begin, std::uint32_t end, std::uint32_t place, const ValueCall& call)
{
    mark(begin, place);
    emitter_.clear();
    ExpressionCompiler reader(tokens_, begin, end + 1, *this, emitter_);
    const int count = call.alone ? reader.expression({call.form.requested, false, true})
                                 : reader.operand(call.form.requested);
    if (count == 0 || reader.at() != end || (count != program_.result && program_.result != 0)) return false;
    program_.result = count;
    named_ = named_ || kind(begin) == Kind::Identifier;
    const std::uint32_t first = emitter_.in_registers(static_cast<std::size_t>(count));
    Op& op = emitter_.emit(kGive);
    op.a = first;
    op.b = static_cast<std::uint32_t>(count);
    emitter_.clear();
    return true;
}

}  // namespace parser::blocks
