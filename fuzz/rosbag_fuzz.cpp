// SPDX-License-Identifier: Apache-2.0
// Reads an untrusted ROS 1 bag and its messages: any bytes are refused or read, within memory
// limits.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "roomcast/recording/rosbag/bag.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace roomcast::recording;
  auto bag = rosbag::Bag::read(bytes_in_memory({data, data + size}));
  if (!bag) return 0;
  const std::size_t count = std::min<std::size_t>(bag->messages().size(), 64);
  for (std::size_t i = 0; i < count; ++i) {
    const rosbag::MessagePlace place = bag->messages()[i];
    if (!bag->connections().contains(place.connection)) __builtin_trap();
    const auto message = bag->data(place);
    // Reads every byte, so that the sanitizer detects bytes out of bounds.
    if (message && std::accumulate(message->begin(), message->end(), std::size_t{0}) >
                       255 * rosbag::kMaxChunkBytes)
      __builtin_trap();
  }
  return 0;
}
