// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/sender/watched_blocks.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <Eigen/Geometry>

namespace roomcast::sensor {
namespace {

using codec::BlockNeed;

constexpr int kSide = codec::kNeedSide;
constexpr float kPerMm = 0.001F;
/// Blocks side by side whose distances differ by less are of one surface: a share of the distance.
constexpr int kOneSurfaceShare = 12;

/// Of so many seconds; at least two.
int references_in(double seconds, const WatchedBlocksOptions& options) {
  return std::max(2, static_cast<int>(std::lround(options.references_per_s * seconds)));
}

Eigen::Vector3f vector_of(const wire::pb::Point& point) {
  return {point.x(), point.y(), point.z()};
}

}  // namespace

WatchedBlocks::WatchedBlocks(const CameraIntrinsics& depth, WatchedBlocksOptions options)
    : options_(options),
      outside_every_(references_in(options.outside_every_s, options)),
      away_every_(references_in(options.away_every_s, options)),
      edge_on_(std::cos(options.edge_on_rad)),
      away_(std::cos(options.away_rad)),
      wide_(codec::need_blocks(depth.width)),
      high_(codec::need_blocks(depth.height)),
      radius_(static_cast<float>(kSide * std::numbers::sqrt2 / 2 / std::min(depth.fx, depth.fy))),
      needs_(wide_, high_) {
  const auto blocks = static_cast<std::size_t>(wide_) * static_cast<std::size_t>(high_);
  now_.resize(blocks);
  shown_.resize(blocks);
  rays_.reserve(blocks);
  constexpr double kMiddle = (kSide - 1) / 2.0;
  for (int row = 0; row < high_; ++row) {
    for (int column = 0; column < wide_; ++column) {
      const auto ray = unproject(depth, {column * kSide + kMiddle, row * kSide + kMiddle}, 1);
      rays_.push_back(ray ? Eigen::Vector2f(ray->head<2>().cast<float>())
                          : Eigen::Vector2f::Constant(std::nanf("")));
    }
  }
}

void WatchedBlocks::watch_from(const wire::pb::WatchedFrom& watched) {
  views_.clear();
  for (const wire::pb::ViewCone& cone : watched.cones()) {
    views_.emplace_back(
        ViewCone{vector_of(cone.eye()),
                 vector_of(cone.forward()).normalized(),
                 {cone.half_angle(), cone.half_width(), cone.half_height()},
                 cone.has_up() ? vector_of(cone.up()).normalized() : Eigen::Vector3f::Zero()});
  }
}

codec::BlockNeedsView WatchedBlocks::update(DepthView now_mm, DepthView shown_mm,
                                            int frames_per_reference) {
  // A turn lasts until a frame of layer 0 has come for certain.
  if (++frame_ % static_cast<unsigned>(frames_per_reference) == 0) ++reference_;
  if (views_.empty() || now_mm.data == nullptr || !same_size(now_mm, shown_mm)) return {};
  measure(now_mm, now_);
  measure(shown_mm, shown_);
  for (int row = 0; row < high_; ++row) {
    for (int column = 0; column < wide_; ++column) {
      if (is_known(index(column, row))) needs_.at(column, row) = need_of(column, row);
    }
  }
  for (int row = 0; row < high_; ++row) {
    for (int column = 0; column < wide_; ++column) {
      if (!is_known(index(column, row))) needs_.at(column, row) = need_around(column, row);
    }
  }
  return needs_;
}

void WatchedBlocks::measure(DepthView depth_mm, std::vector<Reach>& blocks) const {
  std::fill(blocks.begin(), blocks.end(), Reach{0xFFFF, 0});
  for (int y = 0; y < depth_mm.height; ++y) {
    const std::uint16_t* const row = depth_mm.row(y);
    Reach* block = &blocks[index(0, y / kSide)];
    for (int begin = 0; begin < depth_mm.width; begin += kSide, ++block) {
      const int end = std::min(begin + kSide, depth_mm.width);
      for (int x = begin; x < end; ++x) {
        // 0 wraps to the largest number, so that it is never the nearest.
        block->near_mm =
            std::min<std::uint16_t>(block->near_mm, static_cast<std::uint16_t>(row[x] - 1U));
        block->far_mm = std::max(block->far_mm, row[x]);
      }
    }
  }
  for (Reach& block : blocks)
    block.near_mm =
        block.far_mm == 0 ? std::uint16_t{0} : static_cast<std::uint16_t>(block.near_mm + 1U);
}

bool WatchedBlocks::is_known(std::size_t block) const {
  return (now_[block].is_known() || shown_[block].is_known()) && rays_[block].allFinite();
}

/// A block without a reading may be anywhere; it is taken to be where those beside it are.
BlockNeed WatchedBlocks::need_around(int column, int row) const {
  bool is_any = false;
  BlockNeed most = BlockNeed::kNothing;
  for (int y = std::max(0, row - 1); y <= std::min(high_ - 1, row + 1); ++y) {
    for (int x = std::max(0, column - 1); x <= std::min(wide_ - 1, column + 1); ++x) {
      if (!is_known(index(x, y))) continue;
      is_any = true;
      most = std::max(most, needs_.at(x, y));
    }
  }
  return is_any ? most : BlockNeed::kAll;
}

BlockNeed WatchedBlocks::need_of(int column, int row) const {
  const std::size_t block = index(column, row);
  const Reach &now = now_[block], &shown = shown_[block];
  Sight best = Sight::kOutside;
  bool has_gone = false;
  for (const auto* blocks : {&now_, &shown_}) {
    const Reach& reach = (*blocks)[block];
    if (!reach.is_known()) continue;
    const Eigen::Vector3f normal = normal_of(*blocks, column, row);
    const Sight sight = sight_of(block, reach.near_mm, normal);
    best = std::max(best, sight);
    const bool is_there = now.is_known() && now.near_mm <= shown.near_mm + options_.jump_mm;
    has_gone |= blocks == &shown_ && sight != Sight::kOutside && !is_there;
    const bool is_one = reach.far_mm - reach.near_mm <= options_.jump_mm;
    if (!is_one) best = std::max(best, sight_of(block, reach.far_mm, Eigen::Vector3f::Zero()));
    if (best == Sight::kSeen) return BlockNeed::kAll;
  }
  if (best == Sight::kOutside) return turn_of(row, outside_every_);
  if (best == Sight::kEdgeOn) return BlockNeed::kBaseOnly;
  const BlockNeed turn = turn_of(row, away_every_);
  return has_gone ? std::max(turn, BlockNeed::kShapeOnly) : turn;
}

/// How a point of a block is seen at best; a normal of length 0 is not known.
WatchedBlocks::Sight WatchedBlocks::sight_of(std::size_t block, std::uint16_t z_mm,
                                             const Eigen::Vector3f& normal) const {
  const Eigen::Vector3f at_m = point(block, z_mm);
  const float radius_m = radius_ * at_m.z();
  Sight best = Sight::kOutside;
  for (const ViewBounds& view : views_) {
    const Eigen::Vector3f away = at_m - view.eye_m();
    const float squared = away.squaredNorm();
    const float near_m = options_.at_hand_m + radius_m;
    if (squared < near_m * near_m) return Sight::kSeen;
    if (view.distance_outside(away) > radius_m) continue;
    const float facing = -away.dot(normal) / std::sqrt(squared);
    if (normal.isZero() || facing >= edge_on_) return Sight::kSeen;
    best = std::max(best, facing >= away_ ? Sight::kEdgeOn : Sight::kAway);
  }
  return best;
}

/// Of the nearer surface of a block, towards the sensor, by the blocks beside it on the same
/// surface; 0 if there are too few.
Eigen::Vector3f WatchedBlocks::normal_of(const std::vector<Reach>& blocks, int column,
                                         int row) const {
  const std::size_t here = index(column, row);
  const int near_mm = blocks[here].near_mm;
  const auto neighbour = [&](int dx, int dy) {
    const int x = column + dx, y = row + dy;
    if (x < 0 || y < 0 || x >= wide_ || y >= high_) return here;
    const std::size_t there = index(x, y);
    const int there_mm = blocks[there].near_mm;
    const bool is_same = there_mm != 0 && rays_[there].allFinite() &&
                         std::abs(there_mm - near_mm) * kOneSurfaceShare < near_mm;
    return is_same ? there : here;
  };
  const auto across = [&](int dx, int dy) {
    const std::size_t before = neighbour(-dx, -dy), after = neighbour(dx, dy);
    return Eigen::Vector3f(point(after, blocks[after].near_mm) -
                           point(before, blocks[before].near_mm));
  };
  const Eigen::Vector3f normal = across(0, 1).cross(across(1, 0));
  const float length = normal.norm();
  return length > 0 ? Eigen::Vector3f(normal / length) : Eigen::Vector3f::Zero();
}

Eigen::Vector3f WatchedBlocks::point(std::size_t block, std::uint16_t z_mm) const {
  const float z_m = static_cast<float>(z_mm) * kPerMm;
  return {rays_[block].x() * z_m, rays_[block].y() * z_m, z_m};
}

/// Turns go round over the rows of blocks of colour.
BlockNeed WatchedBlocks::turn_of(int row, int every) const {
  constexpr unsigned kColorEvery = 4;  // turns
  const unsigned place = reference_ + static_cast<unsigned>(row) / 2;
  const auto turns = static_cast<unsigned>(every);
  if (place % turns != 0) return BlockNeed::kNothing;
  return place / turns % kColorEvery == 0 ? BlockNeed::kBaseOnly : BlockNeed::kShapeOnly;
}

std::size_t WatchedBlocks::index(int column, int row) const {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(wide_) +
         static_cast<std::size_t>(column);
}

}  // namespace roomcast::sensor
