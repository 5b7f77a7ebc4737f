// SPDX-License-Identifier: Apache-2.0
// NumPy arrays of our pictures, points and transforms. Arrays of pictures and points are read-only
// views without a copy; each keeps the memory that it shows alive by its base object. Threading:
// call with the interpreter's lock.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <pybind11/numpy.h>

#include "roomcast/core/image.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::python {

using Owner = std::shared_ptr<const void>;

[[nodiscard]] pybind11::array array_of(DepthView depth_mm, const Owner& owner);  // H x W, uint16
[[nodiscard]] pybind11::array array_of(ColorView color, const Owner& owner);     // H x W x 3, uint8
[[nodiscard]] pybind11::array array_of(MaskView mask, const Owner& owner);       // H x W, uint8

/// N x 3, float32 or uint8.
[[nodiscard]] pybind11::array array_of(const std::vector<Eigen::Vector3f>& rows,
                                       const Owner& owner);
[[nodiscard]] pybind11::array array_of(const std::vector<Rgb8>& rows, const Owner& owner);

/// 4 x 4, float64: a copy.
[[nodiscard]] pybind11::array array_of(const RigidTransform& transform);
/// The same; None for nothing.
[[nodiscard]] pybind11::object array_or_none(const std::optional<RigidTransform>& transform);

/// Reads 4 x 4 numbers. Throws Failure, naming `what`, unless they are a rigid transform's.
[[nodiscard]] RigidTransform transform_of(const pybind11::object& matrix, const char* what);

/// A picture that Python gives: of this element type and shape, rows without gaps; a copy where
/// they have gaps. Throws Failure, naming `what`. The array must outlive the view.
[[nodiscard]] pybind11::array depth_array(const pybind11::object& given, const char* what);
[[nodiscard]] pybind11::array color_array(const pybind11::object& given, const char* what);
[[nodiscard]] DepthView depth_view(const pybind11::array& depth_mm);
[[nodiscard]] ColorView color_view(const pybind11::array& color);

}  // namespace roomcast::python
