// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/export/folder_writer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <Eigen/Geometry>

#include "roomcast/io/file_bytes.h"
#include "roomcast/io/image_file.h"
#include "roomcast/recording/dataset/tum_list.h"

namespace roomcast::recording {

Status FolderWriter::create(const FrameSet& set) {
  std::vector<RigSensor> rig(sensors_.size());
  RigWriterOptions options{.source = "roomcast export"};
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    source::SensorDescription& description = rig[i].description;
    description.name = sensors_[i].name;
    description.calibration = {sensors_[i].depth, sensors_[i].depth, {}, true};
    rig[i].expected_error_mm = 1000 * sensors_[i].expected_error_m;
    options.scale_error = std::max(options.scale_error, sensors_[i].scale_error);
    fps_ = std::max(fps_, sensors_[i].fps);
  }
  for (const SetFrame& frame : set.frames)
    rig[frame.sensor].description.world_from_depth = frame.world_from_depth;
  auto writer = RigWriter::create(folder_, fps_, rig, options);
  if (!writer) return writer.error();
  writer_.emplace(std::move(*writer));
  return {};
}

Status FolderWriter::add(const FrameSet& set) {
  if (!writer_) {
    if (auto status = create(set); !status) return status;
  }
  ++totals_.sets;
  for (const SetFrame& frame : set.frames) {
    if (last_[frame.sensor].pictures == frame.pictures) continue;  // repeated frame
    last_[frame.sensor].pictures = frame.pictures;
    if (auto status = add_frame(frame); !status) return status;
  }
  return {};
}

Status FolderWriter::add_frame(const SetFrame& frame) {
  Last& last = last_[frame.sensor];
  const double seconds = std::max(0.0, std::chrono::duration<double>(frame.time).count());
  captured_.index =
      std::max(last.next_index, static_cast<std::uint64_t>(std::llround(seconds * fps_)));
  last.next_index = captured_.index + 1;
  captured_.depth_mm = frame.pictures->depth_mm;
  captured_.color = frame.pictures->color;
  if (auto status = write_pictures(frame); !status) return status;
  return groundtruth_ && frame.world_from_depth ? add_pose(frame) : Status();
}

/// Colour that is a JPEG file in the depth grid already stays byte for byte as it is.
Status FolderWriter::write_pictures(const SetFrame& frame) {
  const nanoseconds timestamp = began_at_ + frame.time;
  const bool is_jpeg = !captured_.color.empty() && !frame.color_file.empty() &&
                       io::read_file(frame.color_file, io::kMaxImageFileBytes, jpeg_).ok() &&
                       jpeg_.size() > 2 && jpeg_[0] == 0xFF && jpeg_[1] == 0xD8;
  if (!is_jpeg) return writer_->add(frame.sensor, captured_, timestamp);
  if (auto status = writer_->write_pictures(frame.sensor, captured_, jpeg_); !status) return status;
  return writer_->list(frame.sensor, captured_.index, true, timestamp);
}

Status FolderWriter::add_pose(const SetFrame& frame) const {
  const Eigen::Quaterniond turn(frame.world_from_depth->rotation);
  const Eigen::Vector3d& place = frame.world_from_depth->translation_m;
  char line[240];
  std::snprintf(line, sizeof(line), "%.6f %.6f %.6f %.8f %.8f %.8f %.8f", place.x(), place.y(),
                place.z(), turn.x(), turn.y(), turn.z(), turn.w());
  return io::append_line(folder_ / sensors_[frame.sensor].name / "groundtruth.txt",
                         tum_seconds(began_at_ + frame.time) + " " + line);
}

Status FolderWriter::finish() {
  return writer_ ? writer_->finish() : Status();
}

}  // namespace roomcast::recording
