#pragma once

#include "parser/base/queries.h"
#include "parser/stream/ready_statement.h"
#include "parser/stream/values/value.h"

#include <memory>
#include <optional>

namespace parser {

class TokenStream;
struct Options;

/// What the stream asks of the grammar, which knows the scene's constructs. Cold: one call per declaration.
class GrammarHooks {
public:
    virtual ~GrammarHooks() = default;

    /// The right-hand side of a declaration, a macro argument or an array element that is no expression, string, array,
    /// function or spline: `sphere { ... }`, `texture { ... } texture { ... }`, `color_map { ... }`, `transform { ...
    /// }`. stream.peek() is its first token. nullopt, with nothing consumed: no value begins here.
    virtual std::optional<Value> parse_declared_value(TokenStream& stream) = 0;

    /// The block after `#default` (or `default`), braces included.
    virtual void parse_default(TokenStream& stream) = 0;

    /// After `#version`: 3.8 begins with other defaults.
    virtual void version_changed(int /*version*/, const Options& /*options*/) {}

    /// `pigment { ... }`, `pattern { ... }` or `transform { ... }` as the body of a function; stream.peek() is the
    /// word.
    virtual std::optional<function::SceneReference> parse_function_thing(TokenStream& /*stream*/)
    {
        return std::nullopt;
    }

    /// The statement that stands where the reader does, if TokenStream::peek_statement() may find one there. Null: it
    /// is of no kind that does without its tokens.
    virtual std::unique_ptr<ReadyStatement> prepare(StatementReader& /*reader*/) { return nullptr; }

    /// Questions to a declared object; nullopt: cannot be answered (the stream makes it an error at the call).
    virtual std::optional<ObjectHit> trace(const std::shared_ptr<const scene::Object>&, const glm::dvec3& /*origin*/,
                                           const glm::dvec3& /*direction of any length*/)
    {
        return std::nullopt;
    }
    /// Whether inside() can be asked of the object.
    virtual bool solid(const std::shared_ptr<const scene::Object>&) { return true; }
    virtual std::optional<bool> inside(const std::shared_ptr<const scene::Object>&, const glm::dvec3&)
    {
        return std::nullopt;
    }
    virtual std::optional<csg::Aabb> extent(const std::shared_ptr<const scene::Object>&) { return std::nullopt; }
    virtual std::optional<glm::dvec3> turbulence(const glm::dvec3& /*point*/, int /*octaves*/, double /*lambda*/,
                                                 double /*omega*/)
    {
        return std::nullopt;
    }
    /// A function that asks for noise, patterns or pigments.
    virtual std::optional<function::Values> evaluate(const function::FunctionPtr&, const double* /*arguments*/)
    {
        return std::nullopt;
    }
};

}  // namespace parser
