#pragma once

#include "parser/grammar/scene_builder.h"
#include "parser/stream/expression.h"
#include "render/scene/statement.h"

#include <limits>
#include <string_view>

/// Constructs that are kept as written (render/scene/statement.h): forms of items, and a reader that fills a Statement.
namespace parser {

/// One item: its keyword and the letters of its operands. f number, v vector, p pair, q four numbers, c colour without
/// filter, C colour, s text, t path; `,` what follows is there only after a comma or where an operand can begin, `o`
/// stands alone for a flag with an optional number. The first number must lie within low..high (`above`: low excluded).
struct Form {
    Kind keyword;
    const char* operands;
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
    bool above = false;
};

class StatementReader {
public:
    using Operand = scene::StatementItem::Operand;

    /// The keyword has been taken: it names the statement.
    explicit StatementReader(SceneBuilder& build);

    TokenStream& in() { return build_.stream(); }
    SceneBuilder& build() { return build_; }
    scene::Statement& statement() { return statement_; }
    void add(std::string_view name, std::vector<Operand> operands = {});

    /// Operands by letters, from where the text stands; a comma before each but the first is optional.
    std::vector<Operand> operands(const char* letters);
    /// The same, appended as an item.
    void read(std::string_view name, const char* letters) { add(name, operands(letters)); }
    /// An item of the list if its keyword is next.
    template <std::size_t count> bool read_one(const Form (&forms)[count])
    {
        for (const Form& form : forms)
            if (read_form(form)) return true;
        return false;
    }
    template <std::size_t count> void read_all(const Form (&forms)[count])
    {
        while (read_one(forms)) {}
    }
    /// A transformation if one is next, kept as an item.
    bool read_transform();
    /// `{`; close() at `}`.
    void open();
    void close();
    bool accept(Kind kind) { return in().accept(kind); }
    [[noreturn]] void fail(std::string_view text) { in().fail(in().last(), text); }
    scene::StatementPtr take() { return std::make_shared<const scene::Statement>(std::move(statement_)); }

private:
    bool read_form(const Form& form);
    SceneBuilder& build_;
    scene::Statement statement_;
    scene::SourceRef opened_;
};

using scene::item_of;
using scene::number_of;
/// `{ forms }` after a keyword that has been taken, kept.
template <std::size_t count> scene::StatementPtr read_forms(SceneBuilder& build, const Form (&forms)[count])
{
    StatementReader s(build);
    s.open();
    s.read_all(forms);
    s.close();
    return s.take();
}
/// A declared thing of that keyword (media, density, rainbow) if its name is next.
scene::StatementPtr accept_declared(SceneBuilder& build, std::string_view keyword);

// Blocks that are kept whole; the keyword has been taken.
scene::StatementPtr read_media(SceneBuilder& build);
scene::StatementPtr read_density(SceneBuilder& build);
scene::StatementPtr read_rainbow(SceneBuilder& build);
scene::StatementPtr read_global_radiosity(SceneBuilder& build);
scene::StatementPtr read_global_photons(SceneBuilder& build);
scene::StatementPtr read_global_subsurface(SceneBuilder& build);
scene::StatementPtr read_object_photons(SceneBuilder& build);
scene::StatementPtr read_light_photons(SceneBuilder& build);
scene::StatementPtr read_object_radiosity(SceneBuilder& build);
scene::StatementPtr read_finish_subsurface(SceneBuilder& build);
scene::StatementPtr read_mesh_camera(SceneBuilder& build);
scene::StatementPtr read_bokeh(SceneBuilder& build);

/// Points of an outline nearer than this are the same, as where it closes.
inline constexpr double kSamePoint = 1e-10;

/// What stands first in an image's block: a kind and a file that must exist, or `function w, h { }`. `what` for messages.
void read_image_source(StatementReader& s, bool bare_name_allowed);
/// image_map, bump_map, image_pattern: the whole block. `colors`: filter and transmit may stand in it.
scene::StatementPtr read_image_block(SceneBuilder& build, bool colors);
scene::StatementPtr read_material_map(SceneBuilder& build);
scene::StatementPtr read_density_file(SceneBuilder& build);
/// Stops before what the object's outside and inside have; close_list() takes the brace behind that.
scene::StatementPtr read_object_pattern(SceneBuilder& build);

/// Heads of the solids that are kept as written: from behind the brace to the first modifier.
using HeadReader = void (*)(StatementReader&);
/// Null: this keyword is read otherwise or no solid.
HeadReader written_head(Kind keyword);
HeadReader curve_head(Kind keyword);      ///< made of points along a curve
HeadReader polynomial_head(Kind keyword);
HeadReader field_head(Kind keyword);      ///< made of functions, components, files

/// texture, pigment, normal, finish and transformations of a blob's component.
void read_component_modifiers(SceneBuilder& build, scene::Object& object);

}  // namespace parser
