// SPDX-License-Identifier: Apache-2.0
// Exports frame sets as a rig folder (dataset/rig_json.h) of picture files, colour in the depth
// grid; JPEG files that have it so already are copied. Timestamps are UTC, seconds since 1970,
// where the recording tells its date; else they count from its begin. On request each sensor's
// folder also gets groundtruth.txt (TUM RGB-D benchmark: t tx ty tz qx qy qz qw, world from
// camera). Single-threaded.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "roomcast/recording/dataset/rig_writer.h"
#include "roomcast/recording/export/set_writer.h"

namespace roomcast::recording {

class FolderWriter final : public SetWriter {
 public:
  FolderWriter(std::filesystem::path folder, ExportedRoom room, bool groundtruth)
      : folder_(std::move(folder)),
        sensors_(std::move(room.sensors)),
        began_at_(room.began_at),
        last_(sensors_.size()),
        groundtruth_(groundtruth) {}

  /// The first call creates the folder's files with the sensors' poses in that set.
  Status add(const FrameSet& set) override;
  Status finish() override;
  ExportTotals totals() const override { return totals_; }

 private:
  struct Last {
    std::shared_ptr<const codec::DecodedFrame> pictures;
    std::uint64_t next_index = 0;
  };
  Status create(const FrameSet& set);
  Status add_frame(const SetFrame& frame);
  Status write_pictures(const SetFrame& frame);
  Status add_pose(const SetFrame& frame) const;

  const std::filesystem::path folder_;
  const std::vector<SetSensor> sensors_;
  const nanoseconds began_at_;
  std::vector<Last> last_;
  const bool groundtruth_;
  double fps_ = 0;
  std::optional<RigWriter> writer_;
  source::CapturedFrame captured_;  // reused
  std::vector<std::uint8_t> jpeg_;  // reused
  ExportTotals totals_;
};

}  // namespace roomcast::recording
