#include "render/scene/textures/texture.h"

template struct scene::Sealed<scene::WarpStepKinds>;
template struct scene::Sealed<scene::PatternDataKinds>;
