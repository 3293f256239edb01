#include "render/app/watch/gallery.h"

#include "language/names/files.h"
#include "render/app/rpc/guarded_json.h"
#include "render/app/run/scene_reading.h"
#include "render/app/watch/block_event.h"
#include "render/app/run/stage_options.h"
#include "render/image/files.h"
#include "render/kernel/gather/indirect_light.h"
#include "render/picture/passes/passes.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

namespace app {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::size_t kMostScenes = 200;
constexpr int kSmallWidth = 128;
constexpr auto kGalleryPatience = std::chrono::seconds(4);

std::vector<std::string> scenes_beside(const std::string& shown)
{
    std::vector<std::string> names;
    std::error_code failed;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(fs::path(language::normal_path(shown)).parent_path(), failed)) {
        std::error_code ignored;
        if (entry.path().extension() == ".pov" && entry.is_regular_file(ignored))
            names.push_back(entry.path().filename());
    }
    std::sort(names.begin(), names.end());
    if (names.size() > kMostScenes) names.resize(kMostScenes);
    return names;
}

int height_for(const Settings& settings)
{
    return std::clamp(kSmallWidth * settings.height / settings.width, kSmallWidth / 4, kSmallWidth * 2);
}

/// The whole picture of a scene, small, as the page reads it. Throws what reading and planning throw, and
/// parser::Cancelled.
std::string small_picture(Settings settings, const std::string& path, const std::atomic<bool>& cancel)
{
    settings.input_file = path;
    settings.height = height_for(settings);
    settings.width = kSmallWidth;
    settings.antialias = false;
    const Settings whole;
    settings.start_row = whole.start_row;
    settings.start_column = whole.start_column;
    settings.end_row = whole.end_row;
    settings.end_column = whole.end_column;
    const SceneReading reading(settings, cancel);
    const parser::Result parsed = parser::parse_file(path, reading.options);
    plan::CompiledScene compiled = plan::compile(parsed.scene, plan_options(settings));
    trace::RenderOptions options;
    options.threads = threads_of(settings);
    options.isa = isa_of(settings);
    options.cancel = &cancel;
    const auto light = trace::run_passes(compiled, options);
    options.indirect = light.get();
    image::Image picture{settings.width, settings.height, {}, 0};
    picture.hold(0, settings.height);
    if (cancel || trace::render(compiled, options, picture).cancelled) throw parser::Cancelled();
    return block_event(0, 0, {0, 0, settings.width, settings.height}, picture, page_encoding(settings, parsed.scene));
}

}  // namespace

std::string Gallery::path_of(const std::string& shown, const std::string& name)
{
    const std::vector<std::string> names = scenes_beside(shown);
    if (std::find(names.begin(), names.end(), name) == names.end()) return {};
    return fs::path(shown).replace_filename(name).string();
}

web::Reply Gallery::list(const std::string& shown) const
{
    return {200, "application/json",
            rpc::text_of({{"scenes", scenes_beside(shown)},
                          {"shown", fs::path(shown).filename().string()},
                          {"width", kSmallWidth},
                          {"height", height_for(settings_)}})};
}

void Gallery::end()
{
    {
        const std::lock_guard lock(mutex_);
        ending_ = cancel_ = true;
    }
    done_.notify_all();
}

web::Reply Gallery::thumbnail(const std::string& shown, const std::string& query)
{
    constexpr std::string_view kName = "name=";
    const std::string path = query.starts_with(kName) ? path_of(shown, query.substr(kName.size())) : std::string();
    if (path.empty()) return {404, "text/plain", "no such scene\n"};
    const std::lock_guard one(one_at_a_time_);
    {
        const std::lock_guard lock(mutex_);
        if (ending_) return {503, "text/plain", ""};
        cancel_ = false;
    }
    bool done = false;
    std::thread guard([&] {
        std::unique_lock lock(mutex_);
        done_.wait_for(lock, kGalleryPatience, [&] { return done || ending_; });
        cancel_ = true;
    });
    std::string why, out;
    try {
        out = small_picture(settings_, path, cancel_);
    } catch (const parser::Cancelled&) {
        why = "takes long";
    } catch (const csg::Cancelled&) {
        why = "takes long";
    } catch (const std::exception&) {
        why = "has an error";
    }
    {
        const std::lock_guard lock(mutex_);
        done = true;
    }
    done_.notify_all();
    guard.join();
    if (!why.empty()) out = rpc::text_of({{"why", why}});
    return {200, "application/json", out};
}

}  // namespace app
