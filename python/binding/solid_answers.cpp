#include "python/binding/solid_answers.h"

#include "python/binding/arrays.h"
#include "python/binding/bodies.h"

#include <pybind11/stl.h>

namespace python {

namespace py = pybind11;

namespace {

using Strings = std::vector<std::string>;
using SharedSource = std::shared_ptr<Source>;
using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;

py::tuple vector(const glm::dvec3& v) { return py::make_tuple(v.x, v.y, v.z); }

py::list measured(const SharedSource& source, const Strings& options, const Strings& exact, const std::string& object,
                  double precision)
{
    py::list out;
    for (const ToldMeasures& told : measure(source, {{options, exact}, object}, precision)) {
        const solid::Measures& m = told.measures;
        py::dict one;
        one["name"] = told.name;
        one["problem"] = told.problem;
        one["lower"] = vector(m.extent.lower);
        one["upper"] = vector(m.extent.upper);
        one["extent_error"] = m.extent_error;
        one["volume"] = m.volume.value;
        one["volume_error"] = m.volume.error;
        one["surface"] = m.surface.value;
        one["surface_error"] = m.surface.error;
        one["centre"] = vector(m.centre);
        one["centre_error"] = vector(m.centre_error);
        one["inertia"] = py::make_tuple(vector(m.inertia[0]), vector(m.inertia[1]), vector(m.inertia[2]));
        one["inertia_error"] = m.inertia_error;
        out.append(one);
    }
    return out;
}

py::list meshes(const SharedSource& source, const Strings& options, const Strings& exact, const std::string& object,
                double tolerance, int cells, double seconds)
{
    py::list out;
    for (ToldMesh& told : mesh(source, {{options, exact}, object}, {tolerance, cells, seconds})) {
        py::dict one;
        one["name"] = told.name;
        one["problem"] = told.problem;
        one["vertices"] = taken<float>(std::move(told.mesh.vertices), 3);
        one["faces"] = taken<std::uint32_t>(std::move(told.mesh.triangles), 3);
        one["normals"] = taken<float>(std::move(told.normals), 3);
        one["color"] = told.color;
        one["deviation"] = told.deviation;
        out.append(one);
    }
    return out;
}

py::list sections(const SharedSource& source, const Strings& options, const Strings& exact, const std::string& object,
                  int axis, double value, double tolerance, double seconds)
{
    py::list out;
    for (ToldSection& told : section(source, {{options, exact}, object}, {axis, value}, {tolerance, 0, seconds})) {
        py::list loops;
        for (solid::Loop& loop : told.loops) loops.append(taken<double>(std::move(loop), 2));
        py::dict one;
        one["name"] = told.name;
        one["problem"] = told.problem;
        one["loops"] = loops;
        one["area"] = told.area;
        one["area_error"] = told.area_error;
        one["deviation"] = told.deviation;
        out.append(one);
    }
    return out;
}

Rays rays_of(const Rows& origins, const Rows& directions)
{
    const auto rows = [](const Rows& of) { return of.ndim() == 2 && of.shape(1) == 3 ? of.shape(0) : -1; };
    if (rows(origins) < 0 || rows(directions) != rows(origins))
        throw py::value_error("origins and directions are arrays of one shape, (n, 3)");
    return {{origins.data(), origins.data() + origins.size()},
            {directions.data(), directions.data() + directions.size()}};
}

py::tuple ray_spans(const SharedSource& source, const Strings& options, const Strings& exact, const std::string& object,
                    const Rows& origins, const Rows& directions)
{
    const std::shared_ptr<Spans> found = spans(source, {{options, exact}, object}, rays_of(origins, directions));
    return py::make_tuple(taken<std::int64_t>(std::move(found->first)), taken<double>(std::move(found->ends), 2),
                          taken<std::int32_t>(std::move(found->object)), found->names);
}

}  // namespace

void add_solid_answers(py::module_& m)
{
    m.def("measure", &measured);
    m.def("mesh", &meshes);
    m.def("section", &sections);
    m.def("spans", &ray_spans);
}

}  // namespace python
