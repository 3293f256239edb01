#include "parser/stream/blocks/emitter.h"

/// Texts, and calls of macros that give a value.
namespace parser::blocks {

void Emitter::text_constant(std::string&& text)
{
    emit_text(kTextConstant).a = static_cast<std::uint32_t>(program_.texts.size());
    program_.texts.push_back(std::move(text));
}

bool Emitter::text_load(std::uint32_t name)
{
    const std::uint32_t from = slot(name, kText);
    emit_text(kTextLoad).a = from;
    return from != kNoIndex;
}

bool Emitter::text_element(std::uint32_t name, std::size_t dimensions)
{
    const std::uint32_t from = slot(name, kArray), first = in_registers(dimensions);
    drop(dimensions);
    Op& made = emit_text(kTextElement);
    made.a = from;
    made.b = first;
    made.jump = static_cast<std::int32_t>(dimensions);
    return from != kNoIndex;
}

void Emitter::append_text()
{
    --texts_;
    Op& made = emit(kTextAppend);
    made.to = texts_ - 1;
    made.a = texts_;
}

void Emitter::text_of_numbers(Handler run, std::size_t taken)
{
    const std::uint32_t first = in_registers(taken);
    drop(taken);
    emit_text(run).a = first;
}

Op& Emitter::change_text(Handler run, std::size_t taken)
{
    const std::uint32_t first = in_registers(taken);
    drop(taken);
    Op& made = emit(run);
    made.to = texts_ - 1;
    made.a = first;
    return made;
}

void Emitter::number_of_texts(Handler run, std::uint32_t taken, std::int32_t how)
{
    texts_ -= taken;
    Op& made = emit(run);
    made.to = depth();
    made.a = texts_;
    made.b = texts_ + 1;
    made.jump = how;
    push_register();
}

bool Emitter::dimension_size(std::uint32_t name, bool sized)
{
    const std::uint32_t from = slot(name, kArray);
    Op& made = in_place(kDimensionSize, sized ? 1 : 0, 1);
    made.a = from;
    made.b = sized ? 1 : 0;
    return from != kNoIndex;
}

/// Operands below the arguments are brought into registers first: the macro may change the variables that they come
/// from.
void Emitter::call_value(Call&& call, std::size_t base, std::size_t count)
{
    in_registers(stack_.size());
    drop(stack_.size() - base);
    call.place = place_;
    std::uint32_t next = depth(), texts = 0;
    for (Argument& one : call.arguments) {
        one.first = one.kind == Argument::Kind::Text ? texts++ : next;
        if (one.kind == Argument::Kind::Element || one.kind == Argument::Kind::Number) next += one.count;
    }
    texts_ = 0;
    Op& op = emit(kCallValue);
    op.a = static_cast<std::uint32_t>(program_.calls.size());
    op.to = depth();
    program_.calls.push_back(std::move(call));
    push_registers(count);
}

}  // namespace parser::blocks
