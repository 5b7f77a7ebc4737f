// SPDX-License-Identifier: Apache-2.0
#include "roomcast/python/arrays.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "roomcast/geometry/camera_model.h"
#include "roomcast/python/errors.h"

namespace roomcast::python {
namespace {

namespace py = pybind11;

static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float), "points are shown as rows of three");

/// Keeps `owner` alive until no array needs it.
py::capsule base_of(const Owner& owner) {
  return {new Owner(owner), [](void* kept) { delete static_cast<Owner*>(kept); }};
}

template <class Element>
py::array view(const void* data, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides,
               const Owner& owner) {
  py::array array(py::dtype::of<Element>(), std::move(shape), std::move(strides), data,
                  base_of(owner));
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

template <class Element, class Pixel>
py::array picture(ImageView<const Pixel> image, const Owner& owner) {
  constexpr py::ssize_t kChannels = sizeof(Pixel) / sizeof(Element);
  std::vector<py::ssize_t> shape = {image.height, image.width};
  std::vector<py::ssize_t> strides = {
      static_cast<py::ssize_t>(sizeof(Pixel)) * static_cast<py::ssize_t>(image.stride),
      static_cast<py::ssize_t>(sizeof(Pixel))};
  if (kChannels > 1) {
    shape.push_back(kChannels);
    strides.push_back(sizeof(Element));
  }
  return view<Element>(image.data, std::move(shape), std::move(strides), owner);
}

template <class Element, class Row>
py::array triples(const std::vector<Row>& rows, const Owner& owner) {
  static_assert(sizeof(Row) == 3 * sizeof(Element));
  return view<Element>(rows.data(), {static_cast<py::ssize_t>(rows.size()), 3},
                       {sizeof(Row), sizeof(Element)}, owner);
}

/// Nothing is converted: a picture of other numbers is a mistake of its program.
template <class Element>
py::array picture_array(const py::object& given, std::size_t dimensions, const char* what,
                        const char* wanted) {
  if (!py::isinstance<py::array_t<Element>>(given))
    throw Failure(invalid_argument(std::string(what) + " is not a NumPy array of " + wanted));
  auto array = py::array_t<Element, py::array::c_style>::ensure(given);
  if (!array) throw py::error_already_set();
  const bool fits = static_cast<std::size_t>(array.ndim()) == dimensions &&
                    (dimensions == 2 || array.shape(2) == 3) &&
                    std::max(array.shape(0), array.shape(1)) <= kMaxImageSide;
  if (!fits) throw Failure(invalid_argument(std::string(what) + " is not a picture of " + wanted));
  return array;
}

}  // namespace

py::array array_of(DepthView depth_mm, const Owner& owner) {
  return picture<std::uint16_t>(depth_mm, owner);
}

py::array array_of(ColorView color, const Owner& owner) {
  return picture<std::uint8_t>(color, owner);
}

py::array array_of(MaskView mask, const Owner& owner) {
  return picture<std::uint8_t>(mask, owner);
}

py::array array_of(const std::vector<Eigen::Vector3f>& rows, const Owner& owner) {
  return triples<float>(rows, owner);
}

py::array array_of(const std::vector<Rgb8>& rows, const Owner& owner) {
  return triples<std::uint8_t>(rows, owner);
}

py::array array_of(const RigidTransform& transform) {
  py::array_t<double> matrix({4, 4});
  std::ranges::copy(row_major_from_transform(transform), matrix.mutable_data());
  return matrix;
}

py::object array_or_none(const std::optional<RigidTransform>& transform) {
  if (!transform) return py::none();
  return array_of(*transform);
}

RigidTransform transform_of(const py::object& matrix, const char* what) {
  const auto numbers =
      py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(matrix);
  if (!numbers) PyErr_Clear();
  if (!numbers || numbers.ndim() != 2 || numbers.shape(0) != 4 || numbers.shape(1) != 4)
    throw Failure(invalid_argument(std::string(what) + " is not a matrix of 4 x 4 numbers"));
  const auto transform = transform_from_row_major(std::span(numbers.data(), 16));
  if (transform) return *transform;
  throw Failure({transform.error().code, std::string(what) + ": " + transform.error().message});
}

py::array depth_array(const py::object& given, const char* what) {
  return picture_array<std::uint16_t>(given, 2, what, "height x width uint16");
}

py::array color_array(const py::object& given, const char* what) {
  return picture_array<std::uint8_t>(given, 3, what, "height x width x 3 uint8");
}

DepthView depth_view(const py::array& depth_mm) {
  const int height = static_cast<int>(depth_mm.shape(0)),
            width = static_cast<int>(depth_mm.shape(1));
  return {static_cast<const std::uint16_t*>(depth_mm.data()), width, height, width};
}

ColorView color_view(const py::array& color) {
  const int height = static_cast<int>(color.shape(0)), width = static_cast<int>(color.shape(1));
  return {static_cast<const Rgb8*>(color.data()), width, height, width};
}

}  // namespace roomcast::python
