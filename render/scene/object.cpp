#include "render/scene/object.h"

template struct scene::Sealed<scene::ShapeKinds>;
