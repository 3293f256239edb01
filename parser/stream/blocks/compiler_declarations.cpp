#include "parser/stream/blocks/compiler.h"

#include "parser/lexer/color_word.h"

#include <algorithm>

/// Declarations and calls.
namespace parser::blocks {
namespace {

constexpr std::uint32_t kMostTextArguments = 8;

std::uint8_t slot_kind(const Value& value)
{
    if (const Tuple* const tuple = value.get_if<Tuple>()) return static_cast<std::uint8_t>(tuple->count);
    if (value.get_if<std::string>()) return kText;
    return value.get_if<std::shared_ptr<Array>>() ? kArray : kAny;
}

}  // namespace

/// Whether a declaration leaves the kind of the name as it is, or makes it, or turns it (Machine::place_to_store).
bool BlockCompiler::may_declare(std::uint32_t name, const Value& sample, bool local) const
{
    const Value* const old = find(name);
    if (!old || !old->set() || slot_kind(*old) == slot_kind(sample)) return true;
    if (!in_macro_ && old->get_if<Tuple>() && sample.get_if<Tuple>()) return true;
    return local && !known_.contains(name) && !symbols_.in_current_scope(name);
}

void BlockCompiler::know(std::uint32_t name, Value sample, bool local)
{
    const Value* const old = find(name);
    if (!old || !old->set() || local || slot_kind(*old) != slot_kind(sample))
        known_.insert_or_assign(name, std::move(sample));
}

/// Behind a declaration: the semicolon, two of them behind a number.
bool BlockCompiler::ended(std::uint32_t& at, std::uint32_t end, bool numeric)
{
    if (at >= end || kind(at) != Kind::Semicolon) return false;
    ++at;
    if (numeric && at < end && kind(at) == Kind::Semicolon) ++at;
    return true;
}

bool BlockCompiler::declare(std::uint32_t& at, std::uint32_t end, std::uint32_t place)
{
    const bool local = kind(at + 1) == Kind::Local;
    if (at + 4 >= end || kind(at + 2) != Kind::Identifier) return false;
    std::uint32_t semicolon = at;
    while (semicolon < end && kind(semicolon) != Kind::Semicolon) ++semicolon;
    mark_undoable(at, place, semicolon);
    at += 2;
    if (kind(at + 1) == Kind::LeftSquare) return declare_element(at, end);
    if (kind(at + 1) != Kind::Equal) return false;
    const Token& first = tokens_[at + 2];
    if (first.kind == Kind::Array) return declare_array(at, end, local);
    if (begins_text(first, *this)) return declare_text(at, end, local);
    const Value* const meant = first.kind == Kind::Identifier ? find(first.name) : nullptr;
    if (meant && meant->get_if<std::shared_ptr<Array>>() && kind(at + 3) == Kind::Semicolon)
        return declare_array(at, end, local);

    const std::uint32_t name = tokens_[at].name, begin = at + (first.kind == Kind::Color ? 3u : 2u);
    const ColorWord word = color_word(kind(begin));
    if (word.encoded) return false;  // its value depends on assumed_gamma
    const int color = word.components;
    if (first.kind == Kind::Color && color == 0) return false;
    at = begin + (color != 0 ? 1 : 0);
    const int written = expression(at, end, color != 0 ? Form{color, true, true} : Form{1, false, true});
    if (written == 0 || (color != 0 && written > color)) return false;
    const auto count = static_cast<std::uint8_t>(color != 0 ? 5 : written);
    const Value sample(Tuple{{}, count});
    if (!may_declare(name, sample, local)) return false;
    if (color != 0) emitter_.color(static_cast<std::size_t>(written), word.transmits);
    const std::uint32_t to = emitter_.slot(name, count);
    if (to == kNoIndex || !ended(at, end, true)) return false;
    know(name, sample, local);
    if (count == 1) return emitter_.store_number(to, local), true;
    const std::uint32_t registers = emitter_.in_registers(count);
    Op& op = emitter_.emit(kStoreTuple);
    op.to = to;
    op.a = registers;
    op.b = count;
    op.jump = local ? 1 : 0;
    return true;
}

/// `[ number ]`, so many times: on the stack.
bool BlockCompiler::subscripts(std::uint32_t& at, std::uint32_t end, std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i) {
        if (at >= end || kind(at) != Kind::LeftSquare) return false;
        ++at;
        if (!number(at, end, false) || at >= end || kind(at) != Kind::RightSquare) return false;
        ++at;
    }
    return true;
}

bool BlockCompiler::declare_element(std::uint32_t& at, std::uint32_t end)
{
    const std::uint32_t name = tokens_[at].name;
    const Value* const meant = find(name);
    const auto* const array = meant ? meant->get_if<std::shared_ptr<Array>>() : nullptr;
    if (!array || (*array)->growing || (*array)->mixed) return false;
    const std::size_t dimensions = (*array)->sizes.size();
    const std::uint32_t slot = emitter_.slot(name, kArray);
    ++at;
    if (slot == kNoIndex || !subscripts(at, end, dimensions) || at + 1 >= end || kind(at) != Kind::Equal) return false;
    ++at;
    if (begins_text(tokens_[at], *this)) {
        const std::uint32_t first = emitter_.in_registers(dimensions);
        if (!text(at, end) || !ended(at, end, false)) return false;
        Op& op = emitter_.emit(kStoreTextElement);
        op.a = slot;
        op.b = first;
        op.jump = static_cast<std::int32_t>(dimensions);
        elements_[name] = kTextElements;
        return true;
    }
    const int count = expression(at, end, {1, false, true});
    if (count == 0 || !ended(at, end, true)) return false;
    elements_[name] = count;
    if (count == 1) return emitter_.store_element(slot, dimensions), true;
    const std::uint32_t first = emitter_.in_registers(dimensions + static_cast<std::size_t>(count));
    Op& op = emitter_.emit(kStoreElement);
    op.a = slot;
    op.b = first;
    op.to = static_cast<std::uint32_t>(dimensions);
    op.jump = count;
    return true;
}

bool BlockCompiler::declare_text(std::uint32_t& at, std::uint32_t end, bool local)
{
    const std::uint32_t name = tokens_[at].name;
    const Value sample{std::string()};
    at += 2;
    if (!may_declare(name, sample, local) || !text(at, end)) return false;
    const std::uint32_t to = emitter_.slot(name, kText);
    if (to == kNoIndex || !ended(at, end, false)) return false;
    know(name, sample, local);
    Op& op = emitter_.emit(kStoreText);
    op.to = to;
    op.jump = local ? 1 : 0;
    return true;
}

/// `array[N][M]` or the name of another array.
bool BlockCompiler::declare_array(std::uint32_t& at, std::uint32_t end, bool local)
{
    const std::uint32_t name = tokens_[at].name;
    at += 2;
    auto sample = std::make_shared<Array>();
    if (!may_declare(name, Value(sample), local)) return false;
    const std::uint32_t to = emitter_.slot(name, kArray);
    if (to == kNoIndex) return false;
    if (kind(at) == Kind::Identifier) {
        const std::uint32_t from = emitter_.slot(tokens_[at].name, kArray);
        const Value copied = *find(tokens_[at].name);
        const int of = components(tokens_[at].name);
        if (from == kNoIndex || !ended(++at, end, false)) return false;
        know(name, copied, local);
        if (of != 0) elements_[name] = of;
        Op& op = emitter_.emit(kCopyArray);
        op.to = to;
        op.a = from;
        op.jump = local ? 1 : 0;
        return true;
    }
    std::size_t dimensions = 0;
    for (++at; dimensions < 5 && at < end && kind(at) == Kind::LeftSquare; ++dimensions)
        if (!subscripts(at, end, 1)) return false;
    if (dimensions == 0 || at >= end) return false;
    const bool semicolon = kind(at) == Kind::Semicolon;
    if (!semicolon && kind(at) != Kind::Hash) return false;
    at += semicolon ? 1 : 0;
    sample->sizes.assign(dimensions, 1);
    know(name, Value(sample), true);
    const std::uint32_t first = emitter_.in_registers(dimensions);
    Op& op = emitter_.emit(kMakeArray);
    op.a = to;
    op.b = first;
    op.to = static_cast<std::uint32_t>(dimensions);
    op.jump = local ? 1 : 0;
    return true;
}

bool BlockCompiler::argument(std::uint32_t& at, std::uint32_t end, Argument& out)
{
    const auto ends = [&](std::uint32_t i) {
        return i < end && (kind(i) == Kind::Comma || kind(i) == Kind::RightParen);
    };
    const Value* const meant = kind(at) == Kind::Identifier ? find(tokens_[at].name) : nullptr;
    if (meant && ends(at + 1)) {
        out.kind = Argument::Kind::Name;
        out.name = tokens_[at].name;
        if (slot_kind(*meant) == kAny && !meant->get_if<std::shared_ptr<const scene::Object>>()) return false;
        ++at;
        return true;
    }
    const auto* const array = meant ? meant->get_if<std::shared_ptr<Array>>() : nullptr;
    if (array) {  // an element alone is given by reference
        const std::uint32_t before = at, slot = emitter_.slot(tokens_[at].name, kArray);
        const std::size_t count = (*array)->sizes.size(), ops = program_.ops.size();
        ++at;
        if (slot == kNoIndex || !subscripts(at, end, count)) return false;
        if (ends(at)) {
            out.kind = Argument::Kind::Element;
            out.count = static_cast<std::uint8_t>(count);
            out.slot = slot;
            out.first = emitter_.in_registers(count);
            return true;
        }
        emitter_.rewind(ops, count);
        at = before;
    }
    if (begins_text(tokens_[at], *this)) {
        if (text_arguments_ >= kMostTextArguments || !text(at, end) || !ends(at)) return false;
        out.kind = Argument::Kind::Text;
        out.first = text_arguments_++;  // its place among the texts that are on the stack
        return true;
    }
    const int count = expression(at, end, {1, false, false});
    if (count == 0 || !ends(at)) return false;
    out.kind = Argument::Kind::Number;
    out.count = static_cast<std::uint8_t>(count);
    out.first = emitter_.in_registers(out.count);
    return true;
}

/// `#read (FILE, A, B, ...)` into variables that are numbers already.
bool BlockCompiler::read_numbers(std::uint32_t& at, std::uint32_t end, std::uint32_t place)
{
    const std::uint32_t hash = at, file = hash + 3;
    if (file + 1 >= end || kind(hash + 2) != Kind::LeftParen || kind(file) != Kind::Identifier) return false;
    const Value* const opened = find(tokens_[file].name);
    if (!opened || !opened->get_if<std::shared_ptr<DataFile>>()) return false;
    mark(hash, place);
    ReadSite site;
    site.file = tokens_[file].name;
    std::uint32_t next = file + 1;
    for (; next < end && kind(next) != Kind::RightParen; ++next) {
        if (kind(next) == Kind::Comma) ++next;
        if (next >= end || kind(next) != Kind::Identifier || site.slots.size() >= kStackRegisters / 2) return false;
        const Value* const target = find(tokens_[next].name);
        const Tuple* const number = target ? target->get_if<Tuple>() : nullptr;
        const std::uint32_t slot = emitter_.slot(tokens_[next].name, kFloat);
        if (!number || number->count != 1 || slot == kNoIndex) return false;
        if (next + 1 < end && kind(next + 1) != Kind::Comma && kind(next + 1) != Kind::RightParen) return false;
        site.slots.push_back(slot);
    }
    if (next >= end || site.slots.empty()) return false;
    emitter_.emit(kRead).a = static_cast<std::uint32_t>(program_.reads.size());
    program_.reads.push_back(std::move(site));
    at = next + 1;
    return true;
}

/// `#write (FILE, text, ...)`: what is no text is left to the reader of tokens.
bool BlockCompiler::write_texts(std::uint32_t& at, std::uint32_t end, std::uint32_t place)
{
    const std::uint32_t hash = at, file = hash + 3;
    if (file + 2 >= end || kind(hash + 2) != Kind::LeftParen || kind(file) != Kind::Identifier) return false;
    const Value* const opened = find(tokens_[file].name);
    if (!opened || !opened->get_if<std::shared_ptr<DataFile>>()) return false;
    mark_undoable(hash, place, closing_parenthesis(tokens_, hash + 2, end));
    ExpressionCompiler reader(tokens_, file + (kind(file + 1) == Kind::Comma ? 2 : 1), end, *this, emitter_);
    if (!reader.whole_texts()) return false;
    at = reader.at() + 1;
    emitter_.emit(kWrite).b = tokens_[file].name;  // the text is the first there is
    return true;
}

bool BlockCompiler::macro_call(std::uint32_t& at, std::uint32_t end, std::uint32_t place)
{
    const Value* const meant = find(tokens_[at].name);
    const auto* const macro = meant ? meant->get_if<std::shared_ptr<const Macro>>() : nullptr;
    if (!macro || at + 2 >= end || kind(at + 1) != Kind::LeftParen) return false;
    if (std::find((*macro)->optional.begin(), (*macro)->optional.end(), true) != (*macro)->optional.end()) return false;
    Call call;
    call.macro = *macro;
    call.token = at;
    call.place = place;
    text_arguments_ = 0;
    mark_undoable(at, place, closing_parenthesis(tokens_, at + 1, end));
    at += 2;
    for (std::size_t i = 0; i < (*macro)->parameters.size(); ++i) {
        Argument given;
        if (at >= end || kind(at) == Kind::RightParen || !argument(at, end, given)) return false;
        call.arguments.push_back(given);
        if (at < end && kind(at) == Kind::Comma) ++at;
    }
    if (at >= end || kind(at) != Kind::RightParen) return false;
    call.after = ++at;
    emitter_.emit(kCall).a = static_cast<std::uint32_t>(program_.calls.size());
    program_.calls.push_back(std::move(call));
    return true;
}

}  // namespace parser::blocks
