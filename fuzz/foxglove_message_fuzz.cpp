// SPDX-License-Identifier: Apache-2.0
// Reads an untrusted message of Foxglove's schemas, as every type that roomcast knows.
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "roomcast/recording/foxglove/foxglove_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace roomcast::recording;
  static FoxgloveReader reader;  // used again, as for the messages of a file
  const ros::ByteView bytes(data, size);
  std::size_t sum = 0;
  const auto add = [&sum](const auto& picture) {
    if (picture) sum = std::accumulate(picture->data.begin(), picture->data.end(), sum);
  };
  add(reader.raw_image(bytes));
  add(reader.compressed_image(bytes));
  add(reader.compressed_video(bytes));
  if (sum > 3 * 255 * size) __builtin_trap();
  const auto calibration = reader.calibration(bytes);
  if (calibration && calibration->d.size() > ros::kMaxLensTerms) __builtin_trap();
  (void)reader.transform(bytes);
  const auto transforms = reader.transforms(bytes);
  if (transforms && transforms->size() > ros::kMaxTransforms) __builtin_trap();
  return 0;
}
