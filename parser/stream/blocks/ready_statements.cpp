#include "parser/stream/blocks/compiler.h"

/// Statements of the grammar: their expressions become operations, the grammar keeps the rest.
namespace parser::blocks {

class ReadyCompiler final : public StatementReader {
public:
    ReadyCompiler(BlockCompiler& block, std::uint32_t at, std::uint32_t end)
        : block_(block), at_(at), end_(end), first_(block.program_.registers)
    {}
    Kind kind() const override { return at_ < end_ ? block_.kind(at_) : Kind::EndOfText; }
    const Token& take() override { return block_.tokens_[at_++]; }
    const Token& ahead() const override { return block_.tokens_[at_]; }
    scene::SourceRef place(const Token& token) const override { return {token.file, token.offset}; }
    const Value* meaning(const Token& name) const override { return block_.find(name.name); }

    std::optional<std::uint32_t> expression(int requested, bool full) override
    {
        if (constants_.size() > kMostValues) return std::nullopt;
        const int count = block_.expression(at_, end_, {requested, full, false});
        if (count == 0 || count > requested) return std::nullopt;
        const auto value = static_cast<std::uint32_t>(constants_.size());
        constants_.resize(value + static_cast<std::size_t>(requested));
        const std::uint32_t kept = block_.emitter_.keep(static_cast<std::uint32_t>(requested));
        block_.emitter_.move_all_to(kept, static_cast<std::size_t>(count), &constants_[value]);
        return value;
    }

    std::optional<std::uint32_t> numbers(std::size_t count) override
    {
        if (kind() != Kind::Numbers || constants_.size() > kMostValues) return std::nullopt;
        const Token& list = take();
        if (list.jump * static_cast<std::size_t>(list.number) != count) return std::nullopt;
        const auto value = static_cast<std::uint32_t>(constants_.size());
        const auto from = block_.source_.numbers->begin() + static_cast<std::ptrdiff_t>(list.name);
        constants_.insert(constants_.end(), from, from + static_cast<std::ptrdiff_t>(count));
        block_.emitter_.keep(static_cast<std::uint32_t>(count));
        return value;
    }

    Mark mark() const override { return {at_, block_.emitter_.size(), constants_.size()}; }
    void back_to(const Mark& mark) override
    {
        at_ = mark.token;
        constants_.resize(mark.values);
        block_.program_.registers = first_ + static_cast<std::uint32_t>(mark.values);
        block_.emitter_.clear();
        block_.emitter_.rewind(mark.operations, 0);
    }

    std::uint32_t at() const { return at_; }
    std::uint32_t first() const { return first_; }
    std::vector<double>& constants() { return constants_; }

private:
    static constexpr std::size_t kMostValues = 4000;
    BlockCompiler& block_;
    std::uint32_t at_, end_, first_;
    std::vector<double> constants_;  ///< of all values; those that are none are 0
};

bool BlockCompiler::ready_statement(std::uint32_t& at, std::uint32_t end, std::uint32_t place)
{
    if (gives_value_) return false;
    std::uint32_t behind = at, depth = 0;
    for (; behind < end; ++behind) {
        if (kind(behind) == Kind::Hash) return false;
        depth += kind(behind) == Kind::LeftBrace ? 1u : 0u;
        if (kind(behind) == Kind::RightBrace && --depth == 0) break;
        if (depth == 0 && behind > at) break;
    }
    mark_undoable(at, place, behind);
    const auto index = static_cast<std::uint32_t>(program_.ready.size());
    emitter_.emit(kConstants).a = index;
    ReadyCompiler reader(*this, at, end);
    std::unique_ptr<ReadyStatement> made = library_.prepare(reader);
    if (!made) {
        program_.registers = reader.first();
        return false;
    }
    program_.ready.push_back({std::move(made), std::move(reader.constants()), reader.first()});
    emitter_.emit(kReady).a = index;
    at = reader.at();
    return true;
}

}  // namespace parser::blocks
