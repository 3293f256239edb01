#include "support.h"

namespace function_test {
namespace {

/// Functions and transformations, no scene.
struct Grammar : parser::GrammarHooks {
    std::optional<parser::Value> parse_declared_value(parser::TokenStream&) override { return std::nullopt; }
    void parse_default(parser::TokenStream& stream) override { stream.expect(parser::Kind::LeftBrace, "'{'"); }
    std::optional<function::SceneReference> parse_function_thing(parser::TokenStream& stream) override
    {
        while (stream.peek().kind != parser::Kind::RightBrace) stream.next();
        stream.next();
        // translate <1, 2, 3> scale 2, the one that the table of expressions uses
        return csg::Transform::scale(glm::dvec3(2)) * csg::Transform::translate({1, 2, 3});
    }
};

}  // namespace

function::FunctionPtr compiled(const std::string& declarations, const std::string& name)
{
    Grammar grammar;
    parser::TokenStream stream({}, grammar);
    stream.open_text(declarations + "\n" + name, "test.pov");
    const parser::Token token = stream.next();
    return *stream.value_of(token)->get_if<function::FunctionPtr>();
}

}  // namespace function_test
