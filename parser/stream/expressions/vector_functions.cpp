#include "numbers/functions/functions.h"
#include "parser/stream/expressions/operand.h"
#include "render/scene/last_bits.h"

#include <algorithm>
#include <numbers>

namespace parser {

glm::dvec3 rotated(glm::dvec3 v, const glm::dvec3& degrees)
{
    const glm::dvec3 angle = degrees * (std::numbers::pi / 180.0);
    const glm::dvec3 c(numbers::cos(angle.x), numbers::cos(angle.y), numbers::cos(angle.z)),
        s(numbers::sin(angle.x), numbers::sin(angle.y), numbers::sin(angle.z));
    v = {v.x, v.y * c.x - v.z * s.x, v.y * s.x + v.z * c.x};
    v = {v.x * c.y + v.z * s.y, v.y, -v.x * s.y + v.z * c.y};
    return {v.x * c.z - v.y * s.z, v.x * s.z + v.y * c.z, v.z};
}

namespace {

glm::dvec3 rotated_about(const glm::dvec3& v, const glm::dvec3& axis, double degrees)
{
    const double angle = degrees * (std::numbers::pi / 180.0);
    const glm::dvec3 k = axis * (1.0 / glm::length(axis)), s = k * numbers::sin(angle);
    const double c = numbers::cos(angle), rest = 1.0 - c;
    // The rows of a matrix, as POV-Ray has it: the same to the last digit, and 0 where it prints 0 (spec 1, 5.2).
    const glm::dvec3 x(k.x * k.x + c * (1.0 - k.x * k.x), k.x * k.y * rest + s.z, k.x * k.z * rest - s.y),
        y(k.x * k.y * rest - s.z, k.y * k.y + c * (1.0 - k.y * k.y), k.y * k.z * rest + s.x),
        z(k.x * k.z * rest + s.y, k.y * k.z * rest - s.x, k.z * k.z + c * (1.0 - k.z * k.z));
    return v.x * x + v.y * y + v.z * z;
}

glm::dvec3 read_trace(TokenStream& stream, const Token& word)
{
    const auto object = read_object_identifier(stream);
    stream.accept_comma();
    const glm::dvec3 origin = vector_expr(stream);
    stream.accept_comma();
    const glm::dvec3 direction = vector_expr(stream);
    Value* normal = nullptr;
    Cell element;
    stream.accept_comma();
    if (stream.peek().kind == Kind::Identifier) {
        const Token& name = stream.next();
        normal = stream.symbols().find(name.name);
        if (normal && is_container(*normal)) {
            element = stream.subscripted(stream.symbols().find_cell(name.name), name, false);
            normal = element.get();
        }
        const Tuple* old = normal ? normal->get_if<Tuple>() : nullptr;
        if (!old || old->count != 3)
            stream.fail(stream.place(name), "expected a declared vector that takes the normal");
    }
    const auto answer = stream.hooks().trace(object, origin, direction);
    if (!answer) stream.fail(stream.place(word), "trace() of this object is not available yet");
    if (normal) *normal = Tuple::of(answer->hit ? answer->normal : glm::dvec3(0.0));
    return answer->hit ? answer->point : glm::dvec3(0.0);
}

glm::dvec3 in_parentheses(TokenStream& stream, const Token& word)
{
    switch (word.kind) {
    case Kind::Trace: return read_trace(stream, word);
    case Kind::MinExtent:
    case Kind::MaxExtent: {
        const auto object = read_object_identifier(stream);
        const auto box = stream.hooks().extent(object);
        if (!box) stream.fail(stream.place(word), "the extent of this object is not available yet");
        constexpr double kFar = 1e10;  // what POV-Ray reports for the unbounded
        const glm::dvec3 corner = word.kind == Kind::MinExtent ? box->lower : box->upper;
        return glm::clamp(corner, glm::dvec3(-kFar), glm::dvec3(kFar));
    }
    case Kind::Vcross: {
        const glm::dvec3 a = vector_expr(stream);
        stream.accept_comma();
        return glm::cross(a, vector_expr(stream));
    }
    case Kind::Vnormalize: {
        const glm::dvec3 v = vector_expr(stream);
        if (glm::length(v) != 0.0) return scene::unit(v, stream.povray());
        if (stream.language().version >= 350) stream.warn(stream.place(word), "vnormalize of a vector of length 0");
        return glm::dvec3(0.0);
    }
    case Kind::Vrotate: {
        const glm::dvec3 v = vector_expr(stream);
        stream.accept_comma();
        return rotated(v, vector_expr(stream));
    }
    case Kind::VaxisRotate: {
        const glm::dvec3 v = vector_expr(stream);
        stream.accept_comma();
        const glm::dvec3 axis = vector_expr(stream);
        stream.accept_comma();
        return rotated_about(v, axis, float_expr(stream));
    }
    case Kind::Vturbulence: {
        const double lambda = static_cast<float>(float_expr(stream));  // single precision in POV-Ray
        stream.accept_comma();
        const double omega = static_cast<float>(float_expr(stream));
        stream.accept_comma();
        const int octaves = std::clamp(to_int32(float_expr(stream)), 1, 10);
        stream.accept_comma();
        const auto answer = stream.hooks().turbulence(vector_expr(stream), octaves, lambda, omega);
        stream.accept_comma();
        if (!answer) stream.fail(stream.place(word), "vturbulence cannot be asked here");
        return *answer;
    }
    default: stream.fail(stream.place(word), std::string(spelling(word.kind)) + " is not available yet");
    }
}

}  // namespace

glm::dvec3 read_vector_word(TokenStream& stream, const Token& word)
{
    switch (word.kind) {
    case Kind::X: return {1, 0, 0};
    case Kind::Y: return {0, 1, 0};
    case Kind::Z: return {0, 0, 1};
    default: break;
    }
    stream.expect(Kind::LeftParen, "'(' after the function's name");
    const glm::dvec3 value = in_parentheses(stream, word);
    stream.expect(Kind::RightParen, "')' after the function's arguments");
    return value;
}

}  // namespace parser
