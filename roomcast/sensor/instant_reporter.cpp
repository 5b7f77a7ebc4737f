// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/instant_reporter.h"

#include <utility>

#include "roomcast/alignment/bundle/depth_instants.h"
#include "roomcast/alignment/service/instant_schedule.h"
#include "roomcast/alignment/service/instant_store.h"

namespace roomcast::sensor {
namespace {

constexpr long long kMomentsPerStillOne = 8;  // while nothing moves, one moment in eight

}  // namespace

void InstantReporter::stand(const DepthImage& steady_mm) {
  steady_mm_ = steady_mm.empty() ? DepthImage() : alignment::depth_in_blocks(steady_mm);
}

std::optional<wire::pb::DepthInstant> InstantReporter::add(const DepthImage& depth_mm,
                                                           RoomTime taken) {
  const double time_s = std::chrono::duration<double>(taken.time_since_epoch()).count();
  const long long moment = alignment::moment_of(time_s);
  if (steady_mm_.empty() || std::exchange(moment_, moment) == moment) return std::nullopt;
  alignment::DepthInstant instant{time_s, alignment::depth_in_blocks(depth_mm), {}};
  const DepthImage& blocks = instant.depth_mm;
  if (blocks.width() != steady_mm_.width() || blocks.height() != steady_mm_.height())
    return std::nullopt;
  const bool moves = alignment::shows_motion(alignment::in_front_of(blocks, steady_mm_));
  if (!moves && moment % kMomentsPerStillOne != 0) return std::nullopt;
  auto message = alignment::message_from_instant(instant);
  if (!message) return std::nullopt;  // its picture is too small
  return *std::move(message);
}

}  // namespace roomcast::sensor
