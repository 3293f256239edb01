#pragma once

#include "parser/lexer/lexer.h"
#include "parser/base/reading.h"
#include "parser/stream/hooks.h"
#include "parser/stream/kept_files.h"
#include "parser/stream/language_state.h"
#include "parser/stream/reading_profile.h"
#include "parser/stream/reading_state.h"
#include "parser/stream/texts/source_texts.h"
#include "parser/stream/values/random_undo.h"
#include "parser/stream/values/symbols.h"
#include "render/files/read_files.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace parser {

namespace blocks {
class Runner;
}

/// Executes directives and macro calls and hands on plain tokens, one token of look-ahead.
class TokenStream : public SourceTexts {
public:
    TokenStream(const Options& options, GrammarHooks& hooks, MessageSink sink = nullptr, void* sink_context = nullptr);
    ~TokenStream();
    TokenStream(const TokenStream&) = delete;
    TokenStream& operator=(const TokenStream&) = delete;

    void open_file(const std::string& path);                           ///< the main scene; throws Error if unreadable
    void open_text(const std::string& text, const std::string& name);  ///< the same from memory

    // ---- tokens ----------------------------------------------------------------------------------------------
    /// The next plain token; directives and macro calls before it have been executed.
    const Token& peek()
    {
        if (!has_ahead_ ? !fetch_plain() : ahead_raw_) fetch();
        return *ahead_;
    }
    /// The same where a statement of the grammar may begin: those that blocks know are done on the way
    /// (GrammarHooks::prepare).
    const Token& peek_statement()
    {
        if (has_ahead_ && !ahead_raw_) return *ahead_;
        const FlagInScope expected(statements_, true);
        return peek();
    }
    const Token& next()  ///< takes it
    {
        peek();
        if (ahead_->kind != Kind::EndOfText) has_ahead_ = false;
        ++taken_;
        return *(last_ = ahead_);
    }
    /// Takes it where a new name is made: a word that only 3.8 has is one.
    Token next_name()
    {
        Token token = next();
        if (is_keyword(token.kind) && names_.new_word(token.name) == token.kind) token.kind = Kind::Identifier;
        return token;
    }
    bool accept(Kind kind)  ///< takes it if it is of that kind
    {
        if (peek().kind != kind) return false;
        next();
        return true;
    }
    void expect(Kind kind, std::string_view what)  ///< or fails with "expected <what>, found ..."
    {
        if (!accept(kind)) fail_expected(what);
    }
    bool accept_comma() { return accept(Kind::Comma); }
    /// The next token where directives are not executed: `#` and a macro's name are returned as they stand.
    const Token& peek_raw();
    std::uint64_t taken() const { return taken_; }  ///< tokens taken so far (a grammar may rewind only if unchanged)

    // ---- places and messages ---------------------------------------------------------------------------------
    scene::SourceRef here();        ///< of the token that peek() shows
    scene::SourceRef last() const;  ///< of the token taken last
    const Token& taken_last() const { return *last_; }
    [[noreturn]] void fail(const scene::SourceRef& at, std::string_view text);
    /// "expected <what>, found '<peek()>'" at peek(), and what else there is to say.
    [[noreturn]] void fail_expected(std::string_view what, std::string_view more = "");
    /// Once for a text at a place: what stands in a loop or a file that is read again says nothing new.
    /// `check`: of `whittle lint` that tells it too.
    void warn(const scene::SourceRef& at, std::string_view text, std::string_view check = {});
    /// The same of the block that is read, told once it is closed: a mistake in it would be the cause.
    void warn_when_closed(const scene::SourceRef& at, std::string text);
    /// For a name that means nothing where it stands: "'shpere' is not declared; did you mean 'sphere'?"
    /// `block`: in which an item was expected; `items`: all of its words, where they are known.
    [[noreturn]] void fail_undeclared(const Token& token, std::string_view block = {},
                                      std::span<const Kind> items = {});
    /// "; did you mean '45*y'?" where numbers stand as no vector can be written; else nothing.
    std::string hint_at(const Token& found) const;

    // ---- names and values ------------------------------------------------------------------------------------
    Symbols& symbols() { return symbols_; }
    const Names& names() const { return names_; }
    const std::string& word(const Token& token) const { return names_.word(token.name); }
    /// What an Identifier token means; null if undeclared. Copy what you need before the next peek().
    const Value* value_of(const Token& token) const { return symbols_.find(token.name); }
    /// Of a name that a text holds; null: nothing of that name is declared.
    const Value* value_of(std::string_view name) const
    {
        const std::uint32_t known = names_.find(name);
        return known == kNoIndex ? nullptr : symbols_.find(known);
    }
    /// If the next token is an identifier (or array element) holding a T: takes it and gives the content, else nothing
    /// is taken. Array subscripts are read: `texture { T[2] }`.
    template <class T>
    std::optional<T> accept_identifier();
    /// Calls read() while the stream yields the tokens [begin, end) of a file instead, then puts its position back.
    template <class Read>
    void read_again(const Token* begin, const Token* end, Read&& read);
    /// Raw string token -> text (escapes resolved, characters as the charset says); `path`: backslashes stay.
    std::string string_text(const Token& token, bool path);

    LanguageState& language() { return language_; }
    const Options& options() const { return options_; }
    GrammarHooks& hooks() { return hooks_; }
    std::vector<std::uint32_t>& random_streams() { return random_streams_; }
    std::vector<Message>& messages() { return messages_; }
    const Statistics& statistics() const { return statistics_; }
    std::vector<ReadingCost> reading_costs(std::size_t most);  ///< up to now
    files::ReadFiles& read_files() { return read_files_; }

    /// Full path of a file by the rules of `#include` (current folder, library path, scene's folder, the including
    /// file's folder); empty if there is none. `extensions` are tried as the manual says, e.g. {".inc", ".INC"}.
    std::string find_file(const std::string& name, const std::vector<std::string>& extensions) const;

    /// Guards recursion: `const auto guard = stream.nest();` fails with a message when nested too deeply.
    class Nesting {
    public:
        explicit Nesting(TokenStream& stream);
        ~Nesting() { --stream_.nesting_; }
        Nesting(const Nesting&) = delete;
        Nesting& operator=(const Nesting&) = delete;
    private:
        TokenStream& stream_;
    };
    [[nodiscard]] Nesting nest() { return Nesting(*this); }

    // ---- used by the expression reader -----------------------------------------------------------------------
    /// In the right-hand side of a declaration directives are not executed where an operator may stand
    /// (spec 1, 2.1); inside parentheses they are.
    bool raw_operators() const { return raw_operators_; }
    void set_raw_operators(bool raw) { raw_operators_ = raw; }
    const Token& peek_operator() { return raw_operators_ ? peek_raw() : peek(); }
    /// Subscripts after an identifier just taken whose value is an array: the element's cell (the array's own cell if
    /// no `[` follows). `may_create`: an unset element is not an error.
    Cell subscripted(Cell cell, const Token& name, bool may_create, std::shared_ptr<Array>* innermost = nullptr);
    /// What a value was if its text was one identifier and nothing else.
    struct Named {
        Cell cell;
        std::uint32_t scope = 0;  ///< of the identifier
    };
    /// A value of any kind: right-hand side, macro argument, array element. Where `named` is set it is no value.
    Value read_value(Named* named = nullptr);
    Value read_any_value(Named* named);  ///< before it is stored
    /// The word inside `defined ( name )`, with the parentheses.
    bool read_defined();
    /// Rules of version 3.8 that go with the language's version, not with its words.
    bool new_language() const { return language_.version > 370; }
    /// Which POV-Ray the scene is drawn as, as far as the text was read.
    scene::PovRay povray() const { return language_.povray; }
    /// What the name ahead means; of a dictionary or a mixed array the part that the tokens behind it name. Null:
    /// nothing, or no name is ahead.
    const Value* named_ahead();
    /// A name, or `local.` or `global.` before one.
    bool at_name() { return peek().kind == Kind::Identifier || at_pseudo_scope() != Kind::EndOfText; }
    /// Takes it without subscripts: what it means, and the name. Null: it means nothing.
    Cell take_name(Token& name);
    /// What a token is here: the words of 3.8 are words in every scene, but for names that it declares (a scene of 3.7
    /// or before may have any of them) and for all where --povray=3.7 asks for that language.
    const Token& as_word(const Token& token) const
    {
        return token.kind != Kind::Identifier || token.jump == kNoIndex ? token : new_word(token);
    }
    /// --povray=3.7: what only 3.8 reads is refused.
    bool strictly_37() const { return options_.povray == scene::PovRay::V37; }
    /// A statement of the scene begins with the token ahead (nothing is ahead: forgets it).
    void begin_statement();
    /// Blocks that are open, for the message about one that is never closed: its '{' was read; it was closed.
    void block_opened(const scene::SourceRef& brace) { open_blocks_.push_back(brace); }
    void block_closed()
    {
        if (!open_blocks_.empty()) open_blocks_.pop_back();
        if (!block_warnings_.empty()) tell_of_closed_blocks();
    }
    /// "; the '{' of 'sphere' stands in line 3", or nothing if that is the line that peek() shows.
    std::string where_opened(std::string_view what, const scene::SourceRef& brace);
    /// The '}' of that block, or fails with "expected <what>, found ..." and the place of its '{'.
    void expect_closing(std::string_view what, std::string_view block, const scene::SourceRef& brace);
    /// After an error: stands behind the block of that statement, if it is sure where it ends and that skipping it
    /// skips nothing but the block. Else false.
    bool skip_statement();
    /// In a loop or macro: the expression that begins here, if it was compiled; takes it. False: nothing was taken.
    /// `out` must be new: only its components are written.
    bool run_compiled_here(int requested, bool full, Tuple& out)
    {
        return !blocks_.empty() && blocks_.back().repeats && find_compiled(requested, full, out);
    }
    /// The name that a running declaration will create: a function that names it calls itself.
    std::uint32_t declaring() const { return declaring_; }
    /// `declare`, `include` or `version` without its '#', already taken: warns and does it.
    void bare_directive(const Token& word);

private:
    friend class blocks::Runner;
    class Again;  ///< token_stream_templates.h
    void fetch();
    /// The common case of fetch(): nothing is ahead and a token stands next that is nothing to execute.
    bool fetch_plain()
    {
        Cursor& cursor = cursors_.back();
        if (cursor.position >= cursor.end || cursor.tokens[cursor.position].kind <= Kind::Identifier || left_ == 0)
            return false;
        --left_;
        ahead_ = &cursor.tokens[cursor.position++];
        has_ahead_ = true;
        ahead_raw_ = false;
        return true;
    }
    /// Nothing is to be executed before the token that comes next, or it has been.
    bool plain_ahead() { return has_ahead_ ? !ahead_raw_ : fetch_plain(); }
    /// The next token of the text, leaving finished macros and files; throws at Options::most_tokens.
    const Token& advance()
    {
        Cursor& cursor = cursors_.back();
        if (cursor.position >= cursor.end || left_ == 0) return advance_further();
        --left_;
        return cursor.tokens[cursor.position++];
    }
    const Token& advance_further();
    void allow_more(const Token& next);
    /// inner: what is open in a block at work. token_profile.cpp
    void spend_time(std::span<const ReadingProfile::Place> inner = {});
    ReadingPlace described(const ReadingProfile::Place& place) const;
    const Token* innermost_loop() const;
    void leave_cursor();
    bool is_macro(const Token& token) const;
    const Token& new_word(const Token& token) const;
    std::string why_no_word(const Token& token) const;
    Kind at_pseudo_scope();  ///< Local at `local.`, Global at `global.`; else EndOfText
    Cell in_scope(Kind scope, std::uint32_t name) const;
    Kind read_pseudo_name(Token& name);
    template <class Read>
    bool look_into_brackets(const Cursor& in, std::uint32_t& at, Read&& read);
    std::optional<std::string> key_ahead(const Cursor& in, std::uint32_t& at);
    const Value* element_ahead(const Array& array, const Cursor& in, std::uint32_t& at);
    SourceFile& file() { return *files_[cursors_.back().file]; }
    const Token& raw_next();
    void execute_directive();  ///< the cursor stands behind a Hash
    bool execute(Kind word, std::uint32_t hash);
    [[noreturn]] void fail_bad(const Token& token);
    [[noreturn]] void fail_expected_at(const Token& found, std::string_view what, std::string_view more = "");
    std::string line_of(
        const scene::SourceRef& at) const;  ///< "line 3", or "line 3 of x.inc" if the text that is read is another

    // conditionals.cpp, loops.cpp; `hash` is the index of the directive's Hash in the file being read
    double condition();
    bool read_ifdef();
    void begin_if(std::uint32_t hash, bool (TokenStream::*test)(), bool wanted);
    bool read_if();
    void begin_switch(std::uint32_t hash);
    void next_case(Kind word, std::uint32_t hash);
    void else_branch(std::uint32_t hash);
    void end_block(std::uint32_t hash);
    void break_block(std::uint32_t hash);
    Kind next_branch();
    Kind scan_for_branch();
    void skip_to_end();
    void check_skipped(std::uint32_t begin, std::uint32_t end);
    Block block(BlockKind kind, std::uint32_t hash) const;
    void push_block(const Block& block);
    void begin_while(std::uint32_t hash);
    void begin_for(std::uint32_t hash);
    void end_while(std::uint32_t hash);
    void end_for(std::uint32_t hash);
    void leave_loop(std::uint32_t hash_of_loop);

    // macros.cpp
    void define_macro(std::uint32_t hash);
    void call_macro(const Token& name, const Macro& macro);
    Cell argument(std::uint32_t scope, bool is_last);
    void end_of_argument(const Cell& given);
    static bool may_go_on(const Value& value);
    bool element_ahead() const;
    Cell taken_instead(const Token& first, const Value& named);
    void check_uncalled(const Value& value);
    bool left_out();
    void enter_macro(const Token& name, const Macro& macro, std::size_t first_argument);

    // blocks/sites.cpp
    bool find_compiled(int requested, bool full, Tuple& out);
    bool declare_compiled(bool local);
    Cell argument_compiled(std::uint32_t scope);

    // declarations.cpp
    void declare(bool local);
    DeclarationTarget read_declaration_target();
    void store(const DeclarationTarget& target, Value value, bool local, std::uint32_t scope);
    void declare_several(bool local);
    void set_element(Array& array, const Cell& element, Value value, const Token& name);
    Deprecation read_deprecation();
    void warn_deprecated(const Token& name);
    void undefine();
    void set_version(std::uint32_t hash);
    bool nothing_before(std::uint32_t hash) const;
    void end_declaration(bool numeric);
    Value read_identifier_value(Named* named);
    Cell element_cell(const std::shared_ptr<Array>& array, const Token& name, bool may_create);
    Cell member_cell(const std::shared_ptr<Dictionary>& dictionary, const Token& name, bool may_create);
    std::string read_key();
    std::shared_ptr<Dictionary> read_dictionary();
    std::shared_ptr<Array> read_array();
    void read_elements(Array& array, std::size_t dimension, std::size_t& at);
    Value read_element(bool is_last);
    void refuse_directive_in_array();

    // files.cpp
    void include();
    std::vector<std::string> searched_folders() const;
    std::string nearest_file(const std::string& name, const std::vector<std::string>& folders,
                             std::string_view extension) const;
    std::string where_searched() const;  ///< " in the current folder, '/usr/share/...'"
    const char* why_not_found() const;   ///< the end of a message about a file
    std::uint16_t loaded(const std::string& path, const scene::SourceRef& at);
    void include_named(const std::string& name, const Token& call, const scene::SourceRef& at);
    void message_directive(Kind kind);
    std::uint16_t load(const std::string& path, std::string text, bool main_text, std::string_view elsewhere = {});
    void open_main(std::uint16_t file, const std::string& path);
    void predefine();
    /// message() with the source line and how it was reached.
    scene::Message located(Severity severity, const scene::SourceRef& at, std::string_view text) const;
    void warn_as_written(const scene::SourceRef& at, const std::string& text);
    void report(scene::Message message);
    void tell_of_closed_blocks();

    // data_files.cpp
    void open_data_file();
    void close_data_file();
    void forget_text(const std::string& path);
    void read_data();
    void write_data();
    std::shared_ptr<DataFile> data_file(Token& name, bool reading);
    Cell read_target();
    Tuple written_value();

    Options options_;
    GrammarHooks& hooks_;
    MessageSink sink_;
    void* sink_context_;
    Names names_;
    std::unordered_map<std::string, std::uint16_t> loaded_;
    /// By what #include calls it and the file that includes; forgotten when a file is opened.
    std::unordered_map<std::string, std::uint16_t> included_;
    std::string scene_folder_;
    std::unique_ptr<blocks::Runner> runner_;
    std::vector<std::shared_ptr<const Macro>> macros_;  // all there ever were: one may be redefined while it is called
    std::vector<Cell> arguments_;                       // of the macro calls that are being read
    std::vector<Cursor> cursors_;
    std::vector<Block> blocks_;
    Symbols symbols_;
    const Token* ahead_ = &kNoToken;  ///< tokens of files never move
    const Token* last_ = &kNoToken;
    bool has_ahead_ = false, ahead_raw_ = false, raw_operators_ = false;
    bool statements_ = false;  ///< what is fetched may be a statement of the grammar
    std::uint64_t taken_ = 0;
    std::uint64_t left_ = 0, later_ = 0;  ///< tokens that may be read before allow_more(), and after
    scene::SourceRef told_brace_;         ///< that the text of the next message tells of
    int nesting_ = 0;
    LanguageState language_;
    std::uint32_t declaring_ = kNoIndex, statement_ = kNoIndex;  ///< a statement: its first token in the main text
    std::vector<scene::SourceRef> open_blocks_;                  ///< of the statement
    std::vector<BlockWarning> block_warnings_;                   ///< held back until their block is closed
    std::unordered_map<std::uint32_t, Deprecation> deprecated_;
    std::vector<std::uint32_t> random_streams_;
    RandomUndo random_undo_{random_streams_};
    std::vector<Message> messages_;
    std::unordered_set<std::string> warned_;  ///< first lines of the warnings so far
    Statistics statistics_;
    ReadingProfile profile_;
    std::vector<ReadingProfile::Place> open_places_;  ///< of spend_time()
    double told_reading_ = 0.0;  ///< seconds of reading when Options::still_reading was last called
    files::ReadFiles read_files_;
    KeptFiles kept_files_;
};

}  // namespace parser

#include "parser/stream/token_stream_templates.h"
