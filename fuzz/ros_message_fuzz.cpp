// SPDX-License-Identifier: Apache-2.0
// Reads an untrusted ROS message in both serialisations, as every type that roomcast knows.
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "roomcast/recording/ros/messages.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace roomcast::recording::ros;
  const ByteView bytes(data, size);
  for (const Serialisation from : {Serialisation::kRos1, Serialisation::kRos2}) {
    std::size_t sum = 0;
    if (const auto image = read_image(bytes, from))
      sum = std::accumulate(image->data.begin(), image->data.end(), sum);
    if (const auto image = read_compressed_image(bytes, from))
      sum = std::accumulate(image->data.begin(), image->data.end(), sum);
    if (sum > 2 * 255 * size) __builtin_trap();
    const auto info = read_camera_info(bytes, from);
    if (info && info->d.size() > kMaxLensTerms) __builtin_trap();
    const auto transforms = read_transforms(bytes, from);
    if (transforms && transforms->size() > kMaxTransforms) __builtin_trap();
    (void)read_transform(bytes, from);
    (void)read_key_value(bytes, from);
  }
  return 0;
}
