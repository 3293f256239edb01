#include "parser/grammar/ready/recipe.h"

#include <cstring>
#include <utility>

/// Changes of textures; each keeps the last texture that it made.
namespace parser {
namespace {

using TextureLayers = std::vector<scene::Layer>;

class PlainPigment final : public TextureChange {
public:
    PlainPigment(const ColorRecipe& color, const scene::SourceRef& source) : color_(color), source_(source) {}

    bool apply(const Making& m, scene::TexturePtr& texture) override
    {
        const scene::TexturePtr& before = texture ? texture : m.build.default_texture();
        const scene::Color color = color_.color(m);
        if (before != before_ || std::memcmp(&color, &last_color_, sizeof(color)) != 0) {
            if (!std::holds_alternative<TextureLayers>(before->kind)) return false;
            const auto copy = std::make_shared<scene::Texture>(*before);
            scene::Pigment& pigment = std::get<TextureLayers>(copy->kind).back().pigment;
            pigment.kind = color;
            pigment.source = source_;
            before_ = before;
            last_color_ = color;
            made_ = copy;
        }
        texture = made_;
        return true;
    }

private:
    ColorRecipe color_;
    scene::SourceRef source_;
    scene::TexturePtr before_, made_;
    scene::Color last_color_;
};

class NamedTexture final : public TextureChange {
public:
    NamedTexture(std::uint32_t name, const scene::SourceRef& source) : name_(name), source_(source) {}

    bool apply(const Making& m, scene::TexturePtr& texture) override
    {
        const auto* const declared = m.meaning<scene::TexturePtr>(name_);
        if (!declared) return false;
        if (*declared != declared_ || texture != below_) {
            const auto plain = [](const scene::TexturePtr& one) {
                return std::holds_alternative<TextureLayers>(one->kind);
            };
            if (!plain(*declared) || (texture && !plain(texture))) return false;
            const auto copy = std::make_shared<scene::Texture>(**declared);
            copy->source = source_;
            declared_ = *declared;
            below_ = texture;
            made_ = layered(m.build, texture, copy, source_);
        }
        texture = made_;
        return true;
    }

private:
    std::uint32_t name_;
    scene::SourceRef source_;
    scene::TexturePtr declared_, below_, made_;
};

class PaintedTexture final : public TextureChange {
public:
    PaintedTexture(std::unique_ptr<TextureChange> paint, std::vector<std::unique_ptr<TextureChange>> others,
                   const scene::SourceRef& source)
        : paint_(std::move(paint)), others_(std::move(others)), source_(source)
    {}

    bool apply(const Making& m, scene::TexturePtr& texture) override
    {
        if (texture && !std::holds_alternative<TextureLayers>(texture->kind)) return false;
        scene::TexturePtr made = m.build.default_texture();
        for (const auto& one : others_)
            if (!one->apply(m, made)) return false;
        if (!paint_->apply(m, made)) return false;
        if (made != painted_) {
            const auto copy = std::make_shared<scene::Texture>(*made);
            copy->source = source_;
            painted_ = made;
            made_ = copy;
        }
        texture = texture ? layered(m.build, texture, made_, source_) : made_;
        return true;
    }

private:
    std::unique_ptr<TextureChange> paint_;
    std::vector<std::unique_ptr<TextureChange>> others_;
    scene::SourceRef source_;
    scene::TexturePtr painted_, made_;
};

/// Whether a name means what it meant: the same numbers or text, or the same thing in memory.
bool same_meaning(const Value& a, const Value& b)
{
    if (a.index() != b.index()) return false;
    return std::visit(
        [&]<class T>(const T& one) {
            const T& other = *b.get_if<T>();
            if constexpr (std::is_same_v<T, Tuple>)
                return one.count == other.count && std::memcmp(one.at.data(), other.at.data(), sizeof(one.at)) == 0;
            else return one == other;
        },
        static_cast<const Value::variant&>(a));
}

class KeptBlock final : public TextureChange {
public:
    KeptBlock(const Token* begin, const Token* end, std::vector<std::uint32_t> names)
        : begin_(begin), end_(end), names_(std::move(names)), meanings_(names_.size())
    {}

    bool apply(const Making& m, scene::TexturePtr& texture) override
    {
        if (!as_before(m, texture)) {
            // Read by itself only if the reader of tokens has done it with the same texture and names: it may fail.
            made_ = nullptr;
            constexpr int kMostChanges = 2;  // before blocks are compiled again
            if (++changes_ > kMostChanges) m.build.changing_blocks.insert(begin_);
            return false;
        }
        if (!made_) {
            scene::Object object;
            object.texture = texture;
            m.build.stream().read_again(begin_, end_, [&] { read_modifier(m.build, object); });
            made_ = std::move(object.texture);
        }
        changes_ = 0;
        texture = made_;
        return true;
    }

private:
    /// Whether texture and names are those of the last time; notes them.
    bool as_before(const Making& m, const scene::TexturePtr& texture)
    {
        bool same = known_ && texture == before_ && m.build.default_texture() == default_;
        before_ = texture;
        default_ = m.build.default_texture();
        known_ = true;
        for (std::size_t i = 0; i < names_.size(); ++i) {
            const Value* const value = m.symbols.find(names_[i]);
            if (!value) return known_ = false;
            if (same_meaning(*value, meanings_[i])) continue;
            meanings_[i] = *value;
            same = false;
        }
        return same;
    }

    const Token *begin_, *end_;
    std::vector<std::uint32_t> names_;
    std::vector<Value> meanings_;
    scene::TexturePtr before_, default_, made_;
    bool known_ = false;
    int changes_ = 0;
};

}  // namespace

std::unique_ptr<TextureChange> painted_texture(std::unique_ptr<TextureChange> paint,
                                               std::vector<std::unique_ptr<TextureChange>> others,
                                               const scene::SourceRef& source)
{
    return std::make_unique<PaintedTexture>(std::move(paint), std::move(others), source);
}

std::unique_ptr<TextureChange> kept_block(const Token* begin, const Token* end, std::vector<std::uint32_t> names)
{
    return std::make_unique<KeptBlock>(begin, end, std::move(names));
}

scene::Color ColorRecipe::color(const Making& m) const
{
    Tuple tuple{{}, 5};
    for (std::size_t i = 0; i < static_cast<std::size_t>(components); ++i) tuple.at[i] = m.values[value + i];
    if (transmits) std::swap(tuple.at[3], tuple.at[4]);
    return tuple.color();
}

std::unique_ptr<TextureChange> plain_pigment(const ColorRecipe& color, const scene::SourceRef& source)
{
    return std::make_unique<PlainPigment>(color, source);
}

std::unique_ptr<TextureChange> named_texture(std::uint32_t name, const scene::SourceRef& source)
{
    return std::make_unique<NamedTexture>(name, source);
}

}  // namespace parser
