#pragma once

#include "parser/grammar/ready/recipe.h"

namespace parser {

/// Makes recipes of statements, reading their tokens as the grammar does. Its functions return false at anything that
/// recipes do not cover; the statement is then read as tokens each time.
class RecipeReader {
public:
    RecipeReader(StatementReader& tokens, SceneBuilder& build) : tokens_(tokens), build_(build) {}

    bool object(ObjectRecipe& out);
    /// Modifiers up to the closing brace, which is taken too. `all`: those of any object, else only those of a blob's
    /// component.
    bool modifiers(std::vector<ModifierRecipe>& out, bool all);
    /// Values of the kinds that SolidForm::values lists (v: a vector, p: two numbers, others: a number); `first`: the
    /// place of the first among the block's values.
    bool values(std::string_view form, std::uint32_t& first);
    StatementReader& tokens() { return tokens_; }

private:
    static constexpr int kDeepest = 12;
    bool solid(ObjectRecipe& out);
    bool csg(ObjectRecipe& out);
    bool wrapper(ObjectRecipe& out);
    template <class T>
    bool name(std::uint32_t& out);
    bool modifier(ModifierRecipe& out, bool all);
    bool texture_change(ModifierRecipe& out);
    std::unique_ptr<TextureChange> pigment();
    std::unique_ptr<TextureChange> texture();
    std::unique_ptr<TextureChange> painted_texture();
    std::unique_ptr<TextureChange> kept_block();
    bool color(ColorRecipe& out);
    bool value(int components, bool full, std::uint32_t& first);
    bool no_number_follows() const;

    StatementReader& tokens_;
    SceneBuilder& build_;
    int depth_ = 0;
};

}  // namespace parser
