// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/room_volume.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>
#include <vector>

#include "roomcast/model/cube_cases.h"

namespace roomcast::model {
namespace {

constexpr int kMaxBlocksAcross = 16;        // of the four pixels of a quad
constexpr float kAroundSurface_voxels = 2;  // blocks this near to a view's surface are looked at
constexpr std::size_t kMaxCandidateBytes = 256'000'000;
constexpr int kPlaceBits = 21;

/// Orders places by z, then y, then x.
std::uint64_t code_of(const GridPlace& place) {
  constexpr std::int64_t kHalf = std::int64_t{1} << (kPlaceBits - 1);
  const auto bits = [](std::int32_t value) { return static_cast<std::uint64_t>(value + kHalf); };
  return bits(place.z) << (2 * kPlaceBits) | bits(place.y) << kPlaceBits | bits(place.x);
}

GridPlace place_of(std::uint64_t code) {
  constexpr std::uint64_t kMask = (std::uint64_t{1} << kPlaceBits) - 1;
  constexpr std::int64_t kHalf = std::int64_t{1} << (kPlaceBits - 1);
  const auto value = [&](int shift) {
    return static_cast<std::int32_t>(static_cast<std::int64_t>(code >> shift & kMask) - kHalf);
  };
  return {value(0), value(kPlaceBits), value(2 * kPlaceBits)};
}

void add_box(const Eigen::Vector3f& low_m, const Eigen::Vector3f& high_m, float block_m,
             std::vector<std::uint64_t>& codes) {
  const Eigen::Vector3i low = (low_m / block_m).array().floor().cast<int>();
  const Eigen::Vector3i high = (high_m / block_m).array().floor().cast<int>();
  if ((high - low).maxCoeff() >= kMaxBlocksAcross) return;
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x) {
        const std::uint64_t code = code_of({x, y, z});
        if (codes.empty() || codes.back() != code) codes.push_back(code);
      }
}

void sort_unique(std::vector<std::uint64_t>& codes) {
  std::ranges::sort(codes);
  const auto rest = std::ranges::unique(codes);
  codes.erase(rest.begin(), rest.end());
}

/// The blocks near a view's surface.
void add_blocks(const ViewSurface& view, float voxel_m, std::vector<std::uint64_t>& codes) {
  const float block_m = voxel_m * kBlockCells, around_m = kAroundSurface_voxels * voxel_m;
  const auto& texels = view.texels();
  std::vector<std::uint64_t> of_view;
  for (int y = 0; y < texels.height(); ++y) {
    for (int x = 0; x < texels.width(); ++x) {
      if (texels.at(x, y).inverse_m == 0) continue;
      const Eigen::Vector3f at = view.world_point(x, y);
      Eigen::Vector3f low = at, high = at;
      if (view.is_quad(x, y)) {
        for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
          const Eigen::Vector3f corner = view.world_point(x + dx, y + dy);
          low = low.cwiseMin(corner);
          high = high.cwiseMax(corner);
        }
      }
      add_box(low.array() - around_m, high.array() + around_m, block_m, of_view);
    }
    if (y % 32 == 0) sort_unique(of_view);
  }
  codes.insert(codes.end(), of_view.begin(), of_view.end());
  sort_unique(codes);
}

constexpr std::size_t kCorners = kBlockCorners * kBlockCorners * kBlockCorners;

/// What the views know about a corner.
struct Fused {
  float sum = 0, weight = 0;
  bool hidden = false;                               // farther behind a surface
  Eigen::Vector3f facing = Eigen::Vector3f::Zero();  // sum of the normals of surfaces nearby
};

/// A corner behind a view's surface.
struct Behind {
  std::size_t corner = 0;
  ViewSample sample;
};

/// Sums up what the views know about the corners of a block.
class BlockFusion {
 public:
  BlockFusion(const GridPlace& place, const ModelOptions& options)
      : corner_{kBlockCells * place.x, kBlockCells * place.y, kBlockCells * place.z},
        options_(options),
        in_front_m_(options.truncation_voxels * options.voxel_m) {}

  void add(const ViewSurface& view) {
    std::size_t i = 0;
    for (int z = 0; z < kBlockCorners; ++z)
      for (int y = 0; y < kBlockCorners; ++y)
        for (int x = 0; x < kBlockCorners; ++x, ++i)
          if (const auto sample = view.sample(point_m(x, y, z))) add(i, *sample);
  }

  /// Call once, after all views. Behind a surface less and less is known from a voxel on, and
  /// nothing where another sensor sees the other side of a thin thing.
  void add_behind() {
    for (const auto& [corner, sample] : behind_) {
      Fused& at = fused_[corner];
      if (at.facing.dot(sample.normal) < 0) continue;
      const float fading =
          (sample.distance_m + sample.truncation_m) / (sample.truncation_m - options_.voxel_m);
      add_to(at, sample, std::max(fading, kFarBehind) * sample.weight);
    }
  }

  [[nodiscard]] VolumeBlock block(const GridPlace& place) const {
    VolumeBlock block{place, {}};
    const float units = VolumeBlock::kUnitsPerVoxel / options_.voxel_m;
    std::ranges::transform(fused_, block.distances.begin(), [&](const Fused& at) {
      if (at.weight == 0) return at.hidden ? VolumeBlock::kHidden : VolumeBlock::kUnknown;
      return static_cast<std::int16_t>(std::lround(units * at.sum / at.weight));
    });
    return block;
  }

 private:
  static constexpr float kFarBehind = 0.05F;

  /// From whole numbers, so that neighbouring blocks get the same values at their common side.
  [[nodiscard]] Eigen::Vector3f point_m(int x, int y, int z) const {
    return options_.voxel_m * Eigen::Vector3f(static_cast<float>(corner_.x + x),
                                              static_cast<float>(corner_.y + y),
                                              static_cast<float>(corner_.z + z));
  }

  void add(std::size_t corner, const ViewSample& sample) {
    if (sample.distance_m < -sample.truncation_m) {
      fused_[corner].hidden = true;
      return;
    }
    if (sample.distance_m < -options_.voxel_m) {
      behind_.push_back({corner, sample});
      return;
    }
    const bool free = sample.distance_m > in_front_m_;
    add_to(fused_[corner], sample, free ? sample.free_weight : sample.weight);
    if (!free) fused_[corner].facing += sample.weight * sample.normal;
  }

  void add_to(Fused& at, const ViewSample& sample, float weight) const {
    at.sum += weight * std::clamp(sample.distance_m, -in_front_m_, in_front_m_);
    at.weight += weight;
  }

  GridPlace corner_;
  const ModelOptions& options_;
  float in_front_m_;
  std::array<Fused, kCorners> fused_{};
  std::vector<Behind> behind_;
};

bool has_surface(const VolumeBlock& block) {
  for (int z = 0; z < kBlockCells; ++z)
    for (int y = 0; y < kBlockCells; ++y)
      for (int x = 0; x < kBlockCells; ++x)
        if (cube_of_cell(block, x, y, z) != 0) return true;
  return false;
}

std::optional<VolumeBlock> fuse_block(const GridPlace& place, std::span<const ViewSurface> views,
                                      const ModelOptions& options) {
  const GridPlace corner = {kBlockCells * place.x, kBlockCells * place.y, kBlockCells * place.z};
  const float half = 0.5F * kBlockCells;
  const Eigen::Vector3f center_m =
      options.voxel_m * Eigen::Vector3f(static_cast<float>(corner.x) + half,
                                        static_cast<float>(corner.y) + half,
                                        static_cast<float>(corner.z) + half);
  const float radius_m = 1.74F * half * options.voxel_m;
  BlockFusion fusion(place, options);
  for (const ViewSurface& view : views)
    if (view.may_see(center_m, radius_m)) fusion.add(view);
  fusion.add_behind();
  const VolumeBlock block = fusion.block(place);
  return has_surface(block) ? std::optional(block) : std::nullopt;
}

Error too_large(const ModelOptions& options) {
  return {ErrorCode::kTooLarge, "the model of this room needs more than " +
                                    std::to_string(options.max_bytes / 1'000'000) + " MB at " +
                                    std::to_string(std::lround(1000 * options.voxel_m)) +
                                    " mm; choose a larger --voxel"};
}

}  // namespace

int cube_of_cell(const VolumeBlock& block, int x, int y, int z) {
  std::array<std::int16_t, 8> corners{};
  int cube = 0;
  for (int i = 0; i < 8; ++i) {
    const std::int16_t distance = block.at(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2));
    if (distance == VolumeBlock::kUnknown) return 0;
    corners[static_cast<std::size_t>(i)] = distance;
    cube |= static_cast<int>(distance < 0) << i;
  }
  if (cube == 0 || cube == 255) return 0;
  for (int edge = 0; edge < 12; ++edge) {
    const CubeEdge e = cube_edge(edge);
    const auto from = static_cast<std::size_t>(e.corner);
    if (is_step(corners[from], corners[from | 1U << static_cast<unsigned>(e.axis)])) return 0;
  }
  return cube;
}

float crossing(std::int16_t from, std::int16_t to) {
  constexpr float kFromCorner = 0.01F;  // in a corner several points would be one
  // Just before a surface, what is hidden is a voxel farther.
  const auto distance = [](std::int16_t here, std::int16_t other) {
    return here == VolumeBlock::kHidden ? static_cast<float>(other) - VolumeBlock::kUnitsPerVoxel
                                        : static_cast<float>(here);
  };
  const float a = distance(from, to), b = distance(to, from);
  return std::clamp(a / (a - b), kFromCorner, 1 - kFromCorner);
}

Result<RoomVolume> fuse_views(std::span<const ViewSurface> views, const ModelOptions& options,
                              const Workers& workers,
                              const std::function<void(std::size_t, std::size_t)>& progress) {
  if (auto status = options.check(); !status) return status.error();
  std::vector<std::uint64_t> codes;
  for (const ViewSurface& view : views) {
    add_blocks(view, options.voxel_m, codes);
    if (sizeof(codes[0]) * codes.size() > kMaxCandidateBytes) return too_large(options);
  }
  RoomVolume volume{options.voxel_m, {}};
  constexpr std::size_t kAtATime = 256;  // blocks
  const std::size_t rows = (codes.size() + kAtATime - 1) / kAtATime;
  std::mutex mutex;
  std::atomic<bool> full = false;
  std::size_t done = 0;
  for_each_row(static_cast<int>(rows), workers, [&](int row) {
    if (full) return;
    const std::size_t begin = static_cast<std::size_t>(row) * kAtATime;
    const std::size_t end = std::min(begin + kAtATime, codes.size());
    std::vector<VolumeBlock> blocks;
    for (std::size_t i = begin; i < end; ++i)
      if (const auto block = fuse_block(place_of(codes[i]), views, options))
        blocks.push_back(*block);
    const std::lock_guard lock(mutex);
    volume.blocks.insert(volume.blocks.end(), blocks.begin(), blocks.end());
    full = full || volume.bytes() > options.max_bytes;
    done += end - begin;
    if (progress) progress(done, codes.size());
  });
  if (full) return too_large(options);
  if (workers.stop.stop_requested()) return Error{ErrorCode::kClosed, "interrupted"};
  std::ranges::sort(volume.blocks, {}, &VolumeBlock::place);
  return volume;
}

}  // namespace roomcast::model
