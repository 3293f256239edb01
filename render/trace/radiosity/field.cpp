#include "render/trace/radiosity/field.h"

#include "render/trace/radiosity/directions.h"

namespace trace::radiosity {

Field::Field(const plan::CompiledScene& scene) : plan(scene.radiosity), eye(scene.camera.location)
{
    for (int bounce = 0; bounce < settings().recursion_limit; ++bounce)
        rules.push_back(BounceRules::of(settings(), bounce));
    samples.resize(rules.size());
    directions = radiosity::directions(settings().pool_size());
}

}  // namespace trace::radiosity
