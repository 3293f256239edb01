#pragma once

#include "parser/stream/token_stream.h"
#include "render/scene/object.h"

#include <utility>

namespace scene {
struct Blob;
}

namespace parser {

/// What is being read and takes statements that were made without reading tokens.
class Receiver {
public:
    /// How they are written there.
    enum class Form : std::uint8_t { Object, Component, Face };
    explicit Receiver(Form form) : form_(form) {}
    virtual ~Receiver() = default;
    Form form() const { return form_; }

private:
    Form form_;
};

/// Takes objects.
class ObjectReceiver : public Receiver {
public:
    ObjectReceiver() : Receiver(Form::Object) {}
    virtual scene::Object& place() = 0;  ///< a new object, to be made there
    virtual bool keep() = 0;             ///< it is made. False: something has to be said about it
    virtual void drop() = 0;             ///< it is not wanted
};

/// Takes components: a blob.
struct ComponentReceiver final : Receiver {
    explicit ComponentReceiver(scene::Blob& to) : Receiver(Form::Component), blob(to) {}
    scene::Blob& blob;
};

/// Takes faces: a mesh.
struct FaceReceiver final : Receiver {
    explicit FaceReceiver(scene::MeshData& to) : Receiver(Form::Face), data(to) {}
    scene::MeshData& data;
};

/// The next token where `receiver` takes what can do without reading.
inline const Token& peek_for(TokenStream& stream, Receiver*& current, Receiver& receiver)
{
    struct Restore {
        Receiver*& current;
        Receiver* before;
        ~Restore() { current = before; }
    } const restore{current, std::exchange(current, &receiver)};
    return stream.peek_statement();
}

}  // namespace parser
