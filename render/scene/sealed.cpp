#include "render/scene/object.h"
#include "render/scene/textures/texture.h"

/// The one place where the variants of the description are copied, moved and destroyed.
template struct scene::Sealed<scene::ShapeKinds>;
template struct scene::Sealed<scene::WarpStepKinds>;
template struct scene::Sealed<scene::PatternDataKinds>;
