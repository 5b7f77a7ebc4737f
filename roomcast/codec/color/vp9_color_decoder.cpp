// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/color/vp9_color_decoder.h"

#include <vpx/vp8dx.h>
#include <vpx/vpx_decoder.h>

#include "roomcast/codec/color/i420_image.h"
#include "roomcast/codec/color/vp9_header.h"
#include "roomcast/codec/color/vpx_context.h"
#include "roomcast/codec/payload/payload_sections.h"
#include "roomcast/core/little_endian.h"

namespace roomcast::codec {
namespace {

// A superframe index for one frame with a 4-byte size: VP9 specification, Annex B.
constexpr std::uint8_t kIndexMarker = 0xC0 | (4 - 1) << 3 | (1 - 1);
constexpr std::size_t kIndexLength = 1 + 4 + 1;

/// libvpx decodes further frames as long as bytes remain. An index of one frame stops it after the
/// first.
void frame_alone(std::span<const std::uint8_t> frame, std::vector<std::uint8_t>& out) {
  out.assign(frame.begin(), frame.end());
  out.resize(frame.size() + kIndexLength);
  std::uint8_t* index = out.data() + frame.size();
  index[0] = index[kIndexLength - 1] = kIndexMarker;
  write_u32(index + 1, static_cast<std::uint32_t>(frame.size()));
}

}  // namespace

struct Vp9ColorDecoder::Codec : VpxContext {};

Vp9ColorDecoder::Vp9ColorDecoder(int width, int height, std::unique_ptr<Codec> codec)
    : grid_width_(width),
      grid_height_(height),
      width_(width),
      height_(height),
      codec_(std::move(codec)) {}

Vp9ColorDecoder::~Vp9ColorDecoder() = default;

Result<std::unique_ptr<Vp9ColorDecoder>> Vp9ColorDecoder::create(int width, int height) {
  auto codec = std::make_unique<Codec>();
  const vpx_codec_dec_cfg_t config{1, static_cast<unsigned>(width), static_cast<unsigned>(height)};
  if (vpx_codec_dec_init(&codec->context, vpx_codec_vp9_dx(), &config, 0) != VPX_CODEC_OK) {
    return Error{ErrorCode::kUnavailable, "libvpx could not start a VP9 decoder."};
  }
  codec->open = true;
  return std::unique_ptr<Vp9ColorDecoder>(new Vp9ColorDecoder(width, height, std::move(codec)));
}

Status Vp9ColorDecoder::decode(std::span<const std::uint8_t> frame, ColorImage& color) {
  if (Status status = check_header(frame); !status.ok()) return status;
  needs_key_ = true;  // until the frame is decoded
  frame_alone(frame, framed_);
  if (vpx_codec_decode(&codec_->context, framed_.data(), static_cast<unsigned>(framed_.size()),
                       nullptr, 0) != VPX_CODEC_OK) {
    return malformed("The colour section's VP9 frame is damaged.");
  }
  Status status = take_picture(color);
  needs_key_ = !status.ok();
  return status;
}

Status Vp9ColorDecoder::check_header(std::span<const std::uint8_t> frame) {
  const auto header = parse_vp9_header(frame);
  if (!header.ok()) return header.error();
  if (header->width != 0 && !take_size(*header)) {
    return malformed("The colour is not of the sensor's size.");
  }
  if (needs_key_ && !header->key) {
    return Error{ErrorCode::kMalformed,
                 "The colour needs a frame that was not received; ask for a key frame."};
  }
  return {};
}

/// Takes a legal size; only a key frame may change it.
bool Vp9ColorDecoder::take_size(const Vp9Header& header) {
  const auto is = [&](int width, int height) {
    return header.width == width && header.height == height;
  };
  if (is(width_, height_)) return true;
  const int scale = is(grid_width_, grid_height_) ? 1 : kMaxColorScale;
  const int width = scale * grid_width_, height = scale * grid_height_;
  if (!header.key || !is(width, height) || !is_color_size(width, height)) return false;
  width_ = width;
  height_ = height;
  return true;
}

Status Vp9ColorDecoder::take_picture(ColorImage& color) {
  vpx_codec_iter_t position = nullptr;
  const vpx_image_t* picture = vpx_codec_get_frame(&codec_->context, &position);
  if (picture == nullptr || picture->fmt != VPX_IMG_FMT_I420 ||
      static_cast<int>(picture->d_w) != width_ || static_cast<int>(picture->d_h) != height_) {
    return malformed("The colour section gives no picture of the sensor's size.");
  }
  const int chroma_width = (width_ + 1) / 2, chroma_height = (height_ + 1) / 2;
  const I420View planes{
      {picture->planes[VPX_PLANE_Y], width_, height_, picture->stride[VPX_PLANE_Y]},
      {picture->planes[VPX_PLANE_U], chroma_width, chroma_height, picture->stride[VPX_PLANE_U]},
      {picture->planes[VPX_PLANE_V], chroma_width, chroma_height, picture->stride[VPX_PLANE_V]}};
  if (color.width() != width_ || color.height() != height_) color.resize(width_, height_);
  convert_to_rgb(planes, color.view());
  return {};
}

}  // namespace roomcast::codec
