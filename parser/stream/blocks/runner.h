#pragma once

#include "parser/stream/blocks/compiler.h"
#include "parser/stream/machine/machine.h"
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

    /// The expression that begins where the stream stands: takes it. False: it was not compiled (yet), or something is
    /// not as it was. Only the components of `out` are written.
    bool expression(const Form& form, Tuple& out);

    std::int64_t more() override;
    const Program& program_of(const Call& call) override;

private:
    enum State : std::uint32_t { kUnseen, kSeen, kNever, kFirst };
    const Program* value_of(const ValueCall& call, const Known& known) override;
    std::unique_ptr<ReadyStatement> prepare(StatementReader& reader) override;
    bool usable() const;
    using Sites = std::vector<std::vector<std::uint32_t>>;  ///< by file and token
    std::uint32_t* sites_in(Sites& all, std::uint16_t file) const;
    std::uint32_t& site(std::uint16_t file, std::uint32_t token) { return sites_in(sites_, file)[token]; }
    /// An expression by itself, whose program leaves its components in the first registers.
    struct Expression {
        Form form;
        std::uint32_t end = 0;          ///< token behind it
        std::uint32_t next = kNoIndex;  ///< another one for the same place
        int count = 1;                  ///< components
        Program program;
    };
    bool compile(const Form& form, std::uint32_t at, Expression& made) const;
    bool work_out(const Expression& known, Tuple& out);
    bool take(const Expression& known, std::uint32_t at, Tuple& out);
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
    Machine alone_;  ///< for single expressions, which may be read while a block is at work
    Sites sites_, expression_sites_;
    std::vector<std::unique_ptr<Expression>> expressions_;
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
