#include "render/scene/base/dump_writer.h"
#include "render/scene/solids.h"

/// Lines of parameters that need more than one each.
namespace scene {

void Blob::dump(DumpWriter& out) const
{
    out.changed("threshold", threshold, Blob().threshold);
    for (const Component& c : components) {
        if (c.kind == Component::Kind::Plain) out.words("component", c.strength, c.radius, c.center);
        else if (c.kind == Component::Kind::Sphere) out.words("sphere", c.center, c.radius, c.strength);
        else out.words("cylinder", c.center, c.end, c.radius, c.strength);
        if (!c.transform->identity()) out.value("transform", *c.transform);
        if (c.texture) scene::dump(out, *c.texture);
    }
}

}  // namespace scene
