#include "parser/stream/blocks/emitter.h"

namespace parser::blocks {

/// A text that is there already, onto the texts.
bool Emitter::load_text(const CompiledOp& op)
{
    using Code = CompiledOp::Code;
    switch (op.code) {
    case Code::TextConstant: {
        Op& made = emit(kTextConstant);
        made.to = texts_++;
        made.a = static_cast<std::uint32_t>(program_.texts.size());
        program_.texts.push_back(program_.expressions.back().texts[op.name]);
        return true;
    }
    case Code::TextLoad: {
        const std::uint32_t from = slot(op.name, kText);
        Op& made = emit(kTextLoad);
        made.to = texts_++;
        made.a = from;
        return from != kNoIndex;
    }
    default: {
        const std::uint32_t from = slot(op.name, kArray), first = in_registers(op.a);
        Op& made = emit(kTextElement);
        made.to = texts_++;
        made.a = from;
        made.b = first;
        made.jump = op.a;
        drop(op.a);
        return from != kNoIndex;
    }
    }
}

bool Emitter::text_operation(const CompiledOp& op)
{
    const auto text_of = [&](std::uint32_t back) { return texts_ - back; };
    const auto number_from_text = [&](Handler run, std::uint32_t taken) {
        texts_ -= taken;
        Op& made = emit(run);
        made.to = depth();
        made.a = texts_;
        made.b = texts_ + 1;
        made.jump = static_cast<std::int32_t>(op.kind);
        push_register();
        return true;
    };
    const auto text_from_numbers = [&](Handler run, std::size_t taken, std::uint32_t to) {
        const std::uint32_t first = in_registers(taken);
        Op& made = emit(run);
        made.to = to;
        made.a = first;
        drop(taken);
        texts_ = to + 1;
        return true;
    };
    using Code = CompiledOp::Code;
    switch (op.code) {
    case Code::TextConstant:
    case Code::TextLoad:
    case Code::TextElement: return load_text(op);
    case Code::TextAppend: {
        Op& made = emit(kTextAppend);
        made.to = text_of(2);
        made.a = text_of(1);
        --texts_;
        return true;
    }
    case Code::TextNumber: return text_from_numbers(kTextNumber, 3, texts_);
    case Code::TextCharacter: return text_from_numbers(kTextCharacter, 1, texts_);
    case Code::TextPart: return text_from_numbers(kTextPart, 2, text_of(1));
    case Code::TextTuple:
        text_from_numbers(kTextTuple, 3u + op.a, text_of(1));
        program_.ops.back().b = op.a;
        return true;
    case Code::TextUpper:
    case Code::TextLower: emit(op.code == Code::TextUpper ? kTextUpper : kTextLower).to = text_of(1); return true;
    case Code::TextLength: return number_from_text(kTextLength, 1);
    case Code::TextFirst: return number_from_text(kTextFirst, 1);
    case Code::TextValue: return number_from_text(kTextValue, 1);
    case Code::TextOrder: return number_from_text(kTextOrder, 2);
    case Code::TextRelation: return number_from_text(kTextRelation, 2);
    case Code::DimensionSize: {
        const std::uint32_t from = slot(op.name, kArray);
        in_registers(op.a);
        drop(op.a);
        Op& made = emit(kDimensionSize);
        made.to = depth();
        made.a = from;
        made.b = op.a;
        push_register();
        return from != kNoIndex;
    }
    default: return false;
    }
}

/// What the call needs lies on the stacks; what is below has to be read before the macro can change it.
bool Emitter::macro_call(const CompiledCall& read, std::size_t count)
{
    std::size_t taken = 0;
    for (const CompiledArgument& one : read.arguments)
        if (one.kind == CompiledArgument::Kind::Element || one.kind == CompiledArgument::Kind::Number)
            taken += one.count;
    in_registers(stack_.size());
    drop(taken);
    Call call;
    call.macro = read.macro;
    call.token = read.token;
    call.after = read.after;
    call.place = place_;
    call.value = read.program;
    call.guards = read.guards;
    std::uint32_t next = depth(), texts = 0;
    for (const CompiledArgument& one : read.arguments) {
        Argument given;
        given.kind = static_cast<Argument::Kind>(one.kind);
        given.count = one.count;
        given.name = one.name;
        given.first = given.kind == Argument::Kind::Text ? texts++ : next;
        if (given.kind == Argument::Kind::Element) given.slot = slot(one.name, kArray);
        if (given.slot == kNoIndex) return false;
        if (given.kind == Argument::Kind::Element || given.kind == Argument::Kind::Number) next += one.count;
        call.arguments.push_back(given);
    }
    texts_ = 0;
    Op& op = emit(kCallValue);
    op.a = static_cast<std::uint32_t>(program_.calls.size());
    op.to = depth();
    program_.calls.push_back(std::move(call));
    push_registers(count);
    return true;
}

}  // namespace parser::blocks
