// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/ros_picture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string_view>

#include "roomcast/core/little_endian.h"

namespace roomcast::recording {
namespace {

constexpr std::size_t kDepthHeadBytes = 12;  // format and two numbers of inverse depth

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

std::optional<PixelFormat> format_of_encoding(std::string_view encoding, bool is_bigendian,
                                              bool yuv422_is_yuyv) {
  if (encoding == "rgb8" || encoding == "8UC3") return PixelFormat::kRgb8;
  if (encoding == "bgr8") return PixelFormat::kBgr8;
  if (encoding == "rgba8") return PixelFormat::kRgba8;
  if (encoding == "bgra8") return PixelFormat::kBgra8;
  if (encoding == "mono8" || encoding == "8UC1") return PixelFormat::kMono8;
  if (encoding == "yuv422_yuy2" || encoding == "yuyv") return PixelFormat::kYuy2;
  if (encoding == "yuv422" && yuv422_is_yuyv) return PixelFormat::kYuy2;
  if (encoding == "yuv422" || encoding == "uyvy") return PixelFormat::kUyvy;
  if (encoding == "nv12") return PixelFormat::kNv12;
  if (encoding == "16UC1" || encoding == "mono16")
    return is_bigendian ? PixelFormat::kDepth16Big : PixelFormat::kDepth16Little;
  if (encoding == "32FC1" && !is_bigendian) return PixelFormat::kDepthFloat;
  return std::nullopt;
}

Error another_size() {
  return malformed("a picture in it has another size than its camera_info");
}

Result<StoredPicture> stored(const ros::ImageMessage& image, int width, int height,
                             bool yuv422_is_yuyv) {
  const auto format = format_of_encoding(image.encoding, image.is_bigendian, yuv422_is_yuyv);
  if (!format)
    return Error{ErrorCode::kUnsupported, "its pictures have the encoding \"" + image.encoding +
                                              "\", which is not supported"};
  if (image.width != static_cast<std::uint32_t>(width) ||
      image.height != static_cast<std::uint32_t>(height))
    return another_size();
  return StoredPicture{*format, width, height, image.step, image.data};
}

bool is_png(ros::ByteView bytes) {
  constexpr std::uint8_t kStart[] = {0x89, 'P', 'N', 'G'};
  return bytes.size() > 4 && std::equal(std::begin(kStart), std::end(kStart), bytes.begin());
}

/// Inverse depth back to millimetres: depth = a / (value - b), in metres.
void from_inverse(float a, float b, DepthImage& depth) {
  for (std::size_t i = 0; i < depth.view().pixel_count(); ++i) {
    std::uint16_t& value = depth.data()[i];
    const float mm = std::round(1000 * a / (static_cast<float>(value) - b));
    value =
        value != 0 && mm >= 1 && mm <= 65535 ? static_cast<std::uint16_t>(mm) : std::uint16_t{0};
  }
}

/// Four bits at a time, from words of 32 bits.
class Nibbles {
 public:
  explicit Nibbles(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  /// A number of groups of three bits, the fourth of which says that more follow.
  std::optional<std::uint32_t> number() {
    std::uint32_t value = 0;
    for (unsigned shift = 0; shift < 30; shift += 3) {
      if (left_ == 0) {
        if (bytes_.size() < 4) return std::nullopt;
        word_ = read_u32(bytes_.data());
        bytes_ = bytes_.subspan(4);
        left_ = 8;
      }
      const std::uint32_t nibble = word_ >> 28U;
      word_ <<= 4U;
      --left_;
      value |= (nibble & 7U) << shift;
      if ((nibble & 8U) == 0) return value;
    }
    return std::nullopt;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::uint32_t word_ = 0;
  int left_ = 0;
};

}  // namespace

RosPictureKind kind_of_encoding(const std::string& encoding, const std::string& topic) {
  const auto format = format_of_encoding(encoding, false, false);
  if (!format) return RosPictureKind::kOther;
  if (contains(topic, "infra") || contains(topic, "/ir/")) return RosPictureKind::kOther;
  if (!is_depth(*format)) return RosPictureKind::kColor;
  return encoding != "mono16" || contains(topic, "depth") ? RosPictureKind::kDepth
                                                          : RosPictureKind::kOther;
}

RosPictureKind kind_of_compressed(const std::string& format) {
  if (contains(format, "compressedDepth")) return RosPictureKind::kDepth;
  if (contains(format, "16UC1")) return RosPictureKind::kDepth;  // PNG of 16 bits
  return is_jpeg(format) || contains(format, "png") ? RosPictureKind::kColor
                                                    : RosPictureKind::kOther;
}

bool is_jpeg(const std::string& format) {
  return contains(format, "jpeg") || contains(format, "jpg");
}

bool decode_rvl(std::span<const std::uint8_t> bytes, DepthImage& depth) {
  Nibbles nibbles(bytes);
  std::uint16_t* at = depth.data();
  std::size_t left = depth.view().pixel_count();
  std::uint32_t previous = 0;
  while (left > 0) {
    const auto zeros = nibbles.number();
    if (!zeros || *zeros > left) return false;
    at = std::fill_n(at, *zeros, std::uint16_t{0});
    left -= *zeros;
    const auto values = nibbles.number();
    if (!values || *values > left || (*zeros == 0 && *values == 0)) return false;
    for (std::uint32_t i = 0; i < *values; ++i) {
      const auto change = nibbles.number();
      if (!change) return false;
      previous += (*change >> 1U) ^ (~(*change & 1U) + 1);
      *at++ = static_cast<std::uint16_t>(previous);
    }
    left -= *values;
  }
  return true;
}

Status RosPictureDecoder::depth(const ros::ImageMessage& image, int width, int height,
                                DepthImage& depth) {
  const auto picture = stored(image, width, height, yuv422_is_yuyv_);
  if (!picture) return picture.error();
  return decoder_.depth(*picture, depth);
}

Status RosPictureDecoder::color(const ros::ImageMessage& image, int width, int height,
                                ColorImage& color) {
  const auto picture = stored(image, width, height, yuv422_is_yuyv_);
  if (!picture) return picture.error();
  return decoder_.color(*picture, color);
}

Status RosPictureDecoder::depth(const ros::CompressedImageMessage& image, int width, int height,
                                DepthImage& depth) {
  ros::ByteView bytes = image.data;
  const bool has_head = contains(image.format, "compressedDepth");
  if (has_head && bytes.size() < kDepthHeadBytes) return malformed("a picture in it is incomplete");
  const float a = has_head ? std::bit_cast<float>(read_u32(bytes.data() + 4)) : 0;
  const float b = has_head ? std::bit_cast<float>(read_u32(bytes.data() + 8)) : 0;
  if (has_head) bytes = bytes.subspan(kDepthHeadBytes);
  if (has_head && !is_png(bytes)) {
    const bool fits = bytes.size() >= 8 &&
                      read_u32(bytes.data()) == static_cast<std::uint32_t>(width) &&
                      read_u32(bytes.data() + 4) == static_cast<std::uint32_t>(height);
    if (!fits) return another_size();
    depth.resize(width, height);
    if (!decode_rvl(bytes.subspan(8), depth)) return malformed("a picture in it is damaged");
  } else if (Status status = decoder_.depth({PixelFormat::kPng, width, height, 0, bytes}, depth);
             !status) {
    return status;
  }
  if (contains(image.format, "32FC1")) from_inverse(a, b, depth);
  return {};
}

Status RosPictureDecoder::color(const ros::CompressedImageMessage& image, int width, int height,
                                ColorImage& color) {
  const PixelFormat format = is_png(image.data) ? PixelFormat::kPng : PixelFormat::kJpeg;
  return decoder_.color({format, width, height, 0, image.data}, color);
}

}  // namespace roomcast::recording
