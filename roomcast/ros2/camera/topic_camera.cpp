// SPDX-License-Identifier: Apache-2.0
#include "roomcast/ros2/camera/topic_camera.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/recording/import/color_pairs.h"
#include "roomcast/recording/import/frame_tree.h"
#include "roomcast/recording/import/ros_lens.h"
#include "roomcast/ros2/camera/picture_topic.h"
#include "roomcast/ros2/dds/names.h"

namespace roomcast::ros2 {
namespace {

using recording::ros::Serialisation;

constexpr const char* kKind = "ros2-topic";
constexpr std::chrono::milliseconds kLook{50};
constexpr std::size_t kPicturesForRate = 6, kFewestPictures = 2;
constexpr int kMaxRefused = 30;  // pictures in a row: the camera has changed
constexpr Quality kAllStaticTransforms{true, true, 100};  // each node that sends some has a message

struct TopicPlace {
  std::string depth, color;  // color: may be empty
};

TopicPlace split_place(const std::string& place) {
  const std::size_t comma = std::min(place.find(','), place.size());
  TopicPlace topics{place.substr(0, comma), {}};
  if (comma < place.size()) topics.color = place.substr(comma + 1);
  return topics;
}

class TopicCamera final : public source::Camera {
 public:
  /// Errors of topic_camera_backend()'s opening.
  static Result<std::unique_ptr<source::Camera>> open(const TopicPlace& place,
                                                      const TopicCameraOptions& options) {
    const auto environment = options_of_environment();
    if (!environment) return environment.error();
    auto participant = Participant::open(*environment);
    if (!participant) return participant.error();
    auto camera =
        std::unique_ptr<TopicCamera>(new TopicCamera(*std::move(participant), *environment));
    if (Status status = camera->join(place); !status) return status.error();
    if (Status status = camera->wait_for_description(options); !status) return status.error();
    if (Status status = camera->describe(); !status) return status.error();
    return std::unique_ptr<source::Camera>(std::move(camera));
  }

  [[nodiscard]] const source::CameraDescription& description() const override {
    return description_;
  }

  [[nodiscard]] Status wait(source::FramePairing& pictures,
                            std::chrono::milliseconds patience) override {
    participant_->wait(patience);
    return take(pictures);
  }

 private:
  TopicCamera(std::unique_ptr<Participant> participant, const ParticipantOptions& environment)
      : participant_(std::move(participant)), environment_(environment) {}

  Status join(const TopicPlace& place) {
    auto depth = PictureTopic::open(*participant_, place.depth);
    if (!depth) return depth.error();
    depth_ = *std::move(depth);
    if (place.color.empty()) return {};
    auto color = PictureTopic::open(*participant_, place.color);
    if (!color) return color.error();
    color_ = *std::move(color);
    auto transforms =
        participant_->reader({"/tf_static", "tf2_msgs/msg/TFMessage", kAllStaticTransforms});
    if (!transforms) return transforms.error();
    transforms_ = *std::move(transforms);
    return {};
  }

  Status wait_for_description(const TopicCameraOptions& options) {
    const HostTime end = SteadyClock().now() + options.patience;
    for (;;) {
      participant_->wait(kLook);
      look();
      const bool is_over = options.stop.stop_requested() || SteadyClock().now() >= end;
      const Status complete = check_complete(is_over ? kFewestPictures : kPicturesForRate);
      if (is_over || complete || complete.error().code != ErrorCode::kNotFound) return complete;
    }
  }

  /// Takes what has come: cameras, transforms, and pictures, of which only the stamps count.
  void look() {
    depth_->look_for_camera();
    if (color_) color_->look_for_camera();
    while (const Message message = transforms_ ? transforms_->take() : nullptr) {
      const auto read = recording::ros::read_transforms(*message, Serialisation::kRos2);
      for (std::size_t i = 0; read && i < read->size(); ++i) {
        const auto transform = recording::transform_of((*read)[i].parent_from_child);
        if (transform) frames_.add((*read)[i].parent, (*read)[i].child, *transform);
      }
    }
    while (depth_->camera()) {
      auto stamp = depth_->take(depth_mm_);
      if (!stamp) refused_ = stamp.error();
      if (stamp && !*stamp) break;
      if (stamp && (stamps_.empty() || **stamp > stamps_.back())) stamps_.push_back(**stamp);
    }
  }

  /// kNotFound: something has not come yet. A slow camera may have sent two pictures only.
  [[nodiscard]] Status check_complete(std::size_t pictures) const {
    if (!depth_->camera()) return missing(depth_->info_name());
    if (color_ && !color_->camera()) return missing(color_->info_name());
    if (color_ && !color_from_depth())
      return Error{ErrorCode::kNotFound, "/tf_static does not say where " + frame_of(*color_) +
                                             " is from " + frame_of(*depth_)};
    if (stamps_.empty() && refused_) return *refused_;
    return stamps_.size() < pictures ? Status(missing(depth_->name())) : Status();
  }

  [[nodiscard]] Error missing(const std::string& topic) const {
    return {ErrorCode::kNotFound, "nothing came on " + topic +
                                      "; does the camera's node run, in ROS_DOMAIN_ID " +
                                      std::to_string(environment_.domain) +
                                      (environment_.only_localhost ? " on this computer?" : "?")};
  }

  [[nodiscard]] static const std::string& frame_of(const PictureTopic& topic) {
    return topic.camera()->header.frame_id;
  }

  [[nodiscard]] std::optional<RigidTransform> color_from_depth() const {
    return frames_.between(frame_of(*color_), frame_of(*depth_));
  }

  Status describe() {
    depth_->keep_camera();
    if (color_) color_->keep_camera();
    transforms_.reset();
    const auto depth = recording::lens_of(*depth_->camera(), depth_->is_rectified());
    if (!depth) return in_topic(depth_->info_name(), depth.error());
    SensorCalibration& calibration = description_.calibration;
    calibration = {depth->camera, depth->camera, {}, true};
    description_.has_color = color_ != nullptr;
    description_.fps =
        recording::fps_of_gap(recording::median_gap(stamps_, recording::kNominalGap));
    if (!color_) return {};
    const auto color = recording::lens_of(*color_->camera(), color_->is_rectified());
    if (!color) return in_topic(color_->info_name(), color.error());
    calibration.color = color->camera;
    calibration.color_from_depth = *color_from_depth();
    calibration.color_is_registered =
        frame_of(*color_) == frame_of(*depth_) && calibration.color == calibration.depth;
    return {};
  }

  [[nodiscard]] static Status in_topic(const std::string& topic, const Error& error) {
    return Error{error.code, topic + ": " + error.message};
  }

  Status take(source::FramePairing& pictures) {
    for (bool more = true; more;) {
      more = false;
      auto depth = depth_->take(depth_mm_);
      if (Status status = count(depth); !status) return status;
      if (depth && *depth) {
        more = true;
        if (**depth < newest_) pictures.forget();  // a recording that begins again
        newest_ = **depth;
        pictures.depth(**depth, depth_mm_);
      }
      if (!color_) continue;
      auto color = color_->take(color_image_);
      if (Status status = count(color); !status) return status;
      if (color && *color) {
        more = true;
        pictures.color(**color, color_image_);
      }
    }
    return {};
  }

  /// A picture that cannot be used is left out; many in a row mean that this camera has gone.
  Status count(const Result<std::optional<nanoseconds>>& taken) {
    if (taken && *taken) refused_in_a_row_ = 0;
    if (taken || ++refused_in_a_row_ < kMaxRefused) return {};
    return unavailable(taken.error().message);
  }

  std::unique_ptr<Participant> participant_;
  const ParticipantOptions environment_;
  std::unique_ptr<PictureTopic> depth_, color_;
  std::unique_ptr<Reader> transforms_;
  recording::FrameTree frames_;
  source::CameraDescription description_;
  std::vector<nanoseconds> stamps_;  // of the pictures before the camera was described
  std::optional<Error> refused_;     // of those pictures
  DepthImage depth_mm_;
  ColorImage color_image_;
  nanoseconds newest_{};
  int refused_in_a_row_ = 0;
};

class TopicCameraBackend final : public source::CameraBackend {
 public:
  explicit TopicCameraBackend(TopicCameraOptions options) : options_(std::move(options)) {}

  [[nodiscard]] std::string kind() const override { return kKind; }
  [[nodiscard]] std::string library() const override { return "Cyclone DDS"; }
  [[nodiscard]] source::CameraAbilities abilities() const override { return {}; }
  /// Every topic of depth pictures could be one; they are named by the user.
  [[nodiscard]] Result<std::vector<source::CameraInfo>> list() override {
    return std::vector<source::CameraInfo>{};
  }
  [[nodiscard]] bool plays(const std::string&) const override { return true; }
  [[nodiscard]] Result<std::unique_ptr<source::Camera>> open(
      const source::CameraInfo& camera, const source::CameraSettings&) override {
    const TopicPlace place = split_place(camera.place);
    if (Status status = check_topic_name(place.depth); !status) return status.error();
    if (Status status = check_topic_name(place.color); !place.color.empty() && !status)
      return status.error();
    return TopicCamera::open(place, options_);
  }

 private:
  const TopicCameraOptions options_;
};

}  // namespace

std::unique_ptr<source::CameraBackend> topic_camera_backend(TopicCameraOptions options) {
  return std::make_unique<TopicCameraBackend>(std::move(options));
}

std::string camera_name_of_topic(const std::string& place) {
  const std::string topic = split_place(place).depth;
  const std::size_t begin = std::min<std::size_t>(1, topic.size());
  const std::size_t end = topic.find("/", begin);
  return end == std::string::npos ? "ros2" : topic.substr(begin, end - begin);
}

}  // namespace roomcast::ros2
