#include "render/picture/kernel_module.h"

#include "render/image/codecs/module_path.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <mutex>
#include <stdexcept>

namespace trace {
namespace {

Isa best()
{
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
        return Isa::V4;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2"))
        return Isa::V3;
#endif
    return Isa::V2;  // of other processors the one there is
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

std::string module_name(Isa isa) { return fmt::format("libwhittle_kernel_{}.so", name(isa)); }

Isa best_there()
{
    const std::vector<Isa> all = kernels_there();
    if (all.empty()) throw std::runtime_error(image::missing_module(module_name(best())));
    return all.back();
}

}  // namespace

std::vector<Isa> kernels_there()
{
    std::vector<Isa> all;
    for (const Isa isa : {Isa::V2, Isa::V3, Isa::V4})
        if (isa <= best() && image::find_module(module_name(isa))) all.push_back(isa);
    return all;
}

const KernelTable& load_kernel(Isa isa)
{
    // Asking the loader again would wait for whatever else it loads, so the answer is kept.
    static std::mutex guard;
    static std::map<Isa, const KernelTable*> known;
    const std::lock_guard lock(guard);
    if (const auto at = known.find(isa); at != known.end()) return *at->second;
    const Isa chosen = isa == Isa::Auto ? best_there() : isa;
    if (chosen > best())
        throw std::runtime_error(
            fmt::format("this processor cannot run the kernel '{}'; its best is '{}'", name(chosen), name(best())));
    const auto entry = reinterpret_cast<KernelEntry>(image::module_entry(module_name(chosen), kKernelSymbol));
    return *known.emplace(isa, entry()).first->second;
}

}  // namespace trace
