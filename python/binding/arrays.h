#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <utility>
#include <vector>

namespace python {

/// An array over memory that `owner` keeps, read-only; it lives as long as the array does.
/// \param shape, strides  numbers of elements and of bytes
template <class T>
pybind11::array view(std::vector<pybind11::ssize_t> shape, std::vector<pybind11::ssize_t> strides, const T* first,
                     const pybind11::object& owner)
{
    pybind11::array out(pybind11::dtype::of<T>(), std::move(shape), std::move(strides), first, owner);
    out.attr("setflags")(pybind11::arg("write") = false);
    return out;
}

/// An array that takes a list of numbers, or of rows of so many, as it stands in memory.
/// \tparam T  of a number
template <class T, class Row>
pybind11::array taken(std::vector<Row> rows, pybind11::ssize_t columns = 0)
{
    auto kept = std::make_unique<std::vector<Row>>(std::move(rows));
    const auto count = static_cast<pybind11::ssize_t>(kept->size());
    const auto* first = reinterpret_cast<const T*>(kept->data());
    const pybind11::capsule owner(kept.get(), [](void* gone) { delete static_cast<std::vector<Row>*>(gone); });
    static_cast<void>(kept.release());
    constexpr pybind11::ssize_t kSize = sizeof(T);
    if (columns == 0) return pybind11::array(pybind11::dtype::of<T>(), {count}, {kSize}, first, owner);
    return pybind11::array(pybind11::dtype::of<T>(), {count, columns}, {columns * kSize, kSize}, first, owner);
}

}  // namespace python
