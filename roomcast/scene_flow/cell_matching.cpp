// SPDX-License-Identifier: Apache-2.0
#include "roomcast/scene_flow/cell_matching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>

#include "roomcast/core/assert.h"
#include "roomcast/scene_flow/window_fit.h"

namespace roomcast::scene_flow {
namespace {

constexpr int kReach = 3;              // of a cell's neighbourhood, in cells
constexpr int kCoarseReach = 2;        // in cells of twice the size
constexpr float kCostOfCell = 0.004F;  // prefers no motion where several fit alike
constexpr int kMaxWithoutSkips = 4;    // of the first search; longer ways are tried by twos first
constexpr int kSmoothReach = 2;
constexpr int kSameSurface_mm = 150;
constexpr int kMaxSteps = 4;  // downhill, in cells
// Of the longest way, the steps downhill, those beside them, and a window with its whole row.
constexpr int kBorder = kMaxWay_cells + kMaxSteps + 1 + kReach + 8;

constexpr std::array<std::array<int, 2>, 5> kHereAndBeside = {
    {{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

float cost_of_way(int x, int y) {
  return kCostOfCell * std::sqrt(static_cast<float>(x * x + y * y));
}

void halve(const CellDepths& fine, CellDepths& coarse) {
  coarse.resize(fine.width() / 2, fine.height() / 2);
  for (int y = 0; y < coarse.height(); ++y) {
    for (int x = 0; x < coarse.width(); ++x) {
      int sum = 0, count = 0;
      for (int i = 0; i < 4; ++i) {
        const int depth_mm = fine.at(2 * x + i % 2, 2 * y + i / 2);
        sum += depth_mm;
        count += depth_mm > 0;
      }
      coarse.at(x, y) = count > 1 ? static_cast<std::int16_t>(sum / count) : std::int16_t{0};
    }
  }
}

void pad(const CellDepths& cells, int border, CellDepths& padded) {
  padded.resize(cells.width() + 2 * border, cells.height() + 2 * border);
  for (int y = 0; y < cells.height(); ++y) {
    std::copy_n(cells.view().row(y), cells.width(), padded.view().row(y + border) + border);
  }
}

/// Where a parabola through three costs, one step apart, is lowest: -0.5 to 0.5.
float lowest(float before, float here, float after) {
  const float bend = before + after - 2 * here;
  return bend > 1e-6F ? std::clamp(0.5F * (before - after) / bend, -0.5F, 0.5F) : 0;
}

}  // namespace

CellMatcher::Match CellMatcher::best_of_coarse(int x, int y, int max_cells) const {
  const auto newest = padded_coarse_newest_.view(), earlier = padded_coarse_earlier_.view();
  const int left = x + kBorder - kCoarseReach, top = y + kBorder - kCoarseReach;
  const auto window = window_at<kCoarseReach>(newest.row(top) + left, newest.stride);
  Match best{0, 0, 0, std::numeric_limits<float>::infinity()};
  const auto attempt = [&](int by_x, int by_y) {
    const WindowFit fits = fit(window, earlier.row(top + by_y) + left + by_x, earlier.stride);
    const float cost = fits.cost + 2 * cost_of_way(by_x, by_y);
    if (cost < best.cost) best = {by_x, by_y, fits.farther_mm, cost};
  };
  const int stride = max_cells > kMaxWithoutSkips ? 2 : 1;
  for (int by_y = -max_cells; by_y <= max_cells; by_y += stride) {
    for (int by_x = -max_cells; by_x <= max_cells; by_x += stride) attempt(by_x, by_y);
  }
  if (stride == 1) return best;
  const Match middle = best;
  for (int i = -1; i <= 1; ++i) {
    for (int j = -1; j <= 1; ++j) attempt(middle.x + j, middle.y + i);
  }
  return best;
}

/// Of no motion and what the first search found here and beside it.
template <class Costs>
CellMatcher::Match CellMatcher::best_start(int x, int y, const Costs& cost_of) const {
  Match best = cost_of(0, 0);
  for (const auto& [beside_x, beside_y] : kHereAndBeside) {
    const int u = x / 2 + beside_x, v = y / 2 + beside_y;
    const bool is_there = u >= 0 && v >= 0 && u < coarse_.width() && v < coarse_.height();
    if (!is_there || coarse_newest_.at(u, v) == 0) continue;
    const int by_x = 2 * coarse_.at(u, v).x, by_y = 2 * coarse_.at(u, v).y;
    if (by_x == best.x && by_y == best.y) continue;
    const Match start = cost_of(by_x, by_y);
    if (start.cost < best.cost) best = start;
  }
  return best;
}

/// From the best start downhill, and between the cells there.
Displacement CellMatcher::best_of_fine(int x, int y) const {
  const auto newest = padded_newest_.view(), earlier = padded_earlier_.view();
  const int left = x + kBorder - kReach, top = y + kBorder - kReach;
  const auto window = window_at<kReach>(newest.row(top) + left, newest.stride);
  const auto cost_of = [&](int by_x, int by_y) {
    const WindowFit fits = fit(window, earlier.row(top + by_y) + left + by_x, earlier.stride);
    return Match{by_x, by_y, fits.farther_mm, fits.cost + cost_of_way(by_x, by_y)};
  };
  Match best = best_start(x, y, cost_of);
  for (int step = 0;; ++step) {
    const Match left_of = cost_of(best.x - 1, best.y), right_of = cost_of(best.x + 1, best.y);
    const Match above = cost_of(best.x, best.y - 1), below = cost_of(best.x, best.y + 1);
    const Match& next = std::min({left_of, right_of, above, below},
                                 [](const Match& a, const Match& b) { return a.cost < b.cost; });
    if (step < kMaxSteps && next.cost < best.cost) {
      best = next;
      continue;
    }
    return {static_cast<float>(best.x) + lowest(left_of.cost, best.cost, right_of.cost),
            static_cast<float>(best.y) + lowest(above.cost, best.cost, below.cost), best.farther_mm,
            best.cost};
  }
}

/// The median of each component over the cells around on the same surface.
void CellMatcher::smooth(const CellDepths& newest) {
  smooth_.resize(newest.width(), newest.height());
  const auto median = [this] {
    const auto middle = around_.begin() + static_cast<std::ptrdiff_t>(around_.size() / 2);
    std::nth_element(around_.begin(), middle, around_.end());
    return *middle;
  };
  for (int y = 0; y < newest.height(); ++y) {
    for (int x = 0; x < newest.width(); ++x) {
      const int here_mm = newest.at(x, y);
      if (here_mm == 0) continue;
      smooth_.at(x, y).cost = found_.at(x, y).cost;
      for (float Displacement::*part :
           {&Displacement::x, &Displacement::y, &Displacement::farther_mm}) {
        around_.clear();
        for (int v = std::max(y - kSmoothReach, 0);
             v <= std::min(y + kSmoothReach, newest.height() - 1); ++v) {
          for (int u = std::max(x - kSmoothReach, 0);
               u <= std::min(x + kSmoothReach, newest.width() - 1); ++u) {
            const int depth_mm = newest.at(u, v);
            if (depth_mm > 0 && std::abs(depth_mm - here_mm) < kSameSurface_mm)
              around_.push_back(found_.at(u, v).*part);
          }
        }
        smooth_.at(x, y).*part = median();
      }
    }
  }
}

const Image<Displacement>& CellMatcher::match(const CellDepths& newest, const CellDepths& earlier,
                                              float max_cells_at_1_m) {
  ROOMCAST_ASSERT(newest.width() == earlier.width() && newest.height() == earlier.height());
  halve(newest, coarse_newest_);
  halve(earlier, coarse_earlier_);
  pad(newest, kBorder, padded_newest_);
  pad(earlier, kBorder, padded_earlier_);
  pad(coarse_newest_, kBorder, padded_coarse_newest_);
  pad(coarse_earlier_, kBorder, padded_coarse_earlier_);
  coarse_.resize(coarse_newest_.width(), coarse_newest_.height());
  for (int y = 0; y < coarse_.height(); ++y) {
    for (int x = 0; x < coarse_.width(); ++x) {
      const int depth_mm = coarse_newest_.at(x, y);
      if (depth_mm == 0) continue;
      const float cells = 1000 * max_cells_at_1_m / static_cast<float>(depth_mm);
      const int max_cells = static_cast<int>(std::clamp(cells, 2.0F, float{kMaxWay_cells}));
      coarse_.at(x, y) = best_of_coarse(x, y, max_cells / 4 * 2 + 2);
    }
  }
  found_.resize(newest.width(), newest.height());
  for (int y = 0; y < newest.height(); ++y) {
    for (int x = 0; x < newest.width(); ++x) {
      if (newest.at(x, y) > 0) found_.at(x, y) = best_of_fine(x, y);
    }
  }
  smooth(newest);
  return smooth_;
}

}  // namespace roomcast::scene_flow
