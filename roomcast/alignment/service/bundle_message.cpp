// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/bundle_message.h"

#include <span>
#include <utility>
#include <vector>

#include "roomcast/alignment/service/picture_bytes.h"
#include "roomcast/io/jpeg_codec.h"

namespace roomcast::alignment {

namespace {

constexpr int kJpegQuality = 90;  // high enough for feature detection

/// A mask as a picture that the depth codec takes: 0 and 1.
DepthImage zeros_and_ones(const MaskImage& mask) {
  DepthImage picture(mask.width(), mask.height());
  for (std::size_t i = 0; i < picture.view().pixel_count(); ++i) {
    picture.data()[i] = mask.data()[i] != 0;
  }
  return picture;
}

MaskImage mask_of(const DepthImage& zeros_and_ones) {
  MaskImage mask(zeros_and_ones.width(), zeros_and_ones.height());
  for (std::size_t i = 0; i < mask.view().pixel_count(); ++i) {
    mask.data()[i] = zeros_and_ones.data()[i] != 0 ? 255 : 0;
  }
  return mask;
}

}  // namespace

Result<wire::pb::CalibrationBundle> message_from_bundle(
    const alignment::CalibrationBundle& bundle) {
  if (auto status = alignment::check(bundle); !status) return status.error();
  wire::pb::CalibrationBundle message;
  auto depth = lossless_bytes(bundle.depth_mm);
  if (!depth) return depth.error();
  message.set_depth(*std::move(depth));
  if (!bundle.moving.empty()) {
    auto moving = lossless_bytes(zeros_and_ones(bundle.moving));
    if (!moving) return moving.error();
    message.set_moving(*std::move(moving));
  }
  std::vector<std::uint8_t> jpeg;
  if (auto fault = io::JpegCodec().encode(bundle.color, kJpegQuality, jpeg); !fault.empty()) {
    return Error{ErrorCode::kInvalidArgument, fault};
  }
  message.set_color_jpeg(std::string(jpeg.begin(), jpeg.end()));
  if (bundle.depth_scale) message.set_depth_scale(*bundle.depth_scale);
  if (bundle.up) {
    for (const double number : *bundle.up) message.add_up(number);
  }
  return message;
}

Result<alignment::CalibrationBundle> bundle_from_message(const wire::pb::CalibrationBundle& message,
                                                         std::string name,
                                                         const SensorCalibration& calibration) {
  alignment::CalibrationBundle bundle;
  bundle.name = std::move(name);
  bundle.calibration = calibration;
  const int width = calibration.depth.width, height = calibration.depth.height;
  auto depth = picture_of_bytes(message.depth(), width, height);
  if (!depth) return depth.error();
  bundle.depth_mm = *std::move(depth);
  if (!message.moving().empty()) {
    const auto moving = picture_of_bytes(message.moving(), width, height);
    if (!moving) return moving.error();
    bundle.moving = mask_of(*moving);
  }
  bundle.color.resize(calibration.color.width, calibration.color.height);
  const auto fault = io::JpegCodec().decode(bytes_of(message.color_jpeg()), bundle.color.view());
  if (!fault.empty()) return Error{ErrorCode::kMalformed, "a bundle's colour picture: " + fault};
  if (message.depth_scale() != 0) bundle.depth_scale = message.depth_scale();
  if (message.up_size() == 3) bundle.up.emplace(message.up(0), message.up(1), message.up(2));
  return bundle;
}

}  // namespace roomcast::alignment
