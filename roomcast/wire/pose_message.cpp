// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/pose_message.h"

#include <span>

#include "roomcast/core/assert.h"

namespace roomcast::wire {
namespace {

constexpr std::size_t kTransformNumbers = 16;

}  // namespace

void write_transform(const RigidTransform& transform,
                     google::protobuf::RepeatedField<double>& row_major) {
  const auto numbers = row_major_from_transform(transform);
  row_major.Assign(numbers.begin(), numbers.end());
}

Result<RigidTransform> read_transform(const google::protobuf::RepeatedField<double>& row_major) {
  return transform_from_row_major(
      std::span(row_major.data(), static_cast<std::size_t>(row_major.size())));
}

RigidTransform exact_transform(const google::protobuf::RepeatedField<double>& row_major) {
  ROOMCAST_ASSERT(row_major.size() == int{kTransformNumbers});
  return exact_transform_from_row_major(
      std::span<const double, kTransformNumbers>(row_major.data(), kTransformNumbers));
}

}  // namespace roomcast::wire
