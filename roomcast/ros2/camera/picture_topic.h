// SPDX-License-Identifier: Apache-2.0
// PictureTopic: pictures of one topic of ROS 2 and the CameraInfo beside it. Messages are
// untrusted: those that cannot be read are left out. Single-threaded.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/recording/import/ros_picture.h"
#include "roomcast/ros2/dds/participant.h"

namespace roomcast::ros2 {

class PictureTopic {
 public:
  /// Errors of Participant::reader().
  static Result<std::unique_ptr<PictureTopic>> open(Participant& participant,
                                                    const std::string& name);

  /// Reads the CameraInfo that has come, if any. Not after keep_camera().
  void look_for_camera();
  [[nodiscard]] const std::optional<recording::ros::CameraInfoMessage>& camera() const {
    return camera_;
  }
  /// The camera() stays as it is from now on.
  void keep_camera() { infos_.reset(); }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::string& info_name() const { return info_name_; }
  [[nodiscard]] bool is_rectified() const;

  /// The next picture that has come: its stamp; nothing if there is none. Errors of the decoder,
  /// with the topic's name; kMalformed for a message that is none.
  [[nodiscard]] Result<std::optional<nanoseconds>> take(DepthImage& depth_mm);
  [[nodiscard]] Result<std::optional<nanoseconds>> take(ColorImage& color);

 private:
  PictureTopic(std::string name, std::string info_name, bool is_compressed);
  template <class Picture, class Decode>
  [[nodiscard]] Result<std::optional<nanoseconds>> take_with(Picture& picture, Decode decode);

  std::string name_, info_name_;
  bool is_compressed_;
  std::unique_ptr<Reader> pictures_, infos_;
  std::optional<recording::ros::CameraInfoMessage> camera_;
  recording::RosPictureDecoder decoder_;
};

}  // namespace roomcast::ros2
