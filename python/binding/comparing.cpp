#include "python/binding/comparing.h"

#include "render/image/compare/compare.h"

#include <pybind11/numpy.h>

#include <numeric>

namespace python {

namespace py = pybind11;

namespace {

using Bytes = py::array_t<std::uint8_t, py::array::c_style>;
using Shorts = py::array_t<std::uint16_t, py::array::c_style>;
using Floats = py::array_t<float, py::array::c_style | py::array::forcecast>;

template <class Array>
image::Picture picture_of_array(const Array& values, image::Samples samples, int bits)
{
    const bool grey = values.ndim() == 2;
    if (!grey && (values.ndim() != 3 || values.shape(2) < 1 || values.shape(2) > 4))
        throw py::value_error("a picture is an array of shape (height, width) or (height, width, 1 to 4)");
    image::Picture picture;
    picture.height = static_cast<int>(values.shape(0));
    picture.width = static_cast<int>(values.shape(1));
    picture.channels = grey ? 1 : static_cast<int>(values.shape(2));
    picture.bits = bits;
    picture.samples = std::move(samples);
    return picture;
}

template <class Array>
auto copied(const Array& values)
{
    return std::vector<typename Array::value_type>(values.data(), values.data() + values.size());
}

/// A file by its path, or an array: levels of 8 or 16 bits, or numbers from 0 to 1 as a file would store them.
image::Picture picture_of(const py::object& given)
{
    if (py::isinstance<py::str>(given)) return image::Files().read(given.cast<std::string>());
    constexpr std::uint32_t kByte = 255, kShort = 65535;
    if (py::isinstance<py::array_t<std::uint8_t>>(given)) {
        const auto values = Bytes::ensure(given);
        return picture_of_array(values, {copied(values), kByte}, 8);
    }
    if (py::isinstance<py::array_t<std::uint16_t>>(given)) {
        const auto values = Shorts::ensure(given);
        return picture_of_array(values, {copied(values), kShort}, 16);
    }
    const auto values = Floats::ensure(given);
    if (!values) throw py::error_already_set();
    return picture_of_array(values, {copied(values)}, 32);
}

py::dict compared(const py::object& first, const py::object& second, double tolerance, bool with_flip)
{
    const image::Picture a = picture_of(first), b = picture_of(second);
    image::Comparison found;
    std::vector<float> flip;
    {
        const py::gil_scoped_release free;
        found = image::compare(a, b, tolerance);
        if (with_flip) flip = image::flip_map(a, b);
    }
    py::dict out;
    out["agreeing"] = found.agreeing;
    out["rmse"] = found.rmse;
    out["psnr"] = found.psnr;
    out["ssim"] = found.ssim;
    out["largest"] = found.largest;
    out["worst"] = py::make_tuple(found.worst_x, found.worst_y);
    out["flip"] = py::none();
    if (with_flip) out["flip"] = std::accumulate(flip.begin(), flip.end(), 0.0) / static_cast<double>(flip.size());
    return out;
}

}  // namespace

void add_comparison(py::module_& m) { m.def("compare", &compared); }

}  // namespace python
