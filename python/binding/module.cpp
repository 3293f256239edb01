#include "python/binding/arrays.h"
#include "python/binding/comparing.h"
#include "python/binding/errors.h"
#include "python/binding/scene.h"
#include "python/binding/solid_answers.h"
#include "render/image/codecs/module_path.h"

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <dlfcn.h>

#include <filesystem>

namespace py = pybind11;

namespace python {
namespace {

using Strings = std::vector<std::string>;
using SharedPicture = std::shared_ptr<Picture>;

/// Kernels take the C++ runtime from the program that opens them (cmake/start). Python shows what this module was
/// linked with to nobody else, so it is opened once more, for all.
void share_runtime()
{
    for (const char* const library : {"libstdc++.so.6", "libgcc_s.so.1"})
        dlopen(library, RTLD_LAZY | RTLD_GLOBAL | RTLD_NOLOAD);
}

/// Kernels and readers of files stand beside this module in a wheel, where `cmake --install` puts them in a system, and
/// two folders up in a build.
void find_modules()
{
    static const char here = 0;
    Dl_info info{};
    if (dladdr(&here, &info) == 0) return;
    std::error_code failed;
    const std::filesystem::path file = std::filesystem::canonical(info.dli_fname, failed);
    if (failed) return;
    const std::filesystem::path folder = file.parent_path();
    image::look_for_modules_in(
        {folder, (folder / WHITTLE_MODULES_FROM_PACKAGE).lexically_normal(), folder.parent_path().parent_path()});
}

py::array light(const SharedPicture& p)
{
    const py::ssize_t width = p->image.width, height = p->image.height, size = sizeof(float);
    return view({height, width, 4}, {4 * width * size, 4 * size, size}, p->light(), py::cast(p));
}

py::array levels(const SharedPicture& p)
{
    const py::ssize_t width = p->image.width, height = p->image.height, channels = p->channels();
    if (!p->deep()) return view({height, width, channels}, {width * channels, channels, 1}, p->bytes(), py::cast(p));
    return view({height, width, channels}, {2 * width * channels, 2 * channels, 2}, p->levels(), py::cast(p));
}

/// Channels by name, each an array over the memory of all of them.
py::dict layers(const SharedPicture& p)
{
    py::dict out;
    if (!p->layers) return out;
    const image::Channels& all = *p->layers;
    const py::ssize_t width = all.width, height = p->image.height, size = sizeof(float),
                      count = static_cast<py::ssize_t>(all.names.size());
    for (py::ssize_t i = 0; i < count; ++i)
        out[py::str(all.names[static_cast<std::size_t>(i)])] =
            view({height, width}, {width * count * size, count * size}, all.values.data() + i, py::cast(p));
    return out;
}

SharedPicture render_words(const std::shared_ptr<Source>& source, Strings options, Strings exact,
                           std::optional<std::string> camera, std::string layer_names, const py::object& preview)
{
    Request request{{std::move(options), std::move(exact)}, std::move(camera), std::move(layer_names), {}};
    // The caller holds what is called, and it is called from this call alone.
    if (!preview.is_none()) request.preview = [look = py::handle(preview)](SharedPicture shown) { look(shown); };
    return render(source, std::move(request));
}

py::list read_words(const std::shared_ptr<Source>& source, const Strings& options, const Strings& exact)
{
    const auto read = result_of<Source::Read>(
        [source, words = Words{options, exact}](Job& job) { return source->read(settings_of(words), job.cancel); });
    return told(read->messages);
}

}  // namespace

PYBIND11_MODULE(_whittle, m)
{
    share_runtime();
    find_modules();
    register_errors();
    py::class_<Picture, SharedPicture>(m, "Picture")
        .def_property_readonly("light", &light)
        .def_property_readonly("levels", &levels)
        .def_property_readonly("layers", &layers)
        .def_property_readonly("messages", [](const Picture& p) { return told(p.messages); })
        .def_readonly("seconds", &Picture::seconds)
        .def_readonly("isa", &Picture::isa)
        .def("save", &Picture::save, py::call_guard<py::gil_scoped_release>());
    py::class_<Source, std::shared_ptr<Source>>(m, "Source")
        .def(py::init<std::optional<std::string>>())
        .def("read", &read_words)
        .def("render", &render_words);
    add_solid_answers(m);
    add_comparison(m);
}

}  // namespace python
