#pragma once

#include "render/scene/object_list.h"

namespace study {

/// Whether some isosurface, parametric surface or julia set stands among the objects, however deep.
bool has_solvers(const scene::ObjectList& objects);

/// Their accuracy, of julia sets the length of steps, times `share`. What copies share they share afterwards.
void scale_accuracy(scene::ObjectList& objects, double share);

}  // namespace study
