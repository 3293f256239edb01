#include "parser/stream/blocks/runner.h"

#include "parser/stream/blocks/compiler.h"
#include "parser/stream/limits.h"
#include "parser/stream/token_stream.h"

#include <algorithm>
#include <utility>

namespace parser::blocks {
namespace {

constexpr std::uint32_t kMostAttempts = 4;  ///< at compiling a block again where it is left early
constexpr std::uint32_t kMostStops = 3;     ///< before it is compiled again

const Statement& statement_at(const Program& program, const Op* op)
{
    const auto index = static_cast<std::uint32_t>(op - program.ops.data());
    const auto behind = std::upper_bound(program.statements.begin(), program.statements.end(), index,
                                         [](std::uint32_t i, const Statement& one) { return i < one.op; });
    return *(behind - 1);
}

}  // namespace

Runner::Runner(TokenStream& stream)
    : stream_(stream), machine_(stream.symbols_, stream.random_undo_, stream.hooks_, *this),
      alone_(stream.symbols_, stream.random_undo_, stream.hooks_, *this)
{
    machine_.texts.resize(kTextRegisters);
}

bool Runner::usable() const
{
    constexpr int kFirstVersion = 350;
    return stream_.options_.blocks && stream_.deprecated_.empty() && stream_.language_.version >= kFirstVersion;
}

std::uint32_t* Runner::sites_in(Sites& all, std::uint16_t file) const
{
    if (file >= all.size()) all.resize(file + 1u);
    if (all[file].empty()) all[file].resize(stream_.files_[file]->tokens.size());
    return all[file].data();
}

Source Runner::source_of(std::uint16_t file) const
{
    const SourceFile& in = *stream_.files_[file];
    return {in.tokens.data(), &in.strings, &in.numbers, stream_.language_.charset != Charset::System};
}

Program& Runner::compile(std::uint32_t attempt)
{
    Program& made = *programs_.emplace_back(std::make_unique<Program>());
    made.attempt = attempt;
    made.version = stream_.language_.version;
    made.povray = stream_.povray();
    return made;
}

/// The program that begins at a Hash, null: there is none (yet).
Program* Runner::program_at(std::uint32_t& site, std::uint32_t hash)
{
    std::uint32_t attempt = 0;
    if (site >= kFirst) {
        Program& known = *programs_[site - kFirst];
        if (known.version == stream_.language_.version && !found_wanting(known)) return &known;
        attempt = known.attempt + 1;
    } else if (site != kSeen) {
        if (site == kUnseen) site = kSeen;
        return nullptr;
    }
    site = kNever;
    const Cursor& cursor = stream_.cursors_.back();
    const SourceFile& file = *stream_.files_[cursor.file];
    std::uint32_t end = cursor.end;
    if (stream_.blocks_.empty() || !stream_.blocks_.back().repeats) {
        end = file.tokens[hash].jump + 2;  // a loop in text that is read once
    } else if (stream_.blocks_.back().cursors == stream_.cursors_.size()) {
        end = std::min(end, file.tokens[stream_.blocks_.back().branch].jump);
    }
    if (end <= hash || end > cursor.end) return nullptr;
    for (const std::uint32_t bad : file.bad)
        if (bad >= hash && bad < end) return nullptr;
    const auto index = static_cast<std::uint32_t>(programs_.size());  // macros may be compiled on the way
    Program& made = compile(attempt);
    BlockCompiler(source_of(cursor.file), stream_.symbols_, *this, made).sequence(hash, end);
    if (made.ops.front().run == kStop) return nullptr;
    site = index + kFirst;
    return &made;
}

/// It was left early so often that it is worth another attempt: names may have got a meaning since.
bool Runner::found_wanting(Program& program) const
{
    return program.stops > kMostStops && program.attempt + 1 < kMostAttempts;
}

const Program& Runner::program_of(const Call& call)
{
    const int version = stream_.language_.version;
    if (call.body && call.body->version == version && !found_wanting(*call.body)) return *call.body;
    Program*& known = macros_[call.macro.get()];
    const bool stale = known && known->version != version;
    if (!known || stale || found_wanting(*known)) {
        Program& made = compile(known && !stale ? known->attempt + 1 : 0);
        BlockCompiler(source_of(call.macro->file), stream_.symbols_, *this, made).macro(*call.macro);
        known = &made;
    }
    call.body = known;
    return *known;
}

/// By macro, form of the call and types of the arguments.
const Program* Runner::value_of(const ValueCall& call, const Known& known)
{
    std::string form = {static_cast<char>('0' + call.form.requested), call.form.raw ? 'r' : '-',
                        call.alone ? 'a' : '-'};
    for (const std::uint32_t parameter : call.macro->parameters) {
        const Value& sample = known.at(parameter);
        const auto* const array = sample.get_if<std::shared_ptr<Array>>();
        form += static_cast<char>('0' + kind_of(sample) % 64);
        if (array) form += static_cast<char>('0' + (*array)->sizes.size());
    }
    ValueProgram& kept = values_[call.macro.get()][form];
    const bool stale = kept.program && kept.program->version != stream_.language_.version;
    if (kept.program && !stale && (kept.at_work || kept.program->result != 0)) {
        if (kept.at_work && kept.program->result == 0)
            kept.program->result = 1;  // most macros that call themselves give a number
        return kept.program;
    }
    if (kept.failures >= kMostAttempts) return nullptr;
    Program& made = compile(0);
    kept = {&made, true, kept.failures};
    const bool good = stream_.files_[call.macro->file]->bad.empty() &&
                      BlockCompiler(source_of(call.macro->file), stream_.symbols_, *this, made).value(call, known);
    kept.at_work = false;
    if (good) return &made;
    ++kept.failures;
    made.result = 0;
    return nullptr;
}

std::unique_ptr<ReadyStatement> Runner::prepare(StatementReader& reader)
{
    return machine_.statements ? stream_.hooks_.prepare(reader) : nullptr;
}

/// The loop that was entered and the calls in it; loops inside of them count as theirs.
void Runner::spend_time()
{
    open_.clear();
    if (loop_ != kNoIndex) open_.push_back({ReadingProfile::What::Loop, stream_.cursors_.back().file, loop_});
    for (const Frame& frame : machine_.frames)
        if (frame.call)
            open_.push_back({ReadingProfile::What::Macro, frame.call->macro->file, frame.call->macro->name});
    stream_.spend_time(open_);
}

std::int64_t Runner::more()
{
    spend_time();
    constexpr std::uint64_t kShareOfBlocks = 1 << 14;  // numbers only: they take a millisecond
    if (stream_.options_.cancel && *stream_.options_.cancel) return 0;
    const std::uint64_t share = std::min(kShareOfBlocks, stream_.later_);
    stream_.later_ -= share;
    return static_cast<std::int64_t>(share);
}

bool Runner::at_directive(std::uint32_t hash)
{
    if (!usable()) return false;
    machine_.statements = std::exchange(expected_, false);
    std::uint32_t& here = site(stream_.cursors_.back().file, hash);
    Program* const program = here == kNever ? nullptr : program_at(here, hash);
    loop_ = program && program->again != kNoIndex ? hash : kNoIndex;
    return program && run(*program, here, 0, hash);
}

bool Runner::at_end_of_pass(std::uint32_t hash_of_end)
{
    if (!usable()) return false;
    machine_.statements = std::exchange(expected_, false);
    const Block loop = stream_.blocks_.back();
    if (loop.cursors != stream_.cursors_.size() || loop.file != stream_.cursors_.back().file) return false;
    std::uint32_t& here = site(loop.file, loop.branch);
    if (here == kNever) return false;
    const auto& tokens = stream_.files_[loop.file]->tokens;
    if (tokens[loop.branch].jump != hash_of_end) return false;
    const bool counts = loop.kind == BlockKind::For;
    if (counts) {
        const std::uint32_t name = tokens[loop.branch + 3].name;  // # for ( name
        if (!stream_.symbols_.in_current_scope(name) || stream_.symbols_.find(name) != loop.variable.get())
            return false;
    }
    stream_.blocks_.pop_back();
    Program* const program = program_at(here, loop.branch);
    if (!program || program->again == kNoIndex) {
        stream_.blocks_.push_back(loop);
        return false;
    }
    loop_ = loop.branch;
    machine_.enter(*program, stream_.symbols_.depth());
    if (counts) {
        const Place& place = program->places[statement_at(*program, &program->ops[program->again]).place];
        machine_.registers[place.limit] = loop.limit;
        machine_.registers[place.limit + 1] = loop.step;
    }
    return run(*program, here, program->again, hash_of_end);
}

/// False: it was left where it was entered.
bool Runner::run(Program& program, std::uint32_t& site, std::uint32_t op, std::uint32_t entered_at)
{
    constexpr std::size_t kRoom = 100;  // for the conditionals and loops of the block itself
    const std::size_t cursors = stream_.cursors_.size();
    if (op == 0) machine_.enter(program, stream_.symbols_.depth());
    machine_.most_frames = cursors < kDeepestCalls ? kDeepestCalls - cursors : 0;
    machine_.blocks = stream_.blocks_.size();
    machine_.most_blocks = kMostBlocks - kRoom;
    machine_.budget = static_cast<std::int64_t>(std::min<std::uint64_t>(stream_.left_, 1 << 20));
    const std::int64_t unused = static_cast<std::int64_t>(stream_.left_) - machine_.budget;
    machine_.calls = 0;
    machine_.values = 0;
    machine_.guards = static_cast<std::uint32_t>(stream_.nesting_) + 1;
    machine_.most_guards = static_cast<std::uint32_t>(kMostNesting);
    machine_.notes.clear();
    stream_.random_undo_.keep();
    machine_.run(program.ops.data() + op);

    program.stops += machine_.values != 0 ? 1 : 0;
    if (machine_.values != 0) machine_.undo_values();
    Program& last = const_cast<Program&>(*machine_.frame().program);
    const Statement& left = statement_at(last, machine_.stopped);
    if (left.undo) machine_.undo_changes();
    const bool stuck = machine_.frames.size() == 1 && left.token == entered_at;
    const bool ended = machine_.frames.size() == 1 && &left == &program.statements.back();
    last.stops += ended ? 0 : 1;
    if (stuck && program.stops > 4 * kMostStops && program.attempt + 1 >= kMostAttempts) site = kNever;
    put_back(left.token, left.place);
    if (stuck) {  // behind the word, as the reader of tokens stands when it begins with it
        stream_.cursors_.back().position = entered_at + 2;
        stream_.last_ = &stream_.cursors_.back().tokens[entered_at + 1];
    }
    stream_.statistics_.macro_calls += machine_.calls;
    if (machine_.frames.size() == 1 && left.token > entered_at) machine_.budget -= left.token - entered_at;
    stream_.left_ = static_cast<std::uint64_t>(std::max<std::int64_t>(machine_.budget + unused, 0));
    ++stream_.taken_;
    return !stuck;
}

/// The stream as the reader of tokens would have it: calls and blocks open, the next token.
void Runner::put_back(std::uint32_t token, std::uint32_t place)
{
    for (std::size_t i = 0; i < machine_.frames.size(); ++i) {
        const Frame& frame = machine_.frames[i];
        const bool innermost = i + 1 == machine_.frames.size();
        const Call* const call = innermost ? nullptr : machine_.frames[i + 1].call;
        open_places(frame, innermost ? place : call->place);
        Cursor& cursor = stream_.cursors_.back();
        cursor.position = innermost ? token : call->after;
        if (innermost) break;
        Block marker;
        marker.kind = BlockKind::Macro;
        marker.repeats = true;
        marker.file = cursor.file;
        marker.cursors = stream_.cursors_.size();
        Cursor entered;
        entered.file = call->macro->file;
        entered.macro = true;
        entered.name = call->macro->name;
        entered.tokens = stream_.files_[call->macro->file]->tokens.data();
        entered.position = call->macro->begin;
        entered.end = call->macro->end;
        entered.blocks = stream_.blocks_.size();
        entered.call = &cursor.tokens[call->token];
        stream_.cursors_.push_back(entered);
        stream_.blocks_.push_back(marker);
    }
    stream_.has_ahead_ = stream_.ahead_raw_ = false;
    if (token > 0) stream_.last_ = &stream_.cursors_.back().tokens[token - 1];
}

void Runner::open_places(const Frame& frame, std::uint32_t place)
{
    if (place == kNoIndex) return;
    const Place& opened = frame.program->places[place];
    open_places(frame, opened.parent);
    using Kind = BlockKind;
    Block block;
    block.kind = opened.kind == PlaceKind::If       ? Kind::If
                 : opened.kind == PlaceKind::Switch ? Kind::Switch
                 : opened.kind == PlaceKind::While  ? Kind::While
                                                    : Kind::For;
    block.repeats = true;
    block.file = stream_.cursors_.back().file;
    block.branch = opened.branch;
    block.again = opened.again;
    block.cursors = stream_.cursors_.size();
    if (block.kind == Kind::For) {
        const double* const given = machine_.registers_of(frame) + opened.limit;
        block.variable = stream_.symbols_.local(opened.name, frame.scope);
        block.limit = given[0];
        block.step = given[1];
    }
    stream_.blocks_.push_back(block);
}

}  // namespace parser::blocks
