// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/sparse_completion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace roomcast::sensor {
namespace {

constexpr int kCell_px = 4;         // a plane is fitted to the readings in 3 x 3 cells
constexpr int kSurrounding_px = 4;  // from a hole to the readings that surround it
// Of the 288 pairs of neighbours in 3 x 3 cells, those of which one alone has a reading. Where a
// quarter of the pixels has one by chance there are 108; at the ragged borders of what structured
// light does not see, fewer than 50.
constexpr std::size_t kMinBreaks = 50;
constexpr std::size_t kMinQuadrants = 3;
constexpr std::size_t kMinOfSurface = 6;  // readings
constexpr std::size_t kEnoughOfSurface = 24;
constexpr float kMinOnPlane = 0.6F;   // share of a surface's readings
constexpr int kFits = 2;              // the second without readings far from the first's plane
constexpr int kMinOfPiece = 5;        // readings in 3x3 pixels
constexpr float kAlmostZero = 1e-3F;  // keeps the plane through readings in one line finite

/// The largest distance of a reading from its plane: a bound on depth noise. Surfaces with few
/// readings reflect little light, so their readings are noisy.
float noise_mm(float depth_mm) {
  return 8 + depth_mm * depth_mm / 400'000;
}

/// Readings that follow each other in depth and are farther apart belong to different surfaces.
int apart_mm(int depth_mm) {
  return 40 + depth_mm / 50;
}

constexpr int kMaxDepth_mm = std::numeric_limits<std::uint16_t>::max();

struct Offset {
  int x, y;
};
using Quadrant =
    std::array<Offset, static_cast<std::size_t>(kSurrounding_px*(kSurrounding_px + 1))>;

/// Each quadrant has one of the two half axes at its border; its nearest pixels come first.
std::array<Quadrant, 4> quadrants_by_distance() {
  std::array<Quadrant, 4> quadrants;
  std::size_t i = 0;
  for (int u = 1; u <= kSurrounding_px; ++u) {
    for (int v = 0; v <= kSurrounding_px; ++v, ++i) {
      quadrants[0][i] = {u, v};
      quadrants[1][i] = {-v, u};
      quadrants[2][i] = {-u, -v};
      quadrants[3][i] = {v, -u};
    }
  }
  for (Quadrant& quadrant : quadrants)
    std::ranges::stable_sort(quadrant, {}, [](const Offset& o) { return o.x * o.x + o.y * o.y; });
  return quadrants;
}

/// Of 1 / depth over the picture, which is linear on a plane.
struct PlaneSums {
  Eigen::Matrix3f products = kAlmostZero * Eigen::Matrix3f::Identity();
  Eigen::Vector3f values = Eigen::Vector3f::Zero();

  void add(const Eigen::Vector3f& place, float value) {
    products.noalias() += place.lazyProduct(place.transpose());
    values += value * place;
  }
  [[nodiscard]] Eigen::Vector3f plane() const { return products.ldlt().solve(values); }
};

}  // namespace

/// A plane through readings.
class SparseCompletion::Surface {
 public:
  /// None unless most of `readings` lie on a plane.
  static std::optional<Surface> through(std::span<const Reading> readings) {
    Surface surface(readings.front());
    const std::size_t step = readings.size() / kEnoughOfSurface + 1;
    std::size_t all = 0, on_plane = 0;
    for (int fit = 0; fit < kFits; ++fit) {
      PlaneSums sums;
      all = on_plane = 0;
      for (std::size_t i = 0; i < readings.size(); i += step, ++all) {
        const Reading& reading = readings[i];
        if (fit > 0 && !surface.has(reading)) continue;
        sums.add(surface.place(reading.x, reading.y),
                 1 / static_cast<float>(reading.depth_mm) - surface.nearness_);
        ++on_plane;
      }
      if (on_plane < kMinOfSurface) return std::nullopt;
      surface.plane_ = sums.plane();
    }
    const auto in_pieces = std::ranges::count_if(readings, &Reading::in_piece);
    surface.is_scattered_ = 2 * static_cast<std::size_t>(in_pieces) <= readings.size();
    const float share = static_cast<float>(on_plane) / static_cast<float>(all);
    return share < kMinOnPlane ? std::nullopt : std::optional(surface);
  }

  /// Most of its readings stand alone.
  [[nodiscard]] bool is_scattered() const { return is_scattered_; }
  /// 0: none.
  [[nodiscard]] float depth_mm(int x, int y) const {
    const float nearness = nearness_ + plane_.dot(place(x, y));
    return nearness > 0 ? 1 / nearness : 0;
  }
  [[nodiscard]] bool has(const Reading& reading) const {
    const auto read_mm = static_cast<float>(reading.depth_mm);
    return read_mm > 0 && std::abs(depth_mm(reading.x, reading.y) - read_mm) <= noise_mm(read_mm);
  }

 private:
  explicit Surface(const Reading& first)
      : first_(first), nearness_(1 / static_cast<float>(first.depth_mm)) {}
  [[nodiscard]] Eigen::Vector3f place(int x, int y) const {
    return {1, static_cast<float>(x - first_.x), static_cast<float>(y - first_.y)};
  }

  Reading first_;
  float nearness_;                                   // 1/mm, of the first reading
  Eigen::Vector3f plane_ = Eigen::Vector3f::Zero();  // of what is added to it: there, right, down
  bool is_scattered_ = false;
};

SparseCompletion::SparseCompletion(int width, int height)
    : width_(width),
      height_(height),
      cells_(width / kCell_px + 3, height / kCell_px + 3),
      in_piece_(width, height) {
  holes_.reserve(static_cast<std::size_t>(kCell_px * kCell_px));
  readings_.reserve(static_cast<std::size_t>(9 * kCell_px * kCell_px));
  fills_.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

void SparseCompletion::complete(DepthImage& depth_mm) {
  fills_.clear();
  if (depth_mm.width() != width_ || depth_mm.height() != height_) return;
  count_readings(depth_mm);
  find_pieces(depth_mm);
  for (int top = 0; top < height_; top += kCell_px) {
    for (int left = 0; left < width_; left += kCell_px) {
      if (!is_sparse(left, top)) continue;
      find_holes(depth_mm, left, top);
      if (holes_.empty()) continue;
      find_readings(depth_mm, left, top);
      fill_between_readings();
    }
  }
  for (const Fill& fill : fills_) depth_mm.at(fill.x, fill.y) = fill.depth_mm;
}

SparseCompletion::Reading SparseCompletion::reading_at(DepthView depth_mm, int x, int y) const {
  return {depth_mm.at(x, y), static_cast<std::int16_t>(x), static_cast<std::int16_t>(y),
          in_piece_.at(x, y) != 0};
}

/// In cells with a border of empty ones around the picture.
void SparseCompletion::count_readings(DepthView depth_mm) {
  std::fill_n(cells_.data(), cells_.view().pixel_count(), Cell{});
  for (int y = 0; y < depth_mm.height; ++y) {
    const std::uint16_t *row = depth_mm.row(y), *above = depth_mm.row(std::max(y - 1, 0));
    Cell* const cells = cells_.view().row(y / kCell_px + 1) + 1;
    for (int x = 0; x < depth_mm.width; ++x) {
      Cell& cell = cells[x / kCell_px];
      const bool is_read = row[x] != 0;
      cell.readings += is_read ? 1 : 0;
      cell.breaks += is_read != (above[x] != 0) ? 1 : 0;
      cell.breaks += is_read != (row[std::max(x - 1, 0)] != 0) ? 1 : 0;
    }
  }
}

/// Pixels at the border of the picture are in none.
void SparseCompletion::find_pieces(DepthView depth_mm) {
  if (depth_mm.width < 3) return;
  for (int y = 1; y < depth_mm.height - 1; ++y) {
    const std::array rows{depth_mm.row(y - 1), depth_mm.row(y), depth_mm.row(y + 1)};
    const auto column = [&](int x) {
      return (rows[0][x] != 0 ? 1 : 0) + (rows[1][x] != 0 ? 1 : 0) + (rows[2][x] != 0 ? 1 : 0);
    };
    std::uint8_t* const in_piece = in_piece_.view().row(y);
    int left = column(0), middle = column(1);
    for (int x = 1; x < depth_mm.width - 1; ++x) {
      const int right = column(x + 1);
      in_piece[x] = left + middle + right >= kMinOfPiece ? 1 : 0;
      left = middle;
      middle = right;
    }
  }
}

/// Whether the cell lacks readings, and those around it are many enough and scattered.
bool SparseCompletion::is_sparse(int left, int top) const {
  const int x = left / kCell_px + 1, y = top / kCell_px + 1;
  if (cells_.at(x, y).readings == kCell_px * kCell_px) return false;
  std::size_t readings = 0, breaks = 0;
  for (int j = y - 1; j <= y + 1; ++j) {
    for (int i = x - 1; i <= x + 1; ++i) {
      readings += cells_.at(i, j).readings;
      breaks += cells_.at(i, j).breaks;
    }
  }
  return readings >= kMinOfSurface && breaks >= kMinBreaks;
}

void SparseCompletion::find_holes(DepthView depth_mm, int left, int top) {
  static const auto kQuadrants = quadrants_by_distance();
  const auto nearest = [&](int x, int y, const Quadrant& quadrant) {
    for (const Offset& offset : quadrant) {
      const int i = x + offset.x, j = y + offset.y;
      if (i < 0 || j < 0 || i >= depth_mm.width || j >= depth_mm.height) continue;
      if (depth_mm.at(i, j) != 0) return reading_at(depth_mm, i, j);
    }
    return Reading{};
  };
  holes_.clear();
  for (int y = top; y < std::min(top + kCell_px, depth_mm.height); ++y) {
    for (int x = left; x < std::min(left + kCell_px, depth_mm.width); ++x) {
      if (depth_mm.at(x, y) != 0) continue;
      Hole hole{x, y, {}};
      for (const Quadrant& quadrant : kQuadrants) {
        const Reading near = nearest(x, y, quadrant);
        if (near.depth_mm != 0) hole.around[hole.quadrants++] = near;
      }
      if (hole.quadrants >= kMinQuadrants) holes_.push_back(hole);
    }
  }
}

void SparseCompletion::find_readings(DepthView depth_mm, int left, int top) {
  readings_.clear();
  const int bottom = std::min(top + 2 * kCell_px, depth_mm.height);
  const int right = std::min(left + 2 * kCell_px, depth_mm.width);
  for (int y = std::max(top - kCell_px, 0); y < bottom; ++y) {
    const std::uint16_t* row = depth_mm.row(y);
    for (int x = std::max(left - kCell_px, 0); x < right; ++x) {
      if (row[x] != 0) readings_.push_back(reading_at(depth_mm, x, y));
    }
  }
}

/// Surface by surface, the nearest first.
void SparseCompletion::fill_between_readings() {
  const auto is_apart = [](const Reading& near, const Reading& far) {
    return far.depth_mm - near.depth_mm > apart_mm(near.depth_mm);
  };
  const auto [near, far] = std::ranges::minmax_element(readings_, {}, &Reading::depth_mm);
  if (is_apart(*near, *far)) std::ranges::sort(readings_, {}, &Reading::depth_mm);
  const std::span all(readings_);
  for (std::size_t first = 0, end = 0; first < all.size() && !holes_.empty(); first = end) {
    for (end = first + 1; end < all.size() && !is_apart(all[end - 1], all[end]);) ++end;
    if (end - first < kMinOfSurface) continue;
    if (const auto surface = Surface::through(all.subspan(first, end - first)))
      fill_holes(*surface);
  }
}

/// Fills holes that the surface surrounds. Also fills holes at its rim: there all other readings
/// around the hole are in pieces, and what they show would have been read in the hole, too.
void SparseCompletion::fill_holes(const Surface& surface) {
  std::erase_if(holes_, [&](const Hole& hole) {
    std::size_t on_surface = 0, in_pieces = 0;
    int nearest_mm = kMaxDepth_mm, farthest_mm = 0;
    for (const Reading& near : hole.around) {
      if (!surface.has(near)) {
        in_pieces += near.in_piece ? 1 : 0;
        continue;
      }
      ++on_surface;
      nearest_mm = std::min<int>(nearest_mm, near.depth_mm);
      farthest_mm = std::max<int>(farthest_mm, near.depth_mm);
    }
    const bool at_rim =
        surface.is_scattered() && on_surface > 0 && on_surface + in_pieces == hole.around.size();
    if (on_surface < kMinQuadrants && !at_rim) return false;
    const float depth_mm = surface.depth_mm(hole.x, hole.y);
    if (depth_mm < static_cast<float>(nearest_mm) - noise_mm(depth_mm) ||
        depth_mm > static_cast<float>(farthest_mm) + noise_mm(depth_mm))
      return false;
    fills_.push_back(
        {hole.x, hole.y,
         static_cast<std::uint16_t>(std::clamp(std::lround(depth_mm), 1L, long{kMaxDepth_mm}))});
    return true;
  });
}

}  // namespace roomcast::sensor
