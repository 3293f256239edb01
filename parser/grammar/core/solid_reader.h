#pragma once

#include "parser/grammar/core/block_reader.h"
#include "render/scene/solids.h"

/// Solids whose parameters are structs of their own (render/scene/solids.h).
namespace parser {

class SolidReader;

/// Declares, for one solid of the list, the function that its grammar file defines: from behind the brace to the first
/// modifier. It fills the parameters and reader.object().shape; false: such a one cannot be drawn yet.
/// A friend of a base class is found by its arguments wherever a SolidReader is one of them, so the list of
/// scene::AnySolid is the only one: a solid without its function does not link, and the linker names it.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wnon-template-friend"  // no template is meant
#endif
template <class Solid>
struct SolidGrammar {
    friend bool read_parameters(SolidReader& reader, Solid& solid);
};
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
template <class List>
struct SolidGrammars;
template <class... Solids>
struct SolidGrammars<std::variant<Solids...>> : SolidGrammar<Solids>... {};

class SolidReader : public BlockReader, SolidGrammars<scene::AnySolid> {
public:
    SolidReader(SceneBuilder& build, scene::Object& object) : BlockReader(build), object_(object) {}
    scene::Object& object() { return object_; }
    /// What is being read: for what is made of it later.
    std::shared_ptr<const scene::WrittenSolid> written;

private:
    scene::Object& object_;
};

/// Reads the parameters of the solid that the keyword names, if it is one, into object.written.
using SolidHead = bool (*)(SolidReader&);
/// Null: the keyword names none of them.
SolidHead solid_head(Kind keyword);

// What the object's solid says of itself.
bool takes_sturm(const scene::Object& object);
bool takes_hierarchy(const scene::Object& object);
bool forgets_inverse(const scene::Object& object);

/// Points of an outline nearer than this are the same, as where it closes.
inline constexpr double kSamePoint = 1e-10;
/// How many points or spheres follow.
int read_count(SolidReader& s);
/// `open` if `to` is not null, and `sturm` with its flag, which our solvers have no use for.
void read_open_and_sturm(SolidReader& s, bool* open);
/// A list of `count` points, by what reads one.
template <class Point>
std::vector<Point> read_points(SolidReader& s, int count)
{
    std::vector<Point> points;
    for (int i = 0; i < count; ++i) {
        s.in().accept_comma();
        read_value(s.in(), points.emplace_back());
    }
    return points;
}

}  // namespace parser
