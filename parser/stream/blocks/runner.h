#pragma once

#include "parser/stream/blocks/compiler.h"
#include "parser/stream/blocks/machine.h"
#include "parser/stream/reading_profile.h"

#include <map>
#include <unordered_map>

namespace parser {
class TokenStream;
}

namespace parser::blocks {

/// Runs the blocks of one stream: compiles them at their second visit, puts the stream where they were left.
class Runner : public Supply, private Library {
public:
    explicit Runner(TokenStream& stream);

    /// Whether statements of the grammar may stand where the directive does that comes next.
    void expect_statements(bool expected) { expected_ = expected; }
    /// The stream stands behind the word of a directive whose Hash is given, in text that is read again. True: that
    /// directive, and maybe many more, are done.
    bool at_directive(std::uint32_t hash);
    /// At the end of a pass through the innermost loop. True: what is to be done there is done.
    bool at_end_of_pass(std::uint32_t hash_of_end);

    std::int64_t more() override;
    const Program& program_of(const Call& call) override;

private:
    enum State : std::uint32_t { kUnseen, kSeen, kNever, kFirst };
    const Program* value_of(const CompiledCall& call, const Known& known) override;
    std::unique_ptr<ReadyStatement> prepare(StatementReader& reader) override;
    bool usable() const;
    std::uint32_t& site(std::uint16_t file, std::uint32_t token);
    Program* program_at(std::uint32_t& site, std::uint32_t hash);
    Source source_of(std::uint16_t file) const;
    Program& compile(std::uint32_t attempt);
    bool run(Program& program, std::uint32_t& site, std::uint32_t op, std::uint32_t entered_at);
    void put_back(std::uint32_t token, std::uint32_t place);
    void open_places(const Frame& frame, std::uint32_t place);
    bool found_wanting(Program& program) const;
    void spend_time();

    TokenStream& stream_;
    Machine machine_;
    std::vector<std::vector<std::uint32_t>> sites_;  ///< by file and token
    std::vector<std::unique_ptr<Program>> programs_;
    std::unordered_map<const Macro*, Program*> macros_;
    bool expected_ = false;
    std::uint32_t loop_ = kNoIndex;            ///< the Hash of the loop at work; kNoIndex: the block is none
    std::vector<ReadingProfile::Place> open_;  ///< of spend_time()
    struct ValueProgram {
        Program* program = nullptr;
        bool at_work = false;
        std::uint32_t failures = 0;
    };
    std::unordered_map<const Macro*, std::map<std::string, ValueProgram>> values_;  ///< by the form of the call
};

}  // namespace parser::blocks
