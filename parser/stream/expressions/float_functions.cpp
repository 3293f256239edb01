#include "numbers/functions/functions.h"
#include "parser/stream/expressions/operand.h"
#include "parser/stream/expressions/text_functions.h"
#include "parser/stream/values/elements.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <numbers>

namespace parser {
namespace {

constexpr double kDegree = 0.01745329251994329576;

double one_argument(TokenStream& stream, const Token& word, double a)
{
    const auto refuse = [&](const char* why) {
        stream.fail(stream.place(word), std::string(spelling(word.kind)) + why);
    };
    switch (word.kind) {
    case Kind::Abs: return std::abs(a);
    case Kind::Acos:
    case Kind::Asin:
        if (a < -1.0 || a > 1.0) {
            stream.warn(stream.place(word), std::string(spelling(word.kind)) + " of a number outside -1 to 1");
            a = a < 0 ? -1.0 : 1.0;
        }
        return word.kind == Kind::Acos ? numbers::acos(a) : numbers::asin(a);
    case Kind::Atan: return numbers::atan(a);
    case Kind::Cosh: return numbers::cosh(a);
    case Kind::Sinh: return numbers::sinh(a);
    case Kind::Tanh: return numbers::tanh(a);
    case Kind::Acosh: return numbers::acosh(a);
    case Kind::Asinh: return numbers::asinh(a);
    case Kind::Atanh: return numbers::atanh(a);
    case Kind::Ceil: return std::ceil(a);
    case Kind::Cos: return numbers::cos(a);
    case Kind::Degrees: return a / kDegree;
    case Kind::Exp: return numbers::exp(a);
    case Kind::Floor: return std::floor(a);
    case Kind::Int: return to_int32(a);
    case Kind::Ln:
        if (a <= 0.0) refuse(" of a number that is not above 0");
        return numbers::log(a);
    case Kind::Log:
        if (a <= 0.0) refuse(" of a number that is not above 0");
        return numbers::log10(a);
    case Kind::Radians: return a * kDegree;
    case Kind::Sin: return numbers::sin(a);
    case Kind::Sqrt:
        if (a < 0.0) refuse(" of a number below 0");
        return std::sqrt(a);
    case Kind::Tan: return numbers::tan(a);
    case Kind::Seed:
        stream.random_streams().push_back(static_cast<std::uint32_t>(to_int32(a)));
        return static_cast<double>(stream.random_streams().size() - 1);
    case Kind::Rand: {
        auto& streams = stream.random_streams();
        const std::int32_t index = to_int32(a);
        if (index < 0 || static_cast<std::size_t>(index) >= streams.size()) refuse(" needs a stream made by seed()");
        std::uint32_t& s = streams[static_cast<std::size_t>(index)];
        s = 1812433253u * s + 12345u;  // POV-Ray's generator (spec 1, 5.4)
        return s / 4294967295.0;
    }
    default: stream.fail(stream.place(word), "this function cannot stand here");
    }
}

double two_arguments(TokenStream& stream, const Token& word)
{
    const double a = float_expr(stream);
    stream.accept_comma();
    const double b = float_expr(stream);
    switch (word.kind) {
    case Kind::Atan2:
        if (std::abs(a) <= kSame && std::abs(b) <= kSame) stream.fail(stream.place(word), "atan2 of two zeros");
        return numbers::atan2(a, b);
    case Kind::Div: return to_int32(a / b);
    case Kind::Mod: return std::fmod(a, b);
    default:
        if (a == 0.0 && b == 0.0) stream.fail(stream.place(word), "pow of two zeros");
        return numbers::pow(a, b);
    }
}

double any_number_of_arguments(TokenStream& stream, Kind kind)
{
    double value = float_expr(stream);
    const bool bits = kind != Kind::Min && kind != Kind::Max;
    if (bits) value = to_int32(value);
    while (stream.accept_comma()) {
        const double b = float_expr(stream);
        const std::int32_t i = bits ? to_int32(value) : 0, j = bits ? to_int32(b) : 0;
        switch (kind) {
        case Kind::Min: value = b < value ? b : value; break;
        case Kind::Max: value = value < b ? b : value; break;
        case Kind::BitwiseAnd: value = i & j; break;
        case Kind::BitwiseOr: value = i | j; break;
        default: value = i ^ j; break;
        }
    }
    return value;
}

double read_select(TokenStream& stream)
{
    const double a = float_expr(stream);
    stream.accept_comma();
    const double b = float_expr(stream);
    stream.accept_comma();
    const double c = float_expr(stream);
    if (!stream.accept_comma()) return a < 0.0 ? b : c;
    const double d = float_expr(stream);
    return a < 0.0 ? b : a == 0.0 ? c : d;
}

double string_function(TokenStream& stream, Kind kind)
{
    const std::string a = string_expr(stream);
    switch (kind) {
    case Kind::Asc: return first_of(a);
    case Kind::Strlen: return static_cast<double>(length_of(a));
    case Kind::Val: return std::strtod(a.c_str(), nullptr);
    case Kind::FileExists: return stream.find_file(a, {}).empty() ? 0.0 : 1.0;
    default: stream.accept_comma(); return order_of(a, string_expr(stream));
    }
}

double array_function(TokenStream& stream, Kind kind)
{
    Token name;
    Cell cell = stream.take_name(name);
    if (cell && cell->get_if<std::shared_ptr<Dictionary>>()) cell = stream.subscripted(cell, name, false);
    const auto* array = cell ? cell->get_if<std::shared_ptr<Array>>() : nullptr;
    if (!array) stream.fail(stream.place(name), "expected the name of an array");
    const auto kept = *array;
    if (kind == Kind::Dimensions) return static_cast<double>(kept->sizes.size());
    stream.accept_comma();
    return size_of_dimension(*kept, float_expr(stream));
}

double days_since_2000()
{
    using namespace std::chrono;
    const auto epoch = sys_days{year{2000} / January / 1};
    return duration<double, std::ratio<86400>>(system_clock::now() - epoch).count();
}

double in_parentheses(TokenStream& stream, const Token& word)
{
    switch (word.kind) {
    case Kind::Atan2:
    case Kind::Div:
    case Kind::Mod:
    case Kind::Pow: return two_arguments(stream, word);
    case Kind::Min:
    case Kind::Max:
    case Kind::BitwiseAnd:
    case Kind::BitwiseOr:
    case Kind::BitwiseXor: return any_number_of_arguments(stream, word.kind);
    case Kind::Select: return read_select(stream);
    case Kind::Vlength: return glm::length(vector_expr(stream));
    case Kind::Vdot: {
        const glm::dvec3 a = vector_expr(stream);
        stream.accept_comma();
        return glm::dot(a, vector_expr(stream));
    }
    case Kind::Asc:
    case Kind::Strlen:
    case Kind::Strcmp:
    case Kind::Val:
    case Kind::FileExists: return string_function(stream, word.kind);
    case Kind::Dimensions:
    case Kind::DimensionSize: return array_function(stream, word.kind);
    case Kind::Inside: {
        const auto object = read_object_identifier(stream);
        if (!stream.hooks().solid(object))
            stream.fail(stream.last(), "inside() wants a solid, and this object, or a part of it, has no inside");
        stream.accept_comma();
        const auto answer = stream.hooks().inside(object, vector_expr(stream));
        if (!answer) stream.fail(stream.place(word), "inside() of this object is not available yet");
        return *answer ? 1.0 : 0.0;
    }
    default: return one_argument(stream, word, float_expr(stream, Level::Full));
    }
}

}  // namespace

std::shared_ptr<const scene::Object> read_object_identifier(TokenStream& stream)
{
    auto object = stream.accept_identifier<std::shared_ptr<const scene::Object>>();
    if (!object) stream.fail_expected("the name of a declared object");
    return *object;
}

double read_float_word(TokenStream& stream, const Token& word)
{
    switch (word.kind) {
    case Kind::Pi: return std::numbers::pi;
    case Kind::Tau: return 2.0 * std::numbers::pi;
    case Kind::True:
    case Kind::Yes:
    case Kind::On: return 1.0;
    case Kind::False:
    case Kind::No:
    case Kind::Off: return 0.0;
    case Kind::Clock: return static_cast<double>(static_cast<float>(stream.options().clock));
    case Kind::ClockOn: return stream.options().clock_on ? 1.0 : 0.0;
    case Kind::Now: return days_since_2000();
    case Kind::Version: return stream.language().version / 100.0;
    case Kind::Defined: return stream.read_defined() ? 1.0 : 0.0;
    default: break;
    }
    stream.expect(Kind::LeftParen, "'(' after the function's name");
    const double value = in_parentheses(stream, word);
    stream.expect(Kind::RightParen, "')' after the function's arguments");
    return value;
}

}  // namespace parser
