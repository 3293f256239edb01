#include "parser/grammar/core/receiver.h"
#include "parser/grammar/ready/recipe_reader.h"
#include "render/scene/solids.h"

#include <array>

/// What is prepared where: objects, components of blobs, faces of meshes.
namespace parser {
namespace {

class ReadyObject final : public ReadyStatement {
public:
    explicit ReadyObject(SceneBuilder& build) : build_(build) {}

    bool read(RecipeReader& reader) { return reader.object(recipe_); }

    bool run(const double* values, const Symbols& symbols) override
    {
        if (!build_.receiver || build_.receiver->form() != Receiver::Form::Object) return false;
        auto& receiver = static_cast<ObjectReceiver&>(*build_.receiver);
        scene::Object& object = receiver.place();
        if (recipe_.make({build_, values, symbols}, object) && receiver.keep()) return true;
        receiver.drop();
        return false;
    }

private:
    SceneBuilder& build_;
    ObjectRecipe recipe_;
};

/// Room for one more. Memory that is not written to yet costs nothing, copies of what is there do: long lists grow by
/// more than others.
template <class T>
void make_room(std::vector<T>& all)
{
    if (all.size() < all.capacity()) return;
    constexpr std::size_t kLong = std::size_t{1} << 18, kLongest = std::size_t{1} << 26;  // bytes
    const std::size_t bytes = all.size() * sizeof(T);
    all.reserve(bytes >= kLong && bytes <= kLongest ? 8 * all.size() : 2 * all.size() + 8);
}

using BlobPart = scene::Blob::Component;

/// A component of a blob.
class ReadyComponent final : public ReadyStatement {
public:
    explicit ReadyComponent(SceneBuilder& build) : build_(build) {}

    bool read(RecipeReader& reader)
    {
        StatementReader& tokens = reader.tokens();
        if (tokens.accept(Kind::Component)) {
            kind_ = BlobPart::Kind::Plain;
            return reader.values("nnv", value_);
        }
        if (tokens.accept(Kind::Cylinder)) kind_ = BlobPart::Kind::Cylinder;
        else if (!tokens.accept(Kind::Sphere)) return false;
        if (!tokens.accept(Kind::LeftBrace)) return false;
        if (!reader.values(kind_ == BlobPart::Kind::Cylinder ? "vvn" : "vn", value_)) return false;
        tokens.accept(Kind::Comma);
        tokens.accept(Kind::Strength);
        return reader.values("n", strength_) && reader.modifiers(modifiers_, false);
    }

    bool run(const double* values, const Symbols& symbols) override
    {
        if (!build_.receiver || build_.receiver->form() != Receiver::Form::Component) return false;
        const Making m{build_, values, symbols};
        BlobPart part;
        part.kind = kind_;
        if (kind_ == BlobPart::Kind::Plain) {
            part.strength = values[value_];
            part.radius = values[value_ + 1];
            part.center = m.vector(value_ + 2);
        } else {
            constexpr double kShortest = 1e-10;  // POV-Ray's (spec 5a, 5.11)
            const bool cylinder = kind_ == BlobPart::Kind::Cylinder;
            part.center = m.vector(value_);
            if (cylinder) part.end = m.vector(value_ + 3);
            if (cylinder && glm::distance(part.center, part.end) < kShortest) return false;
            part.radius = values[value_ + (cylinder ? 6 : 3)];
            part.strength = values[strength_];
            scene::Object modified;
            if (!apply_modifiers(modifiers_, m, modified)) return false;
            part.transform = modified.transform;
            part.texture = std::move(modified.texture);
        }
        std::vector<BlobPart>& all = static_cast<ComponentReceiver&>(*build_.receiver).blob.components;
        make_room(all);
        all.push_back(std::move(part));
        return true;
    }

private:
    SceneBuilder& build_;
    BlobPart::Kind kind_ = BlobPart::Kind::Sphere;
    std::uint32_t value_ = 0, strength_ = 0;
    std::vector<ModifierRecipe> modifiers_;
};

/// A triangle of a mesh, without a texture of its own.
class ReadyFace final : public ReadyStatement {
public:
    explicit ReadyFace(SceneBuilder& build) : build_(build) {}

    bool read(RecipeReader& reader)
    {
        StatementReader& tokens = reader.tokens();
        smooth_ = tokens.kind() == Kind::SmoothTriangle;
        if (!smooth_ && tokens.kind() != Kind::Triangle) return false;
        const std::string_view form = solid_form(tokens.take().kind)->values;
        if (!tokens.accept(Kind::LeftBrace)) return false;
        if (tokens.kind() == Kind::Numbers) {
            const auto first = tokens.numbers(3 * form.size());
            if (!first) return false;
            value_ = *first;
        } else {
            tokens.accept(Kind::Comma);
            if (!reader.values(form, value_)) return false;
        }
        if (tokens.accept(Kind::UvVectors)) {
            has_uvs_ = true;
            tokens.accept(Kind::Comma);
            if (!reader.values("ppp", uvs_)) return false;
        }
        return tokens.accept(Kind::RightBrace);
    }

    bool run(const double* values, const Symbols&) override
    {
        if (!build_.receiver || build_.receiver->form() != Receiver::Form::Face) return false;
        scene::MeshData& data = static_cast<FaceReceiver&>(*build_.receiver).data;
        constexpr std::uint32_t kNone = scene::MeshData::kNone;
        constexpr std::array<std::uint32_t, 3> kNothing{kNone, kNone, kNone};
        scene::MeshData::Face face{kNothing, kNothing, kNothing, kNothing};
        const auto size = [](const auto& all) { return static_cast<std::uint32_t>(all.size()); };
        const double *v = values + value_, *uv = values + uvs_;
        for (std::size_t i = 0; i < 3; ++i, v += 3) {
            face.vertex[i] = size(data.vertices);
            make_room(data.vertices);
            data.vertices.emplace_back(v[0], v[1], v[2]);
            if (!smooth_) continue;
            v += 3;
            face.normal[i] = size(data.normals);
            make_room(data.normals);
            data.normals.emplace_back(v[0], v[1], v[2]);
        }
        for (std::size_t i = 0; has_uvs_ && i < 3; ++i, uv += 2) {
            face.uv[i] = size(data.uvs);
            data.uvs.emplace_back(uv[0], uv[1]);
        }
        make_room(data.faces);
        data.faces.push_back(face);
        return true;
    }

private:
    SceneBuilder& build_;
    bool smooth_ = false, has_uvs_ = false;
    std::uint32_t value_ = 0, uvs_ = 0;
};

template <class Ready>
std::unique_ptr<ReadyStatement> prepared(SceneBuilder& build, RecipeReader& reader)
{
    auto made = std::make_unique<Ready>(build);
    return made->read(reader) ? std::move(made) : nullptr;
}

}  // namespace

std::unique_ptr<ReadyStatement> SceneBuilder::prepare(StatementReader& tokens)
{
    if (!receiver) return nullptr;
    RecipeReader reader(tokens, *this);
    switch (receiver->form()) {
    case Receiver::Form::Object: return prepared<ReadyObject>(*this, reader);
    case Receiver::Form::Component: return prepared<ReadyComponent>(*this, reader);
    case Receiver::Form::Face: return prepared<ReadyFace>(*this, reader);
    }
    return nullptr;
}

}  // namespace parser
