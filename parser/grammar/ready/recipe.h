#pragma once

#include "parser/grammar/core/scene_builder.h"
#include "parser/grammar/objects/solids.h"

#include <memory>
#include <vector>

/// Statements as they are kept: what was written, and the places of the values.
namespace parser {

/// What a recipe is made with.
struct Making {
    SceneBuilder& build;
    const double* values;
    const Symbols& symbols;

    glm::dvec3 vector(std::uint32_t at) const { return {values[at], values[at + 1], values[at + 2]}; }
    /// What a name means, if it is a T.
    template <class T>
    const T* meaning(std::uint32_t name) const
    {
        const Value* const value = symbols.find(name);
        return value ? value->get_if<T>() : nullptr;
    }
};

/// A colour as color_expr() gives it.
struct ColorRecipe {
    std::uint32_t value = 0;
    int components = 5;      ///< at `value`
    bool transmits = false;  ///< the fourth is transmit, not filter
    scene::Color color(const Making& m) const;
};

/// What changes the texture of an object. Textures are never changed in place, so the same change of the same texture
/// gives the texture that it gave before.
class TextureChange {
public:
    virtual ~TextureChange() = default;
    /// False: its tokens have to be read; nothing was done.
    virtual bool apply(const Making& m, scene::TexturePtr& texture) = 0;
};

/// `pigment { COLOR }`
std::unique_ptr<TextureChange> plain_pigment(const ColorRecipe& color, const scene::SourceRef& source);
/// `texture { NAME }`; source: of the token behind the name.
std::unique_ptr<TextureChange> named_texture(std::uint32_t name, const scene::SourceRef& source);

/// `texture { pigment { COLOR } ... }`: `paint` comes last; source: of the token behind the brace.
std::unique_ptr<TextureChange> painted_texture(std::unique_ptr<TextureChange> paint,
                                               std::vector<std::unique_ptr<TextureChange>> others,
                                               const scene::SourceRef& source);
/// A block of a texture from its keyword on, of which everything but the names is known to stay; it is read once for
/// what they mean.
std::unique_ptr<TextureChange> kept_block(const Token* begin, const Token* end, std::vector<std::uint32_t> names);

/// A modifier of an object.
struct ModifierRecipe {
    Kind keyword = Kind::EndOfText;
    std::uint32_t value = 0;                ///< translate, rotate, scale
    std::uint32_t name = kNoIndex;          ///< transform
    std::unique_ptr<TextureChange> change;  ///< texture, pigment, normal, finish
    bool varies = false;                    ///< it may be another each time
    bool apply(const Making& m, scene::Object& object) const;
};

struct ObjectRecipe {
    const SolidForm* solid = nullptr;
    Kind keyword = Kind::EndOfText;  ///< Identifier: a name alone
    scene::SourceRef source;
    std::uint32_t name = kNoIndex;  ///< of the object that it is a copy of
    std::uint32_t value = 0;        ///< solid: its first
    bool open = false;
    std::vector<ObjectRecipe> operands;  ///< of CSG; `object { }`: the object in it
    std::vector<ModifierRecipe> modifiers;
    /// `object` is new. False: its tokens have to be read.
    bool make(const Making& m, scene::Object& object) const;

private:
    bool make_shape(const Making& m, scene::Object& object) const;
    bool make_operands(const Making& m, scene::Object& object) const;
};

bool apply_modifiers(const std::vector<ModifierRecipe>& modifiers, const Making& m, scene::Object& object);

}  // namespace parser
