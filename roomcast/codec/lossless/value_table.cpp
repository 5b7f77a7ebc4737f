// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/lossless/value_table.h"

#include <algorithm>

#include "roomcast/codec/lossless/side_information.h"

namespace roomcast::codec {
namespace {

/// Whether the distances are few enough for coding by index to save bits.
bool pays(const std::vector<std::uint16_t>& values) {
  const std::size_t count = values.size() - 1;
  return count > 0 && 2 * count < values.back() - values[1] + 1u;
}

}  // namespace

bool ValueTable::choose(DepthView depth_mm, int bound_mm, std::vector<std::uint16_t>& values) {
  mark_values(depth_mm);
  group(0, values);
  if (!pays(values)) return false;
  if (bound_mm > 0) {
    mark_values(depth_mm);
    group(bound_mm, values);
  }
  return true;
}

void ValueTable::mark_values(DepthView depth_mm) {
  index_of_value_.assign(kDepthValueCount, 0);
  for (int y = 0; y < depth_mm.height; ++y) {
    const std::uint16_t* row = depth_mm.row(y);
    for (int x = 0; x < depth_mm.width; ++x) index_of_value_[row[x]] = 1;
  }
  index_of_value_[0] = 0;
}

void ValueTable::group(int bound_mm, std::vector<std::uint16_t>& values) {
  values.assign(1, 0);
  std::size_t first = 0, last = 0;  // of the open group; 0: none is open
  const auto close = [&] {
    if (first != 0) values.push_back(static_cast<std::uint16_t>((first + last) / 2));
  };
  for (std::size_t value = 1; value < kDepthValueCount; ++value) {
    if (!index_of_value_[value]) continue;
    if (first == 0 || value > first + 2 * static_cast<std::size_t>(bound_mm)) {
      close();
      first = value;
    }
    last = value;
    index_of_value_[value] = static_cast<std::uint16_t>(values.size());
  }
  close();
}

void ValueTable::map(DepthView depth_mm, ImageView<std::uint16_t> indices) const {
  for (int y = 0; y < depth_mm.height; ++y) {
    const std::uint16_t* from = depth_mm.row(y);
    std::uint16_t* to = indices.row(y);
    for (int x = 0; x < depth_mm.width; ++x) to[x] = index_of_value_[from[x]];
  }
}

}  // namespace roomcast::codec
