#pragma once

#include "parser/grammar/ready/recipe.h"

namespace parser {

/// Looks at the tokens of a statement as the grammar reads them. Everything that is not known gives false.
class RecipeReader {
public:
    RecipeReader(StatementReader& tokens, SceneBuilder& build) : tokens_(tokens), build_(build) {}

    bool object(ObjectRecipe& out);
    /// Up to the closing brace, which is taken too. `all`: else only those of a blob's component.
    bool modifiers(std::vector<ModifierRecipe>& out, bool all);
    /// Values as SolidForm::values says (p: two numbers), the place of the first.
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
