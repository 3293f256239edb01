#include "render/scene/unsupported_features.h"

#include <set>

namespace scene {

std::vector<Unsupported> unsupported_features(const Description& description)
{
    std::vector<Unsupported> found;
    std::set<std::string> told;
    for (const Object& object : description.unsupported_objects)
        if (told.insert(object.details->unsupported).second)
            found.push_back({object.details->unsupported, object.source});
    return found;
}

}  // namespace scene
