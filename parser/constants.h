#pragma once

#include <optional>
#include <string>
#include <vector>

namespace parser {

/// A constant that a command line may declare.
struct SceneConstant {
    std::string name;
    std::optional<double> value;  ///< that the scene gives it otherwise, where it writes a number
};

/// Names that a scene asks for with #ifdef or #ifndef in its own text, in order; `#ifndef (N) #declare N = 5; #end`
/// tells what each is otherwise. None for a text that cannot be read or is longer than people write.
std::vector<SceneConstant> constants_of(const std::string& path);

}  // namespace parser
