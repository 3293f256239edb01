#include "language/places/place_words.h"

#include "parser/grammar.h"

#include <algorithm>
#include <map>
#include <set>

/// Words by place, told from the productions of the grammar.
namespace language {
namespace {

using parser::Form;
using parser::Kind;
using parser::LexicalClass;
using parser::Production;
using Words = std::vector<std::string>;
using Named = std::set<Production (*)()>;
/// What stands in the braces behind each keyword, in order.
using Blocks = std::map<Kind, std::vector<Form>>;

void add_word(Words& words, Kind kind)
{
    std::string word(parser::spelling(kind));
    if (parser::is_keyword(kind) && std::find(words.begin(), words.end(), word) == words.end())
        words.push_back(std::move(word));
}

bool is_brace(const Form& form, Kind kind) { return form.is == Form::Is::Word && form.word == kind; }

/// One past the brace that closes the one at `at`.
std::size_t behind_braces(const std::vector<Form>& parts, std::size_t at)
{
    for (int depth = 0; at < parts.size(); ++at) {
        depth += is_brace(parts[at], Kind::LeftBrace) ? 1 : is_brace(parts[at], Kind::RightBrace) ? -1 : 0;
        if (depth == 0) return at + 1;
    }
    return at;
}

bool begins_with_brace(const Form& form)
{
    return is_brace(form, Kind::LeftBrace) ||
           (form.is == Form::Is::Sequence && !form.parts.empty() && begins_with_brace(form.parts.front()));
}

/// Expressions are asked for by other means; of colours the words alone count.
bool is_expression(std::string_view production)
{
    return production == "sum" || production == "condition" || production == "text";
}

/// Words that a form may begin with; false: something has to stand there.
bool add_first_words(Words& words, const Form& form, Named& seen)
{
    if (form.rare) return false;
    switch (form.is) {
    case Form::Is::Word: add_word(words, form.word); return false;
    case Form::Is::Operand: return false;
    case Form::Is::Named: {
        if (!seen.insert(form.production).second) return false;
        const Production inner = form.production();
        return !is_expression(inner.name) && add_first_words(words, inner.form, seen);
    }
    case Form::Is::Sequence:
        return std::all_of(form.parts.begin(), form.parts.end(),
                           [&](const Form& part) { return add_first_words(words, part, seen); });
    default: break;
    }
    bool empty = form.is != Form::Is::Choice && form.least == 0;
    for (const Form& part : form.parts) empty = add_first_words(words, part, seen) || empty;
    return empty;
}

/// Words that may stand in a block: each of its items begins with one. Values of items do not count.
void add_words(Words& words, const Form& form, Named& seen)
{
    if (form.rare) return;
    if (form.is == Form::Is::Word) return add_word(words, form.word);
    if (form.is == Form::Is::Named) {
        if (!seen.insert(form.production).second) return;
        const Production inner = form.production();
        if (!is_expression(inner.name)) add_words(words, inner.form, seen);
    }
    for (const Form& part : form.parts) {
        add_words(words, part, seen);
        if (form.is == Form::Is::Sequence && part.is == Form::Is::Word && parser::is_keyword(part.word)) return;
    }
}

/// What may follow a keyword within a form, by its first words.
void add_words_behind(Words& words, const Form& form, Kind keyword, Named& seen)
{
    if (form.is == Form::Is::Named && seen.insert(form.production).second) {
        const Form inner = form.production().form;
        if (!begins_with_brace(inner)) add_words_behind(words, inner, keyword, seen);
    }
    for (std::size_t i = 0; i < form.parts.size(); ++i) {
        if (form.is != Form::Is::Sequence || form.parts[i].is != Form::Is::Word) {
            add_words_behind(words, form.parts[i], keyword, seen);
        } else if (form.parts[i].word == Kind::LeftBrace) {
            i = behind_braces(form.parts, i) - 1;
        } else if (form.parts[i].word == keyword) {
            Named begun;
            for (std::size_t k = i + 1; k < form.parts.size() && add_first_words(words, form.parts[k], begun); ++k) {}
        }
    }
}

/// Blocks that stand in a form, but not within other blocks. `last`: the keyword before it.
void add_blocks(Blocks& blocks, const Form& form, Kind last, Named& seen)
{
    if (form.is == Form::Is::Named) {
        const Form inner = form.production().form;
        if (begins_with_brace(inner) || seen.insert(form.production).second) add_blocks(blocks, inner, last, seen);
        return;
    }
    for (std::size_t i = 0; i < form.parts.size(); ++i) {
        const Form& part = form.parts[i];
        if (form.is == Form::Is::Sequence && is_brace(part, Kind::LeftBrace)) {
            const std::size_t end = behind_braces(form.parts, i);
            Form inside;
            inside.parts.assign(form.parts.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                form.parts.begin() + static_cast<std::ptrdiff_t>(end) - 1);
            blocks[last].push_back(std::move(inside));
            i = end - 1;
        } else {
            add_blocks(blocks, part, last, seen);
            if (form.is == Form::Is::Sequence && part.is == Form::Is::Word && parser::is_keyword(part.word))
                last = part.word;
        }
    }
}

Blocks blocks_of(const Form& form)
{
    Blocks blocks;
    Named seen;
    add_blocks(blocks, form, Kind::EndOfText, seen);
    return blocks;
}

/// The blocks in the block of each keyword; EndOfText: outside of all.
class Places {
public:
    Places() { explore(Kind::EndOfText, parser::grammar().front().form); }
    /// What stands in a block; null: nothing is known. Where the block around it has no such one, or none is known, as
    /// in a macro, a word means most likely what it means for an object.
    const Form* inside(Kind block, Kind outer) const
    {
        for (const Kind around : {outer, Kind::EndOfText, Kind::Sphere})
            if (const Form* found = in(around, block)) return found;
        for (const auto& [around, blocks] : within_)
            if (const Form* found = in(around, block)) return found;
        return nullptr;
    }

private:
    std::map<Kind, Blocks> within_;

    const Form* in(Kind around, Kind block) const
    {
        const auto blocks = within_.find(around);
        if (blocks == within_.end()) return nullptr;
        const auto found = blocks->second.find(block);
        return found == blocks->second.end() ? nullptr : &found->second.front();
    }
    void explore(Kind around, const Form& form)
    {
        for (auto& [keyword, bodies] : blocks_of(form)) {
            std::vector<Form>& known = within_[around][keyword];
            if (!known.empty()) continue;
            known = bodies;
            for (const Form& body : bodies) explore(keyword, body);
        }
    }
};

const Form& production(std::string_view name)
{
    const auto& all = parser::grammar();
    return std::find_if(all.begin(), all.end(), [&](const Production& one) { return one.name == name; })->form;
}

/// Words of the lexer's classes, then those that a production begins with.
Words beginnings(std::initializer_list<LexicalClass> classes, std::initializer_list<std::string_view> productions)
{
    Words words;
    for (std::size_t i = 0; i < parser::kKindCount; ++i)
        if (std::find(classes.begin(), classes.end(), parser::lexical_class(static_cast<Kind>(i))) != classes.end())
            add_word(words, static_cast<Kind>(i));
    for (const std::string_view name : productions) {
        Named seen;
        add_first_words(words, production(name), seen);
    }
    return words;
}

const Places& places()
{
    static const Places all;
    return all;
}

}  // namespace

const Words& directive_words()
{
    static const Words words = [] {
        Words all;
        Named seen;
        const Form& directive = production("directive");
        add_first_words(all, directive.parts[1], seen);
        return all;
    }();
    return words;
}

const Words& scene_words()
{
    static const Words words = beginnings({}, {"scene"});
    return words;
}

const Words& number_words()
{
    static const Words words = beginnings(
        {LexicalClass::Float, LexicalClass::Vector, LexicalClass::Vector2, LexicalClass::Vector4, LexicalClass::String},
        {});
    return words;
}

const Words& value_words()
{
    static const Words words = beginnings({LexicalClass::Float, LexicalClass::Vector, LexicalClass::Vector2,
                                           LexicalClass::Vector4, LexicalClass::String, LexicalClass::Color},
                                          {"value"});
    return words;
}

Words block_words(Kind block, Kind outer)
{
    Words words;
    Named seen;
    if (const Form* const inside = places().inside(block, outer)) add_words(words, *inside, seen);
    if (block == Kind::Function) {
        // An expression of numbers may begin there.
        const Words numbers = beginnings({LexicalClass::Float, LexicalClass::Vector2}, {});
        words.insert(words.end(), numbers.begin(), numbers.end());
        for (const Kind axis : {Kind::X, Kind::Y, Kind::Z}) add_word(words, axis);
    }
    return words;
}

Words words_behind(Kind keyword, Kind block, Kind outer)
{
    Words words;
    Named seen;
    if (const Form* const inside = places().inside(block, outer)) add_words_behind(words, *inside, keyword, seen);
    return words;
}

std::string_view keyword_line(Kind keyword)
{
    static const std::map<Kind, std::string_view> lines = {
#define WHITTLE_LINE(kind, line) {Kind::kind, line},
#include "language/places/keyword_lines.inc"
#undef WHITTLE_LINE
    };
    const auto found = lines.find(keyword);
    return found == lines.end() ? std::string_view() : found->second;
}

}  // namespace language
