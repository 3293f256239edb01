#include "function/build/link.h"

#include <unordered_map>

namespace function {
namespace {

struct Linker {
    const std::function<std::uint32_t(const SceneUse&)>& slot_of;
    std::unordered_map<const Function*, FunctionPtr> done;

    FunctionPtr operator()(const FunctionPtr& function)
    {
        if (!function->asks_scene) return function;
        if (const auto known = done.find(function.get()); known != done.end()) return known->second;
        auto copy = std::make_shared<Function>(*function);
        for (SceneReference& what : copy->outer) {
            if (auto* use = std::get_if<SceneUse>(&what)) use->slot = slot_of(*use);
            else if (auto* callee = std::get_if<FunctionPtr>(&what)) *callee = (*this)(*callee);
        }
        return done.emplace(function.get(), std::move(copy)).first->second;
    }
};

}  // namespace

FunctionPtr link(const FunctionPtr& function, const std::function<std::uint32_t(const SceneUse&)>& slot_of)
{
    return Linker{slot_of, {}}(function);
}

}  // namespace function
