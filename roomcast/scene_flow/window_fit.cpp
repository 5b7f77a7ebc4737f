// SPDX-License-Identifier: Apache-2.0
#include "roomcast/scene_flow/window_fit.h"

#include <algorithm>
#include <cstddef>

namespace roomcast::scene_flow {
namespace {

constexpr std::int16_t kMaxFarther_mm = 150;
constexpr std::int16_t kOther_mm = 60;  // from here on two depths count as two surfaces

constexpr std::int16_t narrow(int value) {
  return static_cast<std::int16_t>(value);
}

int sum_of(const std::int16_t (&lanes)[8]) {
  int sum = 0;
  for (const std::int16_t lane : lanes) sum += lane;
  return sum;
}

}  // namespace

template <int kReach>
Window<kReach> window_at(const std::int16_t* first, std::ptrdiff_t stride) {
  Window<kReach> window{};
  for (int row = 0; row < Window<kReach>::kRows; ++row) {
    for (int x = 0; x < Window<kReach>::kRows; ++x)
      window.cells[row * Window<kReach>::kLanes + x] = first[row * stride + x];
  }
  return window;
}

template <int kReach>
WindowFit fit(const Window<kReach>& window, const std::int16_t* other_first,
              std::ptrdiff_t stride) {
  constexpr int kLanes = Window<kReach>::kLanes, kRows = Window<kReach>::kRows;
  alignas(16) std::int16_t both[kLanes]{}, any[kLanes]{}, farther[kLanes]{};
  for (int row = 0; row < kRows; ++row) {
    for (int x = 0; x < kLanes; ++x) {
      const std::int16_t inside = x < kRows ? narrow(-1) : narrow(0);
      const std::int16_t here = window.cells[row * kLanes + x];
      const std::int16_t there = narrow(other_first[row * stride + x] & inside);
      const std::int16_t in_here = here > 0 ? narrow(-1) : narrow(0);
      const std::int16_t in_there = there > 0 ? narrow(-1) : narrow(0);
      const std::int16_t in_both = narrow(in_here & in_there);
      const std::int16_t apart =
          std::clamp(narrow(there - here), narrow(-kMaxFarther_mm), kMaxFarther_mm);
      both[x] = narrow(both[x] - in_both);
      any[x] = narrow(any[x] - (in_here | in_there));
      farther[x] = narrow(farther[x] + (apart & in_both));
    }
  }
  const int in_both = sum_of(both), in_any = sum_of(any);
  if (in_both == 0) return {};
  const float farther_mm = static_cast<float>(sum_of(farther)) / static_cast<float>(in_both);
  const std::int16_t mean_mm = narrow(static_cast<int>(farther_mm));
  alignas(16) std::int16_t differ[kLanes]{};
  for (int row = 0; row < kRows; ++row) {
    for (int x = 0; x < kLanes; ++x) {
      const std::int16_t here = window.cells[row * kLanes + x];
      const std::int16_t there = other_first[row * stride + x];
      const std::int16_t in_both_here = here > 0 && there > 0 ? narrow(-1) : narrow(0);
      const std::int16_t more = narrow(there - here - mean_mm);
      const std::int16_t size = std::max(more, narrow(-more));
      differ[x] = narrow(differ[x] + (std::min(size, kOther_mm) & in_both_here));
    }
  }
  const float cost = static_cast<float>(in_any - in_both) +
                     static_cast<float>(sum_of(differ)) / static_cast<float>(kOther_mm);
  return {cost / static_cast<float>(in_any), farther_mm};
}

template Window<2> window_at(const std::int16_t*, std::ptrdiff_t);
template Window<3> window_at(const std::int16_t*, std::ptrdiff_t);
template WindowFit fit(const Window<2>&, const std::int16_t*, std::ptrdiff_t);
template WindowFit fit(const Window<3>&, const std::int16_t*, std::ptrdiff_t);

}  // namespace roomcast::scene_flow
