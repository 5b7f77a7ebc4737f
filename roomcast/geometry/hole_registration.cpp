// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/hole_registration.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace roomcast {
namespace {

constexpr int kReadingsOfFarther = 3;
constexpr int kKeep = 7,
              kOf = 8;                       // known depth's share: kKeep / kOf
constexpr int kClearChange = 12;             // levels of a colour channel
constexpr int kReach = 2, kMinInPatch = 13;  // of the 25 pixels of the 5x5 patch
constexpr int kCell = 5;                     // pixels
constexpr int kCorners = 3;                  // of 4

/// Readings of one surface differ by less than this: a bound on depth noise, mm.
int same_surface_mm(int depth_mm) {
  const auto depth = static_cast<unsigned>(depth_mm);  // its square fits: up to 65535
  return 8 + static_cast<int>(depth * depth / (1U << 19U));
}

/// Largest depth that counts as clearly in front of a surface at `depth_mm`.
int before_mm(int depth_mm) {
  return depth_mm - 100 - depth_mm / 32;
}

}  // namespace

SparseCover::SparseCover(int width, int height) : cells_(width / kCell + 1, height / kCell + 1) {}

void SparseCover::find(DepthView depth_mm, DepthView behind_mm) {
  std::fill_n(cells_.data(), cells_.view().pixel_count(), Cell{});
  for (int y = 0; y < depth_mm.height; ++y) {
    Cell* const cells = cells_.view().row(y / kCell);
    for (int x = 0; x < depth_mm.width; ++x) {
      const int read = depth_mm.at(x, y);
      if (read == 0 || read > before_mm(behind_mm.at(x, y))) continue;
      cells[x / kCell].sum_mm += read;
      ++cells[x / kCell].readings;
    }
  }
}

int SparseCover::between_mm(int x, int y) const {
  int corners = 0, sum = 0, nearest = 65536, farthest = 0;
  for (const auto& [across, down] : {std::pair{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}) {
    const int i = x / kCell + across, j = y / kCell + down;
    if (i < 0 || j < 0 || i >= cells_.width() || j >= cells_.height()) continue;
    const Cell& cell = cells_.at(i, j);
    if (cell.readings == 0) continue;
    const int mean = cell.sum_mm / cell.readings;
    nearest = std::min(nearest, mean);
    farthest = std::max(farthest, mean);
    sum += mean;
    ++corners;
  }
  const bool agree = corners >= kCorners && nearest > before_mm(farthest);
  return agree ? sum / corners : 0;
}

FarthestDepth::FarthestDepth(int width, int height)
    : known_mm_(width, height), candidate_mm_(width, height), candidate_readings_(width, height) {}

void FarthestDepth::learn(DepthView depth_mm) {
  for (int y = 0; y < depth_mm.height; ++y) {
    for (int x = 0; x < depth_mm.width; ++x) {
      const int read = depth_mm.at(x, y);
      if (read == 0) continue;
      std::uint16_t &known = known_mm_.at(x, y), &candidate = candidate_mm_.at(x, y);
      std::uint8_t& readings = candidate_readings_.at(x, y);
      const int gate = same_surface_mm(read);
      if (known != 0 && std::abs(read - known) < gate) {
        known = static_cast<std::uint16_t>((kKeep * known + read + kOf / 2) / kOf);
        readings = 0;
      } else if (read > known) {
        const bool agrees = readings > 0 && std::abs(read - candidate) < gate;
        readings = static_cast<std::uint8_t>(agrees ? readings + 1 : 1);
        candidate = static_cast<std::uint16_t>(read);
        if (readings < kReadingsOfFarther) continue;
        known = candidate;
        readings = 0;
      }
    }
  }
}

Result<HoleRegistration> HoleRegistration::create(const SensorCalibration& calibration,
                                                  const RegistrationOptions& options) {
  auto registration = Registration::create(calibration, options);
  if (!registration) return registration.error();
  return HoleRegistration(*std::move(registration), calibration, options.color_scale);
}

HoleRegistration::HoleRegistration(Registration registration, const SensorCalibration& calibration,
                                   int color_scale)
    : registration_(std::move(registration)),
      color_scale_(color_scale),
      farthest_(calibration.depth.width, calibration.depth.height),
      cover_(calibration.depth.width, calibration.depth.height),
      filled_mm_(calibration.depth.width, calibration.depth.height),
      changed_(calibration.depth.width, calibration.depth.height),
      fresh_(calibration.depth.width, calibration.depth.height),
      last_(color_scale * calibration.depth.width, color_scale * calibration.depth.height) {}

Status HoleRegistration::run(DepthView depth_mm, ColorView color, RegisteredColor& out) {
  if (auto status = registration_.run(depth_mm, color, out); !status) return status;
  farthest_.learn(depth_mm);
  cover_.find(depth_mm, farthest_.depth_mm());
  fill(depth_mm);
  auto status = registration_.run_in_holes(depth_mm, filled_mm_, color, in_holes_);
  if (!status) return status;
  find_changes();
  keep_colors(depth_mm, out);
  return {};
}

void HoleRegistration::fill(DepthView depth_mm) {
  for (int y = 0; y < depth_mm.height; ++y) {
    const std::uint16_t *read = depth_mm.row(y), *behind = farthest_.depth_mm().row(y);
    std::uint16_t* filled = filled_mm_.view().row(y);
    for (int x = 0; x < depth_mm.width; ++x) {
      filled[x] = read[x] != 0 ? read[x] : behind[x];
      if (read[x] != 0 || behind[x] == 0) continue;
      const int between = cover_.between_mm(x, y);
      if (between > 0) filled[x] = static_cast<std::uint16_t>(between);
    }
  }
}

void HoleRegistration::find_changes() {
  for (int y = 0; y < changed_.height(); ++y) {
    for (int x = 0; x < changed_.width(); ++x) {
      changed_.at(x, y) = in_holes_.seen.at(x, y) != 0 && is_changed(x, y) ? 255 : 0;
    }
  }
}

/// Compares the mean colour over the depth pixel.
bool HoleRegistration::is_changed(int x, int y) const {
  int r = 0, g = 0, b = 0;
  for (int j = color_scale_ * y; j < color_scale_ * (y + 1); ++j) {
    for (int i = color_scale_ * x; i < color_scale_ * (x + 1); ++i) {
      const Rgb8 is = in_holes_.color.at(i, j), was = last_.at(i, j);
      r += is.r - was.r;
      g += is.g - was.g;
      b += is.b - was.b;
    }
  }
  const int most = std::max({std::abs(r), std::abs(g), std::abs(b)});
  return most > kClearChange * color_scale_ * color_scale_;
}

bool HoleRegistration::is_in_patch(int x, int y) const {
  int count = 0;
  const int bottom = std::min(y + kReach, changed_.height() - 1);
  const int right = std::min(x + kReach, changed_.width() - 1);
  for (int j = std::max(y - kReach, 0); j <= bottom; ++j) {
    for (int i = std::max(x - kReach, 0); i <= right; ++i) count += changed_.at(i, j) != 0 ? 1 : 0;
  }
  return count >= kMinInPatch;
}

void HoleRegistration::keep_colors(DepthView depth_mm, RegisteredColor& out) {
  for (int y = 0; y < depth_mm.height; ++y) {
    for (int x = 0; x < depth_mm.width; ++x) {
      const bool is_hole = depth_mm.at(x, y) == 0;
      const bool is_new = is_hole && changed_.at(x, y) != 0 && is_in_patch(x, y);
      const bool is_seen = out.seen.at(x, y) != 0;
      fresh_.at(x, y) = is_new || is_seen ? 255 : 0;
      if (is_hole || is_seen)
        keep_color(x, y, is_new ? in_holes_.color : out.color, is_new || is_seen, out.color);
    }
  }
}

/// Stores the pixel's colour if it is new, and outputs the stored colour.
void HoleRegistration::keep_color(int x, int y, const ColorImage& now, bool is_new,
                                  ColorImage& out) {
  for (int j = color_scale_ * y; j < color_scale_ * (y + 1); ++j) {
    for (int i = color_scale_ * x; i < color_scale_ * (x + 1); ++i) {
      if (is_new) last_.at(i, j) = now.at(i, j);
      out.at(i, j) = last_.at(i, j);
    }
  }
}

}  // namespace roomcast
