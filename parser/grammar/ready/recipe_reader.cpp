#include "parser/grammar/ready/recipe_reader.h"

#include "parser/lexer/color_word.h"

#include <algorithm>

namespace parser {

using DeclaredObject = std::shared_ptr<const scene::Object>;

namespace {

/// Whether the word means the same each time it is read.
bool tells_the_same(Kind kind)
{
    switch (kind) {
    case Kind::EndOfText:
    case Kind::Bad:
    case Kind::Hash:
    case Kind::Rand:
    case Kind::Now:
    case Kind::Trace:
    case Kind::Inside:
    case Kind::FileExists:
    case Kind::Function:
    case Kind::Object:
    case Kind::Local: return false;
    default: return !color_word(kind).encoded;
    }
}

/// Whether the value is changed by nothing but a declaration of its name.
bool stays(const Value& value)
{
    return value.set() && !is_container(value) && !value.get_if<std::shared_ptr<const Macro>>() &&
           !value.get_if<std::shared_ptr<DataFile>>();
}

/// `composite` is left out: it warns each time it is read.
bool is_csg(Kind keyword) { return keyword != Kind::Composite && csg_op(keyword); }

bool changes_part(const ModifierRecipe& one)
{
    return one.keyword == Kind::Pigment || one.keyword == Kind::Finish || one.keyword == Kind::Normal;
}

/// Pigment, finish and normal are parts of one texture, so their order does not matter: what is kept comes first, where
/// the texture before it is the same each time.
void put_kept_first(std::vector<ModifierRecipe>& all)
{
    for (auto begin = all.begin(); begin != all.end();) {
        auto end = begin;
        while (end != all.end() && changes_part(*end) &&
               std::none_of(begin, end, [&](const ModifierRecipe& one) { return one.keyword == end->keyword; }))
            ++end;
        std::stable_partition(begin, end, [](const ModifierRecipe& one) { return !one.varies; });
        begin = end == begin ? begin + 1 : end;
    }
}

}  // namespace

bool RecipeReader::value(int components, bool full, std::uint32_t& first)
{
    const auto place = tokens_.expression(components, full);
    if (place) first = *place;
    return place.has_value();
}

bool RecipeReader::values(std::string_view form, std::uint32_t& first)
{
    for (std::size_t i = 0; i < form.size(); ++i) {
        std::uint32_t place = 0;
        if (i > 0) tokens_.accept(Kind::Comma);
        if (!value(form[i] == 'v' ? 3 : form[i] == 'p' ? 2 : 1, false, place)) return false;
        if (i == 0) first = place;
    }
    return true;
}

/// A name alone that means a T.
template <class T>
bool RecipeReader::name(std::uint32_t& out)
{
    if (tokens_.kind() != Kind::Identifier) return false;
    const Value* const value = tokens_.meaning(tokens_.ahead());
    if (!value || !value->get_if<T>()) return false;
    out = tokens_.take().name;
    return tokens_.kind() != Kind::LeftSquare && tokens_.kind() != Kind::Period;
}

bool RecipeReader::object(ObjectRecipe& out)
{
    if (depth_ > kDeepest) return false;
    out.source = tokens_.here();
    out.keyword = tokens_.kind();
    if (out.keyword == Kind::Identifier) return name<DeclaredObject>(out.name);
    out.solid = solid_form(out.keyword);
    if (out.keyword == Kind::Torus && build_.stream().povray() == scene::PovRay::V38)
        return false;  // more is asked of it than its numbers
    const bool csg_word = is_csg(out.keyword);
    if (!out.solid && !csg_word && out.keyword != Kind::Object) return false;
    tokens_.take();
    if (!tokens_.accept(Kind::LeftBrace)) return false;
    ++depth_;
    const bool head = out.solid ? solid(out) : csg_word ? csg(out) : wrapper(out);
    --depth_;
    return head && modifiers(out.modifiers, true);
}

bool RecipeReader::solid(ObjectRecipe& out)
{
    if (const Value* const value = tokens_.kind() == Kind::Identifier ? tokens_.meaning(tokens_.ahead()) : nullptr;
        value && value->get_if<DeclaredObject>())
        return name<DeclaredObject>(out.name);
    if (tokens_.kind() == Kind::Numbers) {
        const auto place = tokens_.numbers(3 * out.solid->values.size());
        if (place) out.value = *place;
        return place.has_value();
    }
    if (!values(out.solid->values, out.value)) return false;
    out.open = out.solid->may_be_open && tokens_.accept(Kind::Open);
    if (out.keyword == Kind::Disc) tokens_.accept(Kind::Comma);
    return true;
}

bool RecipeReader::csg(ObjectRecipe& out)
{
    if (const Value* const value = tokens_.kind() == Kind::Identifier ? tokens_.meaning(tokens_.ahead()) : nullptr;
        value && value->get_if<DeclaredObject>())
        return name<DeclaredObject>(out.name);
    for (;;) {
        const Kind next = tokens_.kind();
        if (next != Kind::Identifier && next != Kind::Object && !is_csg(next) && !solid_form(next)) break;
        if (!object(out.operands.emplace_back())) return false;
    }
    return out.operands.size() >= 2;
}

bool RecipeReader::wrapper(ObjectRecipe& out) { return object(out.operands.emplace_back()); }

/// Whether a keyword stands alone that may have a number.
bool RecipeReader::no_number_follows() const
{
    const Kind next = tokens_.kind();
    return next == Kind::RightBrace || (is_keyword(next) && lexical_class(next) == LexicalClass::None);
}

bool RecipeReader::color(ColorRecipe& out)
{
    tokens_.accept(Kind::Color);
    const ColorWord word = color_word(tokens_.kind());
    if (word.components == 0 || word.encoded) return false;
    out.transmits = word.transmits;
    tokens_.take();
    const auto place = tokens_.expression(word.components, true);
    if (!place) return false;
    out.value = *place;
    out.components = word.components;
    return true;
}

/// `{ COLOR }`
std::unique_ptr<TextureChange> RecipeReader::pigment()
{
    if (!tokens_.accept(Kind::LeftBrace)) return nullptr;
    const scene::SourceRef source = tokens_.here();
    ColorRecipe made;
    return color(made) && tokens_.accept(Kind::RightBrace) ? plain_pigment(made, source) : nullptr;
}

/// `{ NAME }`
std::unique_ptr<TextureChange> RecipeReader::texture()
{
    std::uint32_t named = kNoIndex;
    if (!tokens_.accept(Kind::LeftBrace) || !name<scene::TexturePtr>(named)) return nullptr;
    const scene::SourceRef source = tokens_.here();
    return tokens_.accept(Kind::RightBrace) ? named_texture(named, source) : nullptr;
}

/// `{ pigment { COLOR } finish { ... } normal { ... } }`, each once, in any order.
std::unique_ptr<TextureChange> RecipeReader::painted_texture()
{
    if (!tokens_.accept(Kind::LeftBrace)) return nullptr;
    const scene::SourceRef source = tokens_.here();
    std::unique_ptr<TextureChange> paint;
    std::vector<std::unique_ptr<TextureChange>> others;
    bool finish = false, normal = false;
    while (!tokens_.accept(Kind::RightBrace)) {
        const Kind keyword = tokens_.kind();
        bool& seen = keyword == Kind::Finish ? finish : normal;
        if (keyword == Kind::Pigment) {
            tokens_.take();
            if (paint || !(paint = pigment())) return nullptr;
        } else {
            if ((keyword != Kind::Finish && keyword != Kind::Normal) || seen) return nullptr;
            seen = true;
            if (!others.emplace_back(kept_block())) return nullptr;
        }
    }
    return paint ? parser::painted_texture(std::move(paint), std::move(others), source) : nullptr;
}

/// A block whose text says the same as long as the names in it mean the same.
std::unique_ptr<TextureChange> RecipeReader::kept_block()
{
    const Token* const begin = &tokens_.take();
    if (build_.changing_blocks.contains(begin) || tokens_.kind() != Kind::LeftBrace) return nullptr;
    std::vector<std::uint32_t> names;
    for (int depth = 0;;) {
        const Kind next = tokens_.kind();
        if (!tells_the_same(next)) return nullptr;
        const Token& token = tokens_.take();
        if (next == Kind::Identifier) {
            const Value* const value = tokens_.meaning(token);
            if (!value || !stays(*value)) return nullptr;
            names.push_back(token.name);
        }
        depth += next == Kind::LeftBrace ? 1 : next == Kind::RightBrace ? -1 : 0;
        if (depth == 0) return parser::kept_block(begin, &token + 1, std::move(names));
    }
}

bool RecipeReader::texture_change(ModifierRecipe& out)
{
    const bool pigments = out.keyword == Kind::Pigment;
    if (out.keyword == Kind::Finish || out.keyword == Kind::Normal) {
        out.change = kept_block();
        return out.change != nullptr;
    }
    const auto before = tokens_.mark();
    tokens_.take();
    out.change = pigments ? pigment() : texture();
    if (!out.change && !pigments) {
        tokens_.back_to(before);
        tokens_.take();
        out.change = painted_texture();
    }
    if (!out.change) {
        tokens_.back_to(before);
        out.change = kept_block();
    } else {
        out.varies = true;
    }
    return out.change != nullptr;
}

bool RecipeReader::modifier(ModifierRecipe& out, bool all)
{
    out.keyword = tokens_.kind();
    if (!is_keyword(out.keyword)) return false;
    switch (out.keyword) {
    case Kind::Pigment:
    case Kind::Texture:
    case Kind::Finish:
    case Kind::Normal: return texture_change(out);
    default: tokens_.take();
    }
    switch (out.keyword) {
    case Kind::Translate:
    case Kind::Rotate:
    case Kind::Scale: return value(3, false, out.value);
    case Kind::Transform: {
        using Shared = std::shared_ptr<const csg::Transform>;
        const bool braces = tokens_.accept(Kind::LeftBrace);
        return name<Shared>(out.name) && (!braces || tokens_.accept(Kind::RightBrace));
    }
    case Kind::NoShadow: return all;
    case Kind::NoImage:
    case Kind::NoReflection:
    case Kind::Hollow: return all && no_number_follows();
    default: return false;
    }
}

bool RecipeReader::modifiers(std::vector<ModifierRecipe>& out, bool all)
{
    while (!tokens_.accept(Kind::RightBrace))
        if (!modifier(out.emplace_back(), all)) return false;
    put_kept_first(out);
    return true;
}

}  // namespace parser
