// SPDX-License-Identifier: Apache-2.0
#include "bench/redundancy/redundancy_bench.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/latency/frame_loop.h"
#include "bench/render/rig_frames.h"
#include "roomcast/codec/frame_codec.h"

namespace roomcast::bench {
namespace {

constexpr std::size_t kMaxFrames = 64;  // of each sensor, kept in memory
constexpr int kSide = 8;                // of a block, in pixels of depth
constexpr double kMinBlockShare = 0.9;  // share of a block's pixels that others must show better
constexpr int kSteadyFrames = 3;        // for which they must have done so
constexpr double kMoved = 0.04;         // relative change of depth from frame to frame

enum class Sent { kWhole, kFrozen, kLeftOut };

struct Frames {
  std::vector<RegisteredFrame> own;
  std::vector<MaskImage> left_to_others;  // blocks
};

template <class Visit>
void for_each_pixel_of(int block_x, int block_y, int width, int height, Visit visit) {
  for (int y = block_y; y < std::min(height, block_y + kSide); ++y)
    for (int x = block_x; x < std::min(width, block_x + kSide); ++x) visit(x, y);
}

bool is_better_elsewhere(const MaskImage& better, DepthView depth_mm, int block_x, int block_y) {
  int with_depth = 0, elsewhere = 0;
  for_each_pixel_of(block_x, block_y, depth_mm.width, depth_mm.height, [&](int x, int y) {
    with_depth += depth_mm.at(x, y) != 0;
    elsewhere += better.at(x, y) != 0;
  });
  return with_depth > 0 && elsewhere >= kMinBlockShare * with_depth;
}

/// A block is left to the others after kSteadyFrames, and taken back at once.
MaskImage blocks_left(const MaskImage& better, DepthView depth_mm, Image<std::uint8_t>& steady) {
  MaskImage left(depth_mm.width, depth_mm.height, 0);
  for (int y = 0; y < depth_mm.height; y += kSide) {
    for (int x = 0; x < depth_mm.width; x += kSide) {
      std::uint8_t& frames = steady.at(x / kSide, y / kSide);
      const bool is_better = is_better_elsewhere(better, depth_mm, x, y);
      frames = is_better ? static_cast<std::uint8_t>(std::min(kSteadyFrames, frames + 1)) : 0;
      if (frames < kSteadyFrames) continue;
      for_each_pixel_of(x, y, depth_mm.width, depth_mm.height,
                        [&](int px, int py) { left.at(px, py) = 255; });
    }
  }
  return left;
}

/// Changes what is sent of a frame. `shown_mm`: what decoders show after the frame before; empty at
/// first.
void leave_to_others(Sent sent, const MaskImage& left, DepthView shown_mm,
                     const RegisteredFrame* before, RegisteredFrame& frame) {
  for (int y = 0; y < frame.depth_mm.height(); ++y) {
    for (int x = 0; x < frame.depth_mm.width(); ++x) {
      if (left.at(x, y) == 0) continue;
      if (sent == Sent::kLeftOut) {
        frame.depth_mm.at(x, y) = 0;
        frame.color.seen.at(x, y) = 0;
        frame.color.color.at(x, y) = {};
      } else if (before != nullptr) {
        frame.depth_mm.at(x, y) = shown_mm.at(x, y);
        frame.color.seen.at(x, y) = before->color.seen.at(x, y);
        frame.color.color.at(x, y) = before->color.color.at(x, y);
      }
    }
  }
}

Result<double> encoded_bytes(const Frames& frames, Sent sent, double fps, std::size_t count,
                             double key_interval_s) {
  codec::FrameEncoderOptions options;
  options.width = frames.own[0].depth_mm.width();
  options.height = frames.own[0].depth_mm.height();
  options.fps = fps;
  options.key_interval_s = key_interval_s;
  auto encoder = codec::FrameEncoder::create(options);
  if (!encoder) return encoder.error();
  std::vector<std::uint8_t> payload;
  double bytes = 0;
  RegisteredFrame before;
  for (std::size_t i = 0; i < count; ++i) {
    const auto place = static_cast<std::size_t>(
        frame_at_place(static_cast<std::int64_t>(i), static_cast<std::int64_t>(frames.own.size())));
    RegisteredFrame frame = frames.own[place];
    if (sent != Sent::kWhole)
      leave_to_others(sent, frames.left_to_others[place], (*encoder)->decoded_depth(),
                      i > 0 ? &before : nullptr, frame);
    payload.clear();
    const auto info =
        (*encoder)->encode(frame.depth_mm, frame.color.color, frame.color.seen, false, payload);
    if (!info) return info.error();
    bytes += static_cast<double>(payload.size());
    before = std::move(frame);
  }
  return bytes;
}

struct Shares {
  double pixels = 0, better = 0, moving = 0, better_moving = 0;

  void add(DepthView depth_mm, const DepthImage* before_mm, const MaskImage& better_mask) {
    for (int y = 0; y < depth_mm.height; ++y) {
      for (int x = 0; x < depth_mm.width; ++x) {
        const int mm = depth_mm.at(x, y);
        if (mm == 0) continue;
        const bool is_better = better_mask.at(x, y) != 0;
        ++pixels;
        better += is_better;
        const int was = before_mm == nullptr ? 0 : before_mm->at(x, y);
        if (was == 0 || std::abs(mm - was) <= kMoved * mm) continue;
        ++moving;
        better_moving += is_better;
      }
    }
  }
};

Result<std::vector<Frames>> read_frames(RigFrames& rig, std::size_t count,
                                        const std::function<void(const std::string&)>& progress) {
  std::vector<Frames> all;
  for (auto& sensor : rig.sensors()) {
    if (progress) progress(fmt::format("reading sensor {}", all.size() + 1));
    Frames& frames = all.emplace_back();
    for (std::size_t i = 0; i < count; ++i) {
      const auto status =
          rig.read(sensor, sensor.recording.frames[i].index, frames.own.emplace_back());
      if (!status) return status.error();
    }
  }
  return all;
}

/// Finds what is left to others in each frame of sensor `which`.
Shares compare(const std::vector<RigFrames::Sensor>& sensors, std::size_t which,
               const BetterShownOptions& options, std::vector<Frames>& all) {
  Frames& frames = all[which];
  Shares shares;
  Image<std::uint8_t> steady(frames.own[0].depth_mm.width() / kSide + 1,
                             frames.own[0].depth_mm.height() / kSide + 1, 0);
  for (std::size_t i = 0; i < frames.own.size(); ++i) {
    std::vector<SensorDepth> at_instant;
    for (std::size_t s = 0; s < all.size(); ++s) {
      const RigFrames::Sensor& sensor = sensors[s];
      at_instant.push_back({&sensor.recording.camera.calibration.depth, sensor.world_from_depth,
                            all[s].own[i].depth_mm.view()});
    }
    const MaskImage better = better_shown(at_instant, which, options);
    const DepthView depth_mm = frames.own[i].depth_mm.view();
    shares.add(depth_mm, i > 0 ? &frames.own[i - 1].depth_mm : nullptr, better);
    frames.left_to_others.push_back(blocks_left(better, depth_mm, steady));
  }
  return shares;
}

}  // namespace

Result<RedundancyReport> run_redundancy_bench(
    const std::filesystem::path& folder, const recording::RigDescription& rig,
    const RedundancyOptions& options, const std::function<void(const std::string&)>& progress) {
  if (rig.sensors.size() < 2) return invalid_argument("redundancy needs a rig of two sensors");
  auto opened = RigFrames::open(folder, rig, 1);
  if (!opened) return opened.error();
  const auto& sensors = opened->sensors();
  std::size_t count = kMaxFrames;
  for (const auto& sensor : sensors) count = std::min(count, sensor.recording.frames.size());
  auto frames = read_frames(*opened, count, progress);
  if (!frames) return frames.error();

  RedundancyReport report;
  report.rig = folder.filename().string();
  report.fps = sensors[0].recording.description.fps;
  report.frames = options.frames > 0 ? options.frames : count;
  for (std::size_t s = 0; s < sensors.size(); ++s) {
    SensorRedundancy& sensor = report.sensors.emplace_back();
    sensor.name = rig.sensors[s].id;
    if (progress) progress("comparing " + sensor.name);
    const Shares shares = compare(sensors, s, options.better, *frames);
    sensor.better_share = shares.better / std::max(1.0, shares.pixels);
    sensor.better_moving_share = shares.better_moving / std::max(1.0, shares.moving);
    if (progress) progress("encoding " + sensor.name);
    for (const auto& [sent, into] :
         {std::pair{Sent::kWhole, &sensor.bytes}, std::pair{Sent::kFrozen, &sensor.frozen_bytes},
          std::pair{Sent::kLeftOut, &sensor.left_out_bytes}}) {
      const auto bytes =
          encoded_bytes((*frames)[s], sent, report.fps, report.frames, options.key_interval_s);
      if (!bytes) return bytes.error();
      *into = *bytes;
    }
  }
  return report;
}

void print_table(const RedundancyReport& report, std::ostream& out) {
  out << fmt::format("{}, {} frames of each sensor, {:g}/s\n", report.rig, report.frames,
                     report.fps);
  out << fmt::format("{:<10}{:>16}{:>20}{:>14}{:>12}{:>12}\n", "sensor", "better shown, %",
                     "of what moves, %", "bytes/frame", "frozen, %", "left out, %");
  SensorRedundancy all{.name = "all"};
  const auto print = [&](const SensorRedundancy& sensor) {
    out << fmt::format("{:<10}{:>16.1f}{:>20.1f}{:>14.0f}{:>12.1f}{:>12.1f}\n", sensor.name,
                       100 * sensor.better_share, 100 * sensor.better_moving_share,
                       sensor.bytes / static_cast<double>(report.frames),
                       100 * (sensor.frozen_bytes / sensor.bytes - 1),
                       100 * (sensor.left_out_bytes / sensor.bytes - 1));
  };
  const auto count = static_cast<double>(report.sensors.size());
  for (const SensorRedundancy& sensor : report.sensors) {
    print(sensor);
    all.better_share += sensor.better_share / count;
    all.better_moving_share += sensor.better_moving_share / count;
    all.bytes += sensor.bytes;
    all.frozen_bytes += sensor.frozen_bytes;
    all.left_out_bytes += sensor.left_out_bytes;
  }
  print(all);
}

void print_json(const std::vector<RedundancyReport>& reports, std::ostream& out) {
  auto json = nlohmann::ordered_json::array();
  for (const RedundancyReport& report : reports) {
    auto sensors = nlohmann::ordered_json::array();
    for (const SensorRedundancy& sensor : report.sensors)
      sensors.push_back({{"sensor", sensor.name},
                         {"better_shown", sensor.better_share},
                         {"better_shown_of_what_moves", sensor.better_moving_share},
                         {"bytes", sensor.bytes},
                         {"bytes_frozen", sensor.frozen_bytes},
                         {"bytes_left_out", sensor.left_out_bytes}});
    json.push_back({{"rig", report.rig},
                    {"frames", report.frames},
                    {"fps", report.fps},
                    {"sensors", std::move(sensors)}});
  }
  out << json.dump(2) << "\n";
}

}  // namespace roomcast::bench
