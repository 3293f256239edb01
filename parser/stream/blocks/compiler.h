#pragma once

#include "parser/stream/blocks/expression_compiler.h"

#include <unordered_map>
#include <utility>

namespace parser::blocks {

/// The text that a block stands in.
struct Source {
    const Token* tokens = nullptr;
    const std::vector<std::string>* strings = nullptr;
    const std::vector<double>* numbers = nullptr;  ///< of Numbers tokens
    bool plain_texts = true;                       ///< literals mean what they say, as far as they are ASCII
};

using Known = std::unordered_map<std::uint32_t, Value>;

/// What a block finds outside of itself: macros that give a value, and statements of the grammar.
class Library {
public:
    virtual ~Library() = default;
    /// The macro of a call, compiled for the number or vector that it gives; null: it gives none, or is too
    /// complicated. `known`: what names will mean in it.
    virtual const Program* value_of(const ValueCall& call, const Known& known) = 0;
    /// A statement of the grammar, made ready to be run again. Null: it is left to the reader of tokens.
    virtual std::unique_ptr<ReadyStatement> prepare(StatementReader& reader) = 0;
};

/// Compiles directives one after the other. At what it cannot compile it puts a stop, and the reader of tokens goes on
/// there.
class BlockCompiler : public Meanings {
public:
    BlockCompiler(const Source& source, const Symbols& symbols, Library& library, Program& program)
        : Meanings(symbols), source_(source), tokens_(source.tokens), library_(library), program_(program),
          emitter_(program)
    {}

    /// The directives from `begin` on, until one that is not known or until `end`, and then a stop.
    void sequence(std::uint32_t begin, std::uint32_t end);
    /// The body of a macro, and then the return.
    void macro(const Macro& macro);
    /// The body of a macro for its value. False: not possible.
    bool value(const ValueCall& call, Known known);

    const Value* find(std::uint32_t name) const override;
    int components(std::uint32_t name) const override;
    bool literal(const Token& token, std::string& out) const override;
    bool texts() const override { return true; }
    const Program* value_of(const ValueCall& call, const std::vector<Argument>& arguments) const override;

private:
    friend class ReadyCompiler;
    /// A loop or `#switch` around what is compiled, whose end is not known yet.
    struct Leavable {
        std::uint32_t place;
        std::vector<std::uint32_t> jumps;  ///< operations that lead behind it
    };
    struct Branch {
        Kind word = Kind::End;
        std::uint32_t hash = 0, begin = 0, end = 0;  ///< tokens of the body
        std::uint32_t body = kNoIndex;               ///< operation
        std::vector<std::uint32_t> jumps;            ///< that lead to the body
    };

    Kind kind(std::uint32_t at) const { return tokens_[at].kind; }
    bool block(std::uint32_t begin, std::uint32_t end, std::uint32_t place);
    bool statement(std::uint32_t& at, std::uint32_t end, std::uint32_t place);
    bool directive(std::uint32_t& at, std::uint32_t end, std::uint32_t place);
    void stop(std::uint32_t at, std::uint32_t place);
    /// Notes that a statement begins here, at that token: where the reader of tokens takes over if the program leaves
    /// it.
    void mark(std::uint32_t token, std::uint32_t place);
    /// mark(), and if a token before `end` has an effect of its own, code that undoes the effect when the statement is
    /// left.
    void mark_undoable(std::uint32_t token, std::uint32_t place, std::uint32_t end);
    bool has_effect(const Token& token) const;
    std::uint32_t open(std::uint32_t parent, PlaceKind kind, std::uint32_t branch);

    // Each of these compiles what begins at `at`, moves `at` behind it, and returns 0 or false for what it cannot
    // compile.
    int expression(std::uint32_t& at, std::uint32_t end, const Form& form);
    bool text(std::uint32_t& at, std::uint32_t end);
    bool number(std::uint32_t& at, std::uint32_t end, bool full);
    bool condition(std::uint32_t& at, std::uint32_t end);
    bool range_of_case(std::uint32_t& at, std::uint32_t end);
    bool test(std::uint32_t hash, std::uint32_t& at, std::uint32_t end, std::uint32_t& jump);
    bool if_directive(std::uint32_t& at, std::uint32_t end, std::uint32_t place);
    bool branches_of(std::uint32_t hash, std::uint32_t end, std::vector<Branch>& out) const;
    bool switch_directive(std::uint32_t& at, std::uint32_t end, std::uint32_t place);
    bool case_test(Branch& branch, std::uint32_t end, std::uint32_t value);
    void land_breaks();
    std::uint32_t end_of_loop(std::uint32_t hash, std::uint32_t end) const;
    bool while_directive(std::uint32_t& at, std::uint32_t end, std::uint32_t place);
    bool for_directive(std::uint32_t& at, std::uint32_t end, std::uint32_t place);
    bool break_directive(std::uint32_t& at, std::uint32_t place);

    bool declare(std::uint32_t& at, std::uint32_t end, std::uint32_t place);
    bool declare_element(std::uint32_t& at, std::uint32_t end);
    bool declare_text(std::uint32_t& at, std::uint32_t end, bool local);
    bool declare_array(std::uint32_t& at, std::uint32_t end, bool local);
    bool ended(std::uint32_t& at, std::uint32_t end, bool numeric);
    bool may_declare(std::uint32_t name, const Value& sample, bool local) const;
    void know(std::uint32_t name, Value sample, bool local);
    bool subscripts(std::uint32_t& at, std::uint32_t end, std::size_t count);

    bool value_block(std::uint32_t begin, std::uint32_t end, std::uint32_t place, const ValueCall& call);
    bool value_branches(std::uint32_t hash, std::uint32_t end, std::uint32_t place, const ValueCall& call);
    bool value_at(std::uint32_t begin, std::uint32_t end, std::uint32_t place, const ValueCall& call);
    bool macro_call(std::uint32_t& at, std::uint32_t end, std::uint32_t place);
    bool ready_statement(std::uint32_t& at, std::uint32_t end, std::uint32_t place);
    bool read_numbers(std::uint32_t& at, std::uint32_t end, std::uint32_t place);
    bool write_texts(std::uint32_t& at, std::uint32_t end, std::uint32_t place);
    std::pair<std::uint32_t, std::uint32_t> while_body(std::uint32_t hash, std::uint32_t body, std::uint32_t closing,
                                                       std::uint32_t place);
    std::uint32_t repeated(std::uint32_t hash, std::uint32_t body, std::uint32_t closing, std::uint32_t inside);
    void end_while(std::uint32_t back, std::uint32_t first, const std::vector<std::uint32_t>& left);
    bool while_defined(std::uint32_t& at, std::uint32_t place, std::uint32_t closing);
    bool argument(std::uint32_t& at, std::uint32_t end, Argument& out);

    const Source& source_;
    const Token* tokens_;
    Library& library_;
    Program& program_;
    Emitter emitter_;
    Known known_;
    std::unordered_map<std::uint32_t, int> elements_;
    std::vector<Leavable> open_;
    std::vector<std::uint32_t> returns_;  ///< operations that lead to the end of the macro
    std::uint32_t root_ = kNoIndex;       ///< token at which the sequence begins
    bool in_macro_ = false, named_ = false;
    bool gives_value_ = false;  ///< a value is wanted, no statements
    std::uint32_t text_arguments_ = 0;
};

}  // namespace parser::blocks
