#include "python/binding/errors.h"

#include "csg/base/cancel.h"
#include "parser/parse.h"
#include "render/app/options/settings.h"
#include "render/app/run/memory.h"
#include "render/image/pixels/picture.h"

#include <exception>

namespace python {

namespace py = pybind11;

py::list told(const std::vector<scene::Message>& messages)
{
    py::list out;
    for (const scene::Message& m : messages)
        out.append(py::make_tuple(scene::name_of(m.severity), m.text, m.place.path, m.place.at.line, m.place.at.column,
                                  scene::message_text(m)));
    return out;
}

namespace {

void raise_scene_error(const std::vector<scene::Message>& messages)
{
    const py::object type = py::module_::import("whittle._messages").attr("SceneError");
    PyErr_SetObject(type.ptr(), type(told(messages)).ptr());
}

}  // namespace

void register_errors()
{
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const scene::Error& error) {
            raise_scene_error(error.messages());
        } catch (const app::OptionError& error) {
            PyErr_SetString(PyExc_ValueError, error.what());
        } catch (const image::FileError& error) {
            PyErr_SetString(PyExc_OSError, error.what());
        } catch (const std::bad_alloc& error) {
            PyErr_SetString(PyExc_MemoryError, app::text_of(error).c_str());
        } catch (const parser::Cancelled&) {
            PyErr_SetString(PyExc_KeyboardInterrupt, "cancelled");
        } catch (const csg::Cancelled&) {
            PyErr_SetString(PyExc_KeyboardInterrupt, "cancelled");
        }
    });
}

}  // namespace python
