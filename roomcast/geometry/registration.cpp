// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/registration.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace roomcast {
namespace {

// A look-up in the occlusion grid covers surfaces up to two cells away. On a slanted surface those
// are nearer by up to two steps between neighbouring depth pixels along each axis; they must not
// hide their own neighbours.
constexpr int kReach = 2;
constexpr int kSteepest = 8;  // this allowance is at most 1/8 of the depth
constexpr int kLargestCell = 64;

std::string size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

Error invalid(std::string message) {
  return {ErrorCode::kInvalidArgument, std::move(message)};
}

Status check_options(const RegistrationOptions& options) {
  for (const double margin : {options.occlusion_margin_m, options.occlusion_margin_per_m}) {
    if (!std::isfinite(margin) || margin < 0) {
      return invalid("occlusion margins must be finite and not negative");
    }
  }
  if (options.color_scale != 1 && options.color_scale != 2) {
    return invalid("colour must have the resolution of depth or twice that");
  }
  return {};
}

Status check_calibration(const SensorCalibration& calibration) {
  for (const CameraIntrinsics* camera : {&calibration.depth, &calibration.color}) {
    if (Status status = camera->check(); !status.ok()) return status;
    if (camera->width < 2 || camera->height < 2) {
      return invalid("registration needs pictures of at least 2x2 pixels");
    }
  }
  if (calibration.color_is_registered && !same_size(calibration.color, calibration.depth)) {
    return invalid("registered colour must have the size of depth");
  }
  return {};
}

/// The smallest cell that leaves no gaps: a look-up covers three cells, so where the lens spreads
/// the depth pixels most, they may be two cells apart.
int cell_size(const ColorProjection::Spacing& spacing) {
  const float size = std::max(spacing.typical, spacing.largest / 2);
  return std::clamp(static_cast<int>(std::ceil(size)), 1, kLargestCell);
}

int box_size(const ColorProjection::Spacing& spacing, int color_scale) {
  const float scale = static_cast<float>(color_scale);
  return std::max(1, static_cast<int>(std::lround(spacing.typical / scale)));
}

void copy_where_depth(DepthView depth_mm, ColorView color, RegisteredColor& out) {
  for (int y = 0; y < depth_mm.height; ++y) {
    for (int x = 0; x < depth_mm.width; ++x) {
      const bool seen = depth_mm.at(x, y) != 0;
      out.color.at(x, y) = seen ? color.at(x, y) : Rgb8{};
      out.seen.at(x, y) = seen ? 255 : 0;
    }
  }
}

void copy_holes(DepthView depth_mm, DepthView filled_mm, ColorView color, RegisteredColor& out) {
  for (int y = 0; y < depth_mm.height; ++y) {
    for (int x = 0; x < depth_mm.width; ++x) {
      const bool seen = depth_mm.at(x, y) == 0 && filled_mm.at(x, y) != 0;
      out.color.at(x, y) = seen ? color.at(x, y) : Rgb8{};
      out.seen.at(x, y) = seen ? 255 : 0;
    }
  }
}

/// Shortest gap in a row that could be an object; single readings are missing everywhere.
constexpr int kSmallestGap = 5;

/// Whether the row has a gap in its readings of at least that length that is filled.
bool has_gap(DepthView depth_mm, DepthView filled_mm, int y) {
  const std::uint16_t *read = depth_mm.row(y), *filled = filled_mm.row(y);
  int length = 0;
  for (int x = 0; x < depth_mm.width && length < kSmallestGap; ++x) {
    length = read[x] == 0 && filled[x] != 0 ? length + 1 : 0;
  }
  return length == kSmallestGap;
}

/// The smaller of two consecutive depth steps along an axis; 0 at a peak or in a pit, where there
/// is no slope.
int slope(int step_before, int step_after) {
  const bool same_direction = (step_before ^ step_after) >= 0;
  return same_direction ? std::min(std::abs(step_before), std::abs(step_after)) : 0;
}

}  // namespace

Result<Registration> Registration::create(const SensorCalibration& calibration,
                                          const RegistrationOptions& options) {
  if (Status status = check_options(options); !status.ok()) return status.error();
  if (Status status = check_calibration(calibration); !status.ok()) return status.error();
  if (calibration.color_is_registered && options.color_scale != 1) {
    return invalid("registered colour must have the resolution of depth");
  }
  return Registration(calibration, options);
}

Registration::Registration(const SensorCalibration& calibration, const RegistrationOptions& options)
    : depth_width_(calibration.depth.width),
      depth_height_(calibration.depth.height),
      color_width_(calibration.color.width),
      color_height_(calibration.color.height),
      copy_only_(calibration.color_is_registered),
      options_(options),
      projection_(calibration),
      spacing_(projection_.spacing()),
      grid_(color_width_, color_height_, cell_size(spacing_)),
      sample_row_(
          box_sampler(box_size(spacing_, options.color_scale), color_width_, color_height_)) {
  const auto count =
      static_cast<std::size_t>(depth_width_) * static_cast<std::size_t>(depth_height_);
  for (auto* buffer : {&u_, &v_, &z_m_, &occluder_limit_m_}) buffer->resize(count);
  cells_.resize(count);
}

Status Registration::check_sizes(DepthView depth_mm, ColorView color) const {
  if (depth_mm.width != depth_width_ || depth_mm.height != depth_height_) {
    return invalid("depth is " + size_text(depth_mm.width, depth_mm.height) +
                   " but the calibration is for " + size_text(depth_width_, depth_height_));
  }
  if (color.width != color_width_ || color.height != color_height_) {
    return invalid("colour is " + size_text(color.width, color.height) +
                   " but the calibration is for " + size_text(color_width_, color_height_));
  }
  return {};
}

Status Registration::run(DepthView depth_mm, ColorView color, RegisteredColor& out) {
  if (Status status = check_sizes(depth_mm, color); !status.ok()) return status;
  make_room(out);
  if (copy_only_) {
    copy_where_depth(depth_mm, color, out);
    return {};
  }
  project_surfaces(depth_mm);
  for (int y = 0; y < depth_height_; ++y) {
    find_visible(y, &out.seen.at(0, y));
    sample(color, y, out);
  }
  return {};
}

Status Registration::run_in_holes(DepthView depth_mm, DepthView filled_mm, ColorView color,
                                  RegisteredColor& out) {
  if (Status status = check_sizes(depth_mm, color); !status.ok()) return status;
  if (Status status = check_sizes(filled_mm, color); !status.ok()) return status;
  make_room(out);
  if (copy_only_) {
    copy_holes(depth_mm, filled_mm, color, out);
    return {};
  }
  for (int y = 0; y < depth_height_; ++y) {
    if (has_gap(depth_mm, filled_mm, y)) project_filled(filled_mm, y);
  }
  for (int y = 0; y < depth_height_; ++y) {
    std::fill_n(&out.seen.at(0, y), depth_width_, std::uint8_t{0});
    if (!has_gap(depth_mm, filled_mm, y)) continue;
    find_visible_holes(depth_mm, y, &out.seen.at(0, y));
    sample(color, y, out);
  }
  return {};
}

void Registration::make_room(RegisteredColor& out) const {
  const int color_width = options_.color_scale * depth_width_;
  const int color_height = options_.color_scale * depth_height_;
  if (out.color.width() != color_width || out.color.height() != color_height) {
    out.color.resize(color_width, color_height);
  }
  if (out.seen.width() != depth_width_ || out.seen.height() != depth_height_) {
    out.seen.resize(depth_width_, depth_height_);
  }
}

void Registration::sample(ColorView color, int y, RegisteredColor& out) {
  options_.color_scale == 1 ? sample_row(color, y, out) : sample_quarters(color, y, out);
}

void Registration::project_surfaces(DepthView depth_mm) {
  grid_.clear();
  for (int y = 0; y < depth_height_; ++y) {
    const std::size_t start = static_cast<std::size_t>(y) * static_cast<std::size_t>(depth_width_);
    const ProjectedRow row{&u_[start], &v_[start], &z_m_[start]};
    projection_.project_row(depth_mm.row(y), y, row);
    grid_.splat_row(row.u, row.v, row.z_m, depth_width_, &cells_[start]);
    limit_occluders(depth_mm, y);
  }
  grid_.finish();
}

/// Filled pixels are not entered into the grid, so they occlude nothing: they are not readings.
void Registration::project_filled(DepthView filled_mm, int y) {
  const std::size_t start = static_cast<std::size_t>(y) * static_cast<std::size_t>(depth_width_);
  const ProjectedRow row{&u_[start], &v_[start], &z_m_[start]};
  projection_.project_row(filled_mm.row(y), y, row);
  grid_.find_cells(row.u, row.v, row.z_m, depth_width_, &cells_[start]);
}

void Registration::limit_occluders(DepthView depth_mm, int y) {
  const std::size_t start = static_cast<std::size_t>(y) * static_cast<std::size_t>(depth_width_);
  const std::uint16_t* const here = depth_mm.row(y);
  // Rows between which the steps are taken; at the border the only step is used twice.
  const int before = std::max(y - 1, 0), after = std::min(y + 1, depth_height_ - 1);
  const std::uint16_t* const above = depth_mm.row(before);
  const std::uint16_t* const above_to = depth_mm.row(before + 1);
  const std::uint16_t* const below = depth_mm.row(after);
  const std::uint16_t* const below_from = depth_mm.row(after - 1);
  const float* const z_m = &z_m_[start];
  float* const __restrict limit_m = &occluder_limit_m_[start];
  const float margin_m = static_cast<float>(options_.occlusion_margin_m);
  const float keep = 1 - static_cast<float>(options_.occlusion_margin_per_m);
  const auto limit_at = [&](int x, int left, int right) {
    const int across = slope(here[left + 1] - here[left], here[right] - here[right - 1]);
    const int down = slope(above_to[x] - above[x], below[x] - below_from[x]);
    const int allowance_mm = std::min(kReach * (across + down), here[x] / kSteepest);
    limit_m[x] = z_m[x] * keep - margin_m - 0.001F * static_cast<float>(allowance_mm);
  };
  limit_at(0, 0, 1);
  for (int x = 1; x < depth_width_ - 1; ++x) limit_at(x, x - 1, x + 1);
  limit_at(depth_width_ - 1, depth_width_ - 2, depth_width_ - 1);
}

void Registration::find_visible(int y, std::uint8_t* seen) const {
  const std::size_t start = static_cast<std::size_t>(y) * static_cast<std::size_t>(depth_width_);
  for (int x = 0; x < depth_width_; ++x) {
    const std::size_t i = start + static_cast<std::size_t>(x);
    seen[x] = grid_.nearest_m(cells_[i]) < occluder_limit_m_[i] ? 0 : 255;
  }
}

void Registration::find_visible_holes(DepthView depth_mm, int y, std::uint8_t* seen) const {
  const std::size_t start = static_cast<std::size_t>(y) * static_cast<std::size_t>(depth_width_);
  const float margin_m = static_cast<float>(options_.occlusion_margin_m);
  const float keep = 1 - static_cast<float>(options_.occlusion_margin_per_m);
  for (int x = 0; x < depth_width_; ++x) {
    const std::size_t i = start + static_cast<std::size_t>(x);
    const bool is_hole = depth_mm.at(x, y) == 0 && z_m_[i] > 0;
    const bool is_hidden = grid_.nearest_m(cells_[i]) < z_m_[i] * keep - margin_m;
    seen[x] = is_hole && !is_hidden ? 255 : 0;
  }
}

void Registration::sample_row(ColorView color, int y, RegisteredColor& out) const {
  const std::size_t start = static_cast<std::size_t>(y) * static_cast<std::size_t>(depth_width_);
  sample_row_(color, &u_[start], &v_[start], &out.seen.at(0, y), depth_width_, &out.color.at(0, y));
}

void Registration::sample_quarters(ColorView color, int y, RegisteredColor& out) {
  const ProjectedSurface surface{depth_width_,
                                 depth_height_,
                                 u_.data(),
                                 v_.data(),
                                 z_m_.data(),
                                 spacing_.typical,
                                 static_cast<float>(color_width_ - 1),
                                 static_cast<float>(color_height_ - 1)};
  find_quarters(surface, y, upper_, lower_);
  seen_quarters_.resize(2 * static_cast<std::size_t>(depth_width_));
  const std::uint8_t* const seen = &out.seen.at(0, y);
  for (std::size_t i = 0; i < seen_quarters_.size(); ++i) seen_quarters_[i] = seen[i / 2];
  for (const QuarterRow* row : {&upper_, &lower_}) {
    const int below = row == &lower_ ? 1 : 0;
    sample_row_(color, row->u.data(), row->v.data(), seen_quarters_.data(), 2 * depth_width_,
                &out.color.at(0, 2 * y + below));
  }
}

}  // namespace roomcast
