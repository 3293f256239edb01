#include "parser/grammar.h"
#include "parser/lexer/lexer.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <string>

using parser::Form;
using parser::Kind;

namespace {

void add_words(const Form& form, std::set<Kind>& words)
{
    if (form.is == Form::Is::Word) words.insert(form.word);
    for (const Form& part : form.parts) add_words(part, words);
}

/// Reserved, but read nowhere.
const std::set<std::string> kUnused = {
    "breakpoint", "distance_maximum", "sblue", "sgreen", "sred", "steps",
};

}  // namespace

TEST_CASE("every reserved word that means something stands in the grammar", "[grammar][form]")
{
    std::set<Kind> words;
    for (const parser::Production& one : parser::grammar()) add_words(one.form, words);
    std::set<std::string> missing;
    for (std::size_t i = 0; i < parser::kKindCount; ++i) {
        const Kind kind = static_cast<Kind>(i);
        if (parser::is_keyword(kind) && !words.contains(kind)) missing.insert(std::string(parser::spelling(kind)));
    }
    CHECK(missing == kUnused);
}

TEST_CASE("the grammar as text names each production once and nothing that is none", "[grammar][form]")
{
    const auto& all = parser::grammar();
    REQUIRE(all.size() > 60);
    CHECK(all.front().name == "scene");
    std::set<std::string_view> names;
    for (const parser::Production& one : all) {
        INFO(one.name);
        CHECK(names.insert(one.name).second);
    }
    const std::string text = "\n" + parser::ebnf(all);
    for (const parser::Production& one : all) {
        INFO(one.name);
        const std::string head = "\n" + std::string(one.name) + " ::=";
        CHECK(text.find(head) != std::string::npos);
        CHECK(text.find(head) == text.rfind(head));
    }
    CHECK(text.find("finish_block ::=\n    '{' identifier? (") != std::string::npos);
    CHECK(text.find("'phong' 'albedo'? number") != std::string::npos);
}
