#include "render/trace/kernel_module.h"

#include <fmt/format.h>

#include <dlfcn.h>

#include <filesystem>
#include <map>
#include <mutex>
#include <stdexcept>

namespace trace {
namespace {

Isa best()
{
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
        return Isa::V4;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2")) return Isa::V3;
    return Isa::V2;
}

std::string name(Isa isa)
{
    switch (isa) {
    case Isa::V2: return "v2";
    case Isa::V3: return "v3";
    case Isa::V4: return "v4";
    case Isa::Auto: break;
    }
    return name(best());
}

/// The folder of the running program: modules stand beside it.
std::filesystem::path program_folder() { return std::filesystem::read_symlink("/proc/self/exe").parent_path(); }

}  // namespace

std::string best_isa() { return name(best()); }

const KernelTable& load_kernel(Isa isa)
{
    const Isa chosen = isa == Isa::Auto ? best() : isa;
    // Asking the loader again would wait for whatever else it loads, so the answer is kept.
    static std::mutex guard;
    static std::map<Isa, const KernelTable*> known;
    const std::lock_guard lock(guard);
    if (const auto at = known.find(chosen); at != known.end()) return *at->second;
    if (chosen > best())
        throw std::runtime_error(fmt::format("this processor cannot run the kernel '{}'; its best is '{}'", name(chosen), best_isa()));
    const auto path = program_folder() / fmt::format("libwhittle_kernel_{}.so", name(chosen));
    void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (module == nullptr) throw std::runtime_error(fmt::format("cannot load the kernel: {}", dlerror()));
    const auto entry = reinterpret_cast<KernelEntry>(dlsym(module, kKernelSymbol));
    if (entry == nullptr) throw std::runtime_error(fmt::format("'{}' is no kernel module", path.string()));
    return *known.emplace(chosen, entry()).first->second;
}

}  // namespace trace
