#pragma once

#include "parser/grammar/core/scene_builder.h"

#include <algorithm>
#include <initializer_list>
#include <memory>

/// Textures as version 1 had them: what belongs in a pigment, normal or finish stood in the texture itself, as in
/// texture { marble turbulence 0.5 bumps 0.3 phong 1 } (spec 4, 14.1).
namespace parser {

inline bool is_one_of(Kind kind, std::initializer_list<Kind> kinds)
{
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

inline constexpr int kFirstWithoutOldTextures = 300;  ///< hundredths, as SceneBuilder::version()

/// The items of a texture that belong to its pigment, collected until an item of another kind comes.
class OldPigment {
public:
    explicit OldPigment(SceneBuilder& build) : build_(build) {}
    /// One item, if it is next. `base`: the pigment so far.
    bool read(const scene::Pigment& base);
    /// Puts what was read into `pigment`, if anything was.
    void put(scene::Pigment& pigment);

private:
    SceneBuilder& build_;
    std::shared_ptr<struct PigmentState> state_;  ///< null: nothing was read yet
    scene::SourceRef source_;
};

/// Read one item of a normal or finish that stands in the texture itself, if it is next; else false.
bool read_old_normal(SceneBuilder& build, scene::NormalPtr& normal);
bool read_old_finish(SceneBuilder& build, scene::Finish& finish);

}  // namespace parser
