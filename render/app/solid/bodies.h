#pragma once

#include "parser/parse.h"
#include "render/app/options/settings.h"
#include "render/app/run/cancellation.h"

#include <string>
#include <vector>

/// What `whittle info` and `whittle mesh` have in common: which objects of which scene.
namespace app {

struct BodyRequest {
    Settings settings;
    std::string object;  ///< a declared name; empty: all top-level objects
};

/// An object that stands in the scene, or that was asked for by name.
struct NamedObject {
    std::string name;  ///< the declared name, or as layers::object_names() has it
    const scene::Object* object = nullptr;
};

struct BodyScene {
    scene::Description description;
    std::vector<NamedObject> objects;  ///< lights left out
};

/// Takes `--object NAME`, `--object=NAME` at arguments[i], or whatever one of `names` stands there; the value in
/// `value`, i at its last word. False: something else stands there. Throws OptionError where the value lacks.
bool take_value(const std::vector<std::string>& arguments, std::size_t& i, const std::vector<std::string>& names,
                std::string& value);

/// Reads the scene of the request. Messages go to standard error; mistakes are thrown.
BodyScene read_bodies(const BodyRequest& request, Cancellation& cancel);


/// The status of what was thrown, told on standard error; for a catch (...) block.
int tell_thrown();

}  // namespace app
