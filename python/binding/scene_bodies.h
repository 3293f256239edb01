#pragma once

#include "python/binding/bodies.h"
#include "render/kernel/kernel.h"
#include "render/scene/object.h"

namespace python {

/// The objects of a scene that are asked for, each made a body when its turn comes.
class SceneBodies {
public:
    /// Throws app::OptionError where the scene has none of that name.
    SceneBodies(Source& source, const Asked& asked, const std::atomic<bool>& cancel);

    struct Named {
        std::string name;
        const scene::Object* object;
    };
    const std::vector<Named>& objects() const { return objects_; }
    const app::Settings& settings() const { return settings_; }
    const trace::KernelTable& kernel() const { return kernel_; }
    solid::Body body(const Named& of) const { return {*of.object, read_->scene.global}; }
    std::unique_ptr<solid::Body> kept_body(const Named& of) const
    {
        return std::make_unique<solid::Body>(*of.object, read_->scene.global);
    }

private:
    const app::Settings settings_;
    const trace::KernelTable& kernel_;
    const Source::Read read_;
    std::vector<Named> objects_;
};

}  // namespace python
