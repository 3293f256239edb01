#include "parser/stream/blocks/compiler.h"

/// Conditionals and loops.
namespace parser::blocks {

/// The branches of a conditional from its Hash to its `#end`, which is the last.
bool BlockCompiler::branches_of(std::uint32_t hash, std::uint32_t end, std::vector<Branch>& out) const
{
    for (std::uint32_t at = hash;;) {
        Branch branch;
        branch.word = kind(at + 1);
        branch.hash = at;
        branch.begin = at + 2;
        if (branch.word == Kind::End) {
            out.push_back(std::move(branch));
            return true;
        }
        branch.end = tokens_[at].jump;
        if (branch.end == kNoIndex || branch.end + 1 >= end) return false;
        const bool last = branch.word == Kind::Else;
        at = branch.end;
        if (last && kind(at + 1) != Kind::End) return false;
        out.push_back(std::move(branch));
    }
}

bool BlockCompiler::if_directive(std::uint32_t& at, std::uint32_t end, std::uint32_t place)
{
    std::vector<Branch> branches;
    if (!branches_of(at, end, branches)) return false;
    const std::uint32_t hash = at, last = branches.back().hash;
    mark_undoable(hash, place, last);
    const bool undo = program_.statements.back().undo;
    std::vector<std::uint32_t> done;
    std::uint32_t failed = kNoIndex;
    for (const Branch& branch : branches) {
        if (branch.word == Kind::End) break;
        if (failed != kNoIndex) {
            emitter_.land(failed);
            program_.statements.push_back({emitter_.size(), hash, place, undo});  // all tests are one statement
            emitter_.clear();
        }
        failed = kNoIndex;
        std::uint32_t begin = branch.begin;
        if (branch.word != Kind::Else && !test(branch.hash, begin, end, failed)) return false;
        block(begin, branch.end, open(place, PlaceKind::If, branch.hash));
        done.push_back(emitter_.size());
        emitter_.emit(kJump);
    }
    if (failed != kNoIndex) emitter_.land(failed);
    emitter_.land(done);
    at = last + 2;
    return true;
}

/// The test of a `#case` or `#range` against the register `value`; jumps to the branch if it is the one.
bool BlockCompiler::case_test(Branch& branch, std::uint32_t end, std::uint32_t value)
{
    branch.begin = branch.hash + 2;
    const bool one = branch.word == Kind::Case;
    if (!(one ? condition(branch.begin, end) : range_of_case(branch.begin, end))) return false;
    if (value == kNoIndex) return emitter_.clear(), true;  // passed by on the way from the branch before it
    const std::uint32_t first = emitter_.in_registers(one ? 1 : 2);
    Op& op = emitter_.emit(one ? kCase : kRange);
    op.a = one ? first : value;
    op.b = one ? value : first;
    branch.jumps.push_back(emitter_.size() - 1);
    emitter_.clear();
    return true;
}

bool BlockCompiler::switch_directive(std::uint32_t& at, std::uint32_t end, std::uint32_t place)
{
    std::vector<Branch> branches;
    if (!branches_of(at, end, branches) || branches.size() < 2) return false;
    const std::uint32_t hash = at, last = branches.back().hash;
    mark_undoable(hash, place, last);
    std::uint32_t behind = hash + 2;
    if (!condition(behind, end) || behind != branches[1].hash) return false;
    const std::uint32_t value = emitter_.keep(1);
    emitter_.move_to(value);
    branches.erase(branches.begin());
    std::vector<std::uint32_t> to_end;
    bool otherwise = false;
    for (Branch& branch : branches) {
        if (branch.word == Kind::End) break;
        if (branch.word == Kind::Else) otherwise = true;
        else if ((branch.word != Kind::Case && branch.word != Kind::Range) || !case_test(branch, end, value))
            return false;
    }
    Branch& unmatched = branches[branches.size() - (otherwise ? 2 : 1)];
    unmatched.jumps.push_back(emitter_.size());
    emitter_.emit(kJump);
    open_.push_back({place, {}});
    std::uint32_t before = kNoIndex;
    for (Branch& branch : branches) {
        if (branch.word == Kind::End) {
            emitter_.land(branch.jumps);
            break;
        }
        if (before != kNoIndex && branch.word != Kind::Else) {  // falling through, the test is still made
            emitter_.clear();
            mark_undoable(branch.hash, before, branch.end);
            Branch passed = branch;
            if (!case_test(passed, end, kNoIndex)) return false;
        }
        emitter_.land(branch.jumps);
        before = open(place, PlaceKind::Switch, branch.hash);
        block(branch.begin, branch.end, before);
    }
    land_breaks();
    at = last + 2;
    return true;
}

/// Every `#break` of the innermost loop or `#switch` leads here, which is behind it.
void BlockCompiler::land_breaks()
{
    emitter_.land(open_.back().jumps);
    open_.pop_back();
}

/// The Hash of the `#end` of the loop that begins at one; kNoIndex: it is not in the text.
std::uint32_t BlockCompiler::end_of_loop(std::uint32_t hash, std::uint32_t end) const
{
    const std::uint32_t closing = tokens_[hash].jump;
    return closing != kNoIndex && closing + 1 < end && kind(closing + 1) == Kind::End ? closing : kNoIndex;
}

bool BlockCompiler::while_directive(std::uint32_t& at, std::uint32_t end, std::uint32_t place)
{
    const std::uint32_t hash = at, closing = end_of_loop(hash, end);
    if (closing == kNoIndex) return false;
    std::uint32_t body = hash + 2;
    if (kind(body) == Kind::LeftParen && kind(body + 1) == Kind::Defined) return while_defined(at, place, closing);
    mark_undoable(hash, place, closing);
    if (!condition(body, closing)) return false;
    const std::vector<std::uint32_t> done = {emitter_.jump_if(false)};
    const auto [inside, first] = while_body(hash, body, closing, place);
    mark_undoable(closing, inside, closing);
    for (std::uint32_t i = hash; i < body; ++i)
        if (has_effect(tokens_[i]) && !program_.statements.back().undo) {
            program_.statements.back().undo = true;
            emitter_.emit(kBegin);
        }
    emitter_.clear();
    std::uint32_t again = hash + 2;
    if (!condition(again, closing)) return false;
    end_while(emitter_.jump_if(true), first, done);
    at = closing + 2;
    return true;
}

/// What `#while` repeats: its place, and its first operation.
std::pair<std::uint32_t, std::uint32_t> BlockCompiler::while_body(std::uint32_t hash, std::uint32_t body,
                                                                  std::uint32_t closing, std::uint32_t place)
{
    const std::uint32_t inside = open(place, PlaceKind::While, hash);
    program_.places[inside].again = hash + 2;
    return {inside, repeated(hash, body, closing, inside)};
}

/// What a loop repeats, in a place that is open now. Returns its first operation.
std::uint32_t BlockCompiler::repeated(std::uint32_t hash, std::uint32_t body, std::uint32_t closing,
                                      std::uint32_t inside)
{
    open_.push_back({inside, {}});
    const std::uint32_t first = emitter_.size();
    mark(body, inside);
    emitter_.emit(kSpend).a = closing - hash;
    block(body, closing, inside);
    if (hash == root_) program_.again = emitter_.size();
    return first;
}

/// The operation `back` goes to the first of the loop again; what left it goes on behind.
void BlockCompiler::end_while(std::uint32_t back, std::uint32_t first, const std::vector<std::uint32_t>& left)
{
    program_.ops[back].jump = static_cast<std::int32_t>(first) - static_cast<std::int32_t>(back);
    emitter_.land(left);
    land_breaks();
}

/// `#while (defined(NAME))`
bool BlockCompiler::while_defined(std::uint32_t& at, std::uint32_t place, std::uint32_t closing)
{
    const std::uint32_t hash = at, name = hash + 5, body = name + 3;
    const bool plain = body <= closing && kind(hash + 4) == Kind::LeftParen && kind(name) == Kind::Identifier &&
                       kind(name + 1) == Kind::RightParen && kind(name + 2) == Kind::RightParen;
    if (!plain) return false;
    const auto test = [&](bool sense) {
        Op& op = emitter_.emit(kSet);
        op.a = emitter_.slot(tokens_[name].name, kAny);
        op.b = sense ? 1 : 0;
        return emitter_.size() - 1;
    };
    mark(hash, place);
    const std::vector<std::uint32_t> done = {test(false)};
    const auto [inside, first] = while_body(hash, body, closing, place);
    mark(closing, inside);
    emitter_.clear();
    end_while(test(true), first, done);
    at = closing + 2;
    return true;
}

bool BlockCompiler::for_directive(std::uint32_t& at, std::uint32_t end, std::uint32_t place)
{
    const std::uint32_t hash = at, closing = end_of_loop(hash, end);
    if (closing == kNoIndex) return false;
    mark_undoable(hash, place, closing);
    std::uint32_t body = hash + 2;
    if (kind(body) != Kind::LeftParen || kind(body + 1) != Kind::Identifier || kind(body + 2) != Kind::Comma)
        return false;
    const std::uint32_t name = tokens_[body + 1].name;
    body += 3;
    const std::uint32_t kept = emitter_.keep(3);
    for (std::uint32_t i = 0; i < 3; ++i) {
        if (i < 2 || kind(body) != Kind::RightParen) {
            if (!number(body, closing, false)) return false;
            if (kind(body) != Kind::RightParen && kind(body) != Kind::Comma) return false;
            if (kind(body) == Kind::Comma) ++body;
            emitter_.move_to(kept + i);
        } else {
            Op& one = emitter_.emit(move_handler(Operand::Constant, Target::Register));
            one.to = kept + i;
            one.number = 1.0;
        }
    }
    if (kind(body) != Kind::RightParen) return false;
    ++body;
    if (!may_declare(name, Value(Tuple::of(0.0)), true)) return false;
    const std::uint32_t variable = emitter_.slot(name, kFloat);
    if (variable == kNoIndex) return false;
    know(name, Value(Tuple::of(0.0)), true);
    Op& begin = emitter_.emit(kForBegin);
    begin.a = variable;
    begin.b = kept;
    const std::vector<std::uint32_t> done = {emitter_.size() - 1};
    const std::uint32_t inside = open(place, PlaceKind::For, hash);
    program_.places[inside].again = body;
    program_.places[inside].name = name;
    program_.places[inside].limit = kept + 1;
    const std::uint32_t first = repeated(hash, body, closing, inside);
    mark(closing, inside);
    Op& next = emitter_.emit(kForNext);
    next.a = variable;
    next.b = kept + 1;
    next.jump = static_cast<std::int32_t>(first) - static_cast<std::int32_t>(emitter_.size() - 1);
    emitter_.land(done);
    land_breaks();
    at = closing + 2;
    return true;
}

bool BlockCompiler::break_directive(std::uint32_t& at, std::uint32_t place)
{
    if (open_.empty() && !in_macro_) return false;
    mark(at, place);
    (open_.empty() ? returns_ : open_.back().jumps).push_back(emitter_.size());
    emitter_.emit(kJump);
    at += 2;
    return true;
}

}  // namespace parser::blocks
