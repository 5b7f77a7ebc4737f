// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/foxglove_sensor_file.h"

#include <algorithm>
#include <utility>

#include "roomcast/codec/color/vp9_color_decoder.h"
#include "roomcast/recording/foxglove/foxglove_reader.h"
#include "roomcast/recording/import/ros_picture.h"

namespace roomcast::recording {
namespace {

Error damaged_message() {
  return malformed("a message of it is damaged");
}

class FoxgloveSensorFile final : public SensorFile {
 public:
  FoxgloveSensorFile(std::shared_ptr<MessageStore> store, FoxgloveCameraParts parts,
                     std::string name)
      : store_(std::move(store)), parts_(std::move(parts)), name_(std::move(name)) {}

  [[nodiscard]] const SensorFileInfo& info() const override { return parts_.info; }

  [[nodiscard]] Status read_depth(std::size_t frame, DepthImage& depth_mm) override {
    const CameraIntrinsics& camera = parts_.info.description.calibration.depth;
    return named(decode(parts_.depth, frame, [&](const auto& image) -> Status {
      return decoder_.depth(image, camera.width, camera.height, depth_mm);
    }));
  }

  [[nodiscard]] Status read_color(std::size_t frame, ColorImage& color) override {
    color = {};
    const auto& at = parts_.color_of_depth[frame];
    if (!at) return {};
    if (parts_.color->pictures == FoxglovePictures::kVideo) return named(play_to(*at, color));
    const CameraIntrinsics& camera = parts_.info.description.calibration.color;
    return named(decode(*parts_.color, *at, [&](const auto& image) -> Status {
      return decoder_.color(image, camera.width, camera.height, color);
    }));
  }

  [[nodiscard]] Status read_jpeg(std::size_t frame, std::vector<std::uint8_t>& jpeg) override {
    jpeg.clear();
    const auto& at = parts_.color_of_depth[frame];
    if (!at || parts_.color->pictures != FoxglovePictures::kCompressed) return {};
    const auto data = store_->data(parts_.color->messages[*at]);
    if (!data) return named(data.error());
    const auto image = reader_.compressed_image(*data);
    if (!image) return named(damaged_message());
    if (is_jpeg(image->format)) jpeg.assign(image->data.begin(), image->data.end());
    return {};
  }

 private:
  /// `use` gets the picture of a stream that is no video.
  template <class Use>
  [[nodiscard]] Status decode(const FoxgloveStream& stream, std::size_t at, Use use) {
    const auto data = store_->data(stream.messages[at]);
    if (!data) return data.error();
    if (stream.pictures == FoxglovePictures::kRaw) {
      const auto image = reader_.raw_image(*data);
      return image ? use(*image) : Status(damaged_message());
    }
    const auto image = reader_.compressed_image(*data);
    return image ? use(*image) : Status(damaged_message());
  }

  /// Decodes the video from the last picture that needs no other, or goes on where it was.
  [[nodiscard]] Status play_to(std::size_t at, ColorImage& color) {
    const auto& keys = parts_.color->keys;
    const auto after = std::ranges::upper_bound(keys, at);
    const std::size_t key = after == keys.begin() ? 0 : *(after - 1);
    const std::size_t begin = at >= next_in_video_ ? std::max(key, next_in_video_) : key;
    Status status = damaged_message();
    for (std::size_t i = begin; i <= at; ++i) status = decode_video(i, color);
    next_in_video_ = at + 1;
    if (!status) color = {};
    return status;
  }

  [[nodiscard]] Status decode_video(std::size_t at, ColorImage& color) {
    const CameraIntrinsics& camera = parts_.info.description.calibration.color;
    if (!video_) {
      auto made = codec::Vp9ColorDecoder::create(camera.width, camera.height);
      if (!made) return made.error();
      video_ = *std::move(made);
    }
    const auto data = store_->data(parts_.color->messages[at]);
    if (!data) return data.error();
    const auto picture = reader_.compressed_video(*data);
    if (!picture) return damaged_message();
    if (Status status = video_->decode(picture->data, color); !status) return status;
    const bool fits = color.width() == camera.width && color.height() == camera.height;
    return fits ? Status() : Status(malformed("a picture in it has another size than its camera"));
  }

  [[nodiscard]] Status named(Status status) const {
    if (status) return status;
    return Error{status.error().code, name_ + ": " + status.error().message};
  }

  std::shared_ptr<MessageStore> store_;
  FoxgloveCameraParts parts_;
  std::string name_;
  FoxgloveReader reader_;
  RosPictureDecoder decoder_;
  std::unique_ptr<codec::Vp9ColorDecoder> video_;  // made on first use
  std::size_t next_in_video_ = 0;                  // position in `color`
};

}  // namespace

std::unique_ptr<SensorFile> make_foxglove_sensor(std::shared_ptr<MessageStore> store,
                                                 FoxgloveCameraParts parts, std::string name) {
  return std::make_unique<FoxgloveSensorFile>(std::move(store), std::move(parts), std::move(name));
}

}  // namespace roomcast::recording
