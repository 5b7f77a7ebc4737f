// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/color/vp9_color_encoder.h"

#include <algorithm>
#include <cmath>

#include <vpx/vp8cx.h>
#include <vpx/vpx_encoder.h>

#include "roomcast/codec/color/vpx_context.h"

namespace roomcast::codec {
namespace {

constexpr int kSpeed = 5;
constexpr unsigned kMaxQuantizer = 56;
// Quantisers of key frames. Fine key frames pay: the camera does not move, so that a well coded
// still part stays good at a small part of the cost of motion. In a calm room key frames are most
// of the stream; there they are coarser, and no frame between them is finer.
constexpr unsigned kFineQuantizer = 10, kCalmQuantizer = 20;
constexpr double kCalmShare = 0.5;       // of the rate; a calm room uses less between key frames
constexpr int kFinerByNow = 6;           // quantisers at which still blocks are coded again
constexpr int kCyclicRefresh = 3;        // spreads the quality of still parts over frames
constexpr int kMaxKeyFrameShare = 4000;  // percent of the bits of an average frame
constexpr unsigned kBaseLayerPercent = 70;

// A frame depends on the layer-0 frame before it and on the key frame, which shows the surfaces
// behind moving objects.
constexpr vpx_enc_frame_flags_t kFromLastAndKey =
    VP8_EFLAG_NO_REF_ARF | VP8_EFLAG_NO_UPD_GF | VP8_EFLAG_NO_UPD_ARF;
constexpr vpx_enc_frame_flags_t kLeavesNoTrace = VP8_EFLAG_NO_UPD_LAST | VP8_EFLAG_NO_UPD_ENTROPY;

void set_rates(const FrameEncoderOptions& options, vpx_codec_enc_cfg_t& config) {
  config.rc_target_bitrate = static_cast<unsigned>(options.color_kbit_per_s);
  if (options.temporal_layers == 1) return;
  config.layer_target_bitrate[0] = config.rc_target_bitrate * kBaseLayerPercent / 100;
  config.layer_target_bitrate[1] = config.rc_target_bitrate;
  config.ts_target_bitrate[0] = config.layer_target_bitrate[0];
  config.ts_target_bitrate[1] = config.layer_target_bitrate[1];
}

void set_layers(const FrameEncoderOptions& options, vpx_codec_enc_cfg_t& config) {
  config.ss_number_layers = 1;
  config.ts_number_layers = options.temporal_layers > 1 ? 2 : 1;
  if (options.temporal_layers == 1) return;
  // Without it a frame depends on motion and probabilities of the previous one, which may have been
  // dropped.
  config.g_error_resilient = VPX_ERROR_RESILIENT_DEFAULT;
  config.temporal_layering_mode = VP9E_TEMPORAL_LAYERING_MODE_BYPASS;
  config.ts_periodicity = 2;  // libvpx sees all layers above 0 as one
  config.ts_layer_id[1] = 1;
  config.ts_rate_decimator[0] = 1u << (options.temporal_layers - 1);
  config.ts_rate_decimator[1] = 1;
}

bool make_config(const FrameEncoderOptions& options, vpx_codec_enc_cfg_t& config) {
  if (vpx_codec_enc_config_default(vpx_codec_vp9_cx(), &config, 0) != VPX_CODEC_OK) return false;
  config.g_w = static_cast<unsigned>(options.color_scale * options.width);
  config.g_h = static_cast<unsigned>(options.color_scale * options.height);
  config.g_timebase = {1000, static_cast<int>(std::lround(options.fps * 1000))};
  config.g_threads = 1;
  config.g_pass = VPX_RC_ONE_PASS;
  config.g_lag_in_frames = 0;
  config.kf_mode = VPX_KF_DISABLED;  // key frames only on request
  config.rc_end_usage = VPX_CBR;
  config.rc_min_quantizer = kCalmQuantizer;
  config.rc_max_quantizer = kMaxQuantizer;
  config.rc_dropframe_thresh = 0;  // the frame is sent anyway, for its depth
  config.rc_resize_allowed = 0;
  set_layers(options, config);
  set_rates(options, config);
  return true;
}

bool apply_controls(vpx_codec_ctx_t& context, bool layered) {
  bool ok = vpx_codec_control(&context, VP8E_SET_CPUUSED, kSpeed) == VPX_CODEC_OK;
  // Tuned for screen content: registered colour has similarly hard edges, and libvpx's shortcuts
  // for camera pictures cost 0.4 to 0.8 dB here.
  ok &= vpx_codec_control(&context, VP9E_SET_TUNE_CONTENT, VP9E_CONTENT_SCREEN) == VPX_CODEC_OK;
  ok &= vpx_codec_control(&context, VP9E_SET_AQ_MODE, kCyclicRefresh) == VPX_CODEC_OK;
  ok &= vpx_codec_control(&context, VP9E_SET_TILE_COLUMNS, 0) == VPX_CODEC_OK;
  ok &= vpx_codec_control(&context, VP8E_SET_MAX_INTRA_BITRATE_PCT, kMaxKeyFrameShare) ==
        VPX_CODEC_OK;
  ok &= vpx_codec_control(&context, VP9E_SET_COLOR_SPACE, VPX_CS_BT_709) == VPX_CODEC_OK;
  ok &= vpx_codec_control(&context, VP9E_SET_COLOR_RANGE, VPX_CR_STUDIO_RANGE) == VPX_CODEC_OK;
  if (layered) ok &= vpx_codec_control(&context, VP9E_SET_SVC, 1) == VPX_CODEC_OK;
  return ok;
}

vpx_image_t wrap(I420Image& image) {
  vpx_image_t wrapped;
  vpx_img_wrap(&wrapped, VPX_IMG_FMT_I420, static_cast<unsigned>(image.y.width()),
               static_cast<unsigned>(image.y.height()), 1, image.y.data());
  Image<std::uint8_t>* const planes[] = {&image.y, &image.cb, &image.cr};
  for (int i = 0; i < 3; ++i) {
    wrapped.planes[i] = planes[i]->data();
    wrapped.stride[i] = planes[i]->width();
  }
  wrapped.cs = VPX_CS_BT_709;
  wrapped.range = VPX_CR_STUDIO_RANGE;
  return wrapped;
}

/// Repeats each pixel; `to` is `scale` times as wide and high.
void repeat_pixels(MaskView from, int scale, MaskImage& to) {
  for (int y = 0; y < to.height(); ++y) {
    const std::uint8_t* const source = from.row(y / scale);
    std::uint8_t* const row = to.view().row(y);
    for (int x = 0; x < from.width; ++x) {
      for (int i = 0; i < scale; ++i) row[scale * x + i] = source[x];
    }
  }
}

}  // namespace

struct Vp9ColorEncoder::Codec : VpxContext {
  vpx_codec_enc_cfg_t config{};
};

Vp9ColorEncoder::Vp9ColorEncoder(const FrameEncoderOptions& options, std::unique_ptr<Codec> codec)
    : options_(options), codec_(std::move(codec)), key_quantizer_(kFineQuantizer) {
  const int width = options.color_scale * options.width;
  const int height = options.color_scale * options.height;
  input_.resize(width, height);
  seen_.resize(width, height);
  ever_seen_.resize(width, height);
  chroma_ever_seen_.resize(input_.cb.width(), input_.cb.height());
}

Vp9ColorEncoder::~Vp9ColorEncoder() = default;

Result<std::unique_ptr<Vp9ColorEncoder>> Vp9ColorEncoder::create(
    const FrameEncoderOptions& options) {
  const Error failure{ErrorCode::kUnavailable,
                      "libvpx could not start a VP9 encoder of this size and rate."};
  auto codec = std::make_unique<Codec>();
  if (!make_config(options, codec->config)) return failure;
  if (vpx_codec_enc_init(&codec->context, vpx_codec_vp9_cx(), &codec->config, 0) != VPX_CODEC_OK) {
    return failure;
  }
  codec->open = true;
  if (!apply_controls(codec->context, options.temporal_layers > 1)) return failure;
  return std::unique_ptr<Vp9ColorEncoder>(new Vp9ColorEncoder(options, std::move(codec)));
}

Status Vp9ColorEncoder::encode(ColorView color, MaskView seen, FrameRole role,
                               std::vector<std::uint8_t>& out, BlockNeedsView needs) {
  repeat_pixels(seen, options_.color_scale, seen_);
  convert_seen(color, seen_, input_);
  remember_seen();
  if (role.key) fill_never_seen();
  const bool droppable = role.layer > 0;

  vpx_enc_frame_flags_t flags = role.key ? VPX_EFLAG_FORCE_KF : kFromLastAndKey;
  if (droppable) flags |= kLeavesNoTrace;
  if (options_.temporal_layers > 1) set_layer(droppable);
  if (role.key) choose_quality();
  refine_still_blocks(role);
  if (!limit_quantizer(role)) {
    return Error{ErrorCode::kUnavailable, "libvpx refused a limit of the colour quantiser."};
  }
  const MaskView without = left_out(needs, role);
  const vpx_image_t image = wrap(hold_.apply(input_, !droppable, without));
  set_active(activity_.update(hold_.changed(), role, without));
  if (vpx_codec_encode(&codec_->context, &image, frame_count_++, 1, flags, VPX_DL_REALTIME) !=
      VPX_CODEC_OK) {
    return Error{ErrorCode::kUnavailable, "libvpx failed to encode a colour picture."};
  }
  const std::size_t before = out.size();
  take_packets(out);
  if (!role.key) bytes_since_key_ += out.size() - before;
  return {};
}

void Vp9ColorEncoder::set_layer(bool droppable) {
  vpx_svc_layer_id_t layer{};
  layer.temporal_layer_id = droppable;
  layer.temporal_layer_id_per_spatial[0] = droppable;
  vpx_codec_control(&codec_->context, VP9E_SET_SVC_LAYER_ID, &layer);
}

void Vp9ColorEncoder::take_packets(std::vector<std::uint8_t>& out) {
  vpx_codec_iter_t position = nullptr;
  while (const vpx_codec_cx_pkt_t* packet = vpx_codec_get_cx_data(&codec_->context, &position)) {
    if (packet->kind != VPX_CODEC_CX_FRAME_PKT) continue;
    const auto* bytes = static_cast<const std::uint8_t*>(packet->data.frame.buf);
    out.insert(out.end(), bytes, bytes + packet->data.frame.sz);
  }
}

Status Vp9ColorEncoder::set_rate(int kbit_per_s) {
  options_.color_kbit_per_s = kbit_per_s;
  set_rates(options_, codec_->config);
  if (vpx_codec_enc_config_set(&codec_->context, &codec_->config) == VPX_CODEC_OK) return {};
  return Error{ErrorCode::kUnavailable, "libvpx refused to change the rate of the colour stream."};
}

void Vp9ColorEncoder::choose_quality() {
  const auto frames = static_cast<double>(frame_count_ - key_at_ - 1);
  key_at_ = frame_count_;
  if (frames >= options_.fps) {  // fewer frames are not representative
    const double kbit_per_s =
        static_cast<double>(bytes_since_key_) * 8 / 1000 * options_.fps / frames;
    const bool calm = kbit_per_s < kCalmShare * options_.color_kbit_per_s;
    key_quantizer_ = calm ? kCalmQuantizer : kFineQuantizer;
  }
  bytes_since_key_ = 0;
}

// Still blocks keep the quality of the frame that coded them last. With a fixed quantiser they are
// coded again once the quantiser has become noticeably finer.
void Vp9ColorEncoder::refine_still_blocks(FrameRole role) {
  if (!fixed_quantizer_ || role.layer > 0) return;
  if (role.key) {
    still_quantizer_ = *fixed_quantizer_;
  } else if (!activity_.is_improving() && *fixed_quantizer_ <= still_quantizer_ - kFinerByNow) {
    activity_.improve_still_blocks();
    still_quantizer_ = *fixed_quantizer_;
  }
}

bool Vp9ColorEncoder::limit_quantizer(FrameRole role) {
  unsigned least = role.key ? key_quantizer_ : kCalmQuantizer;
  unsigned most = role.key ? key_quantizer_ : kMaxQuantizer;
  if (fixed_quantizer_) least = most = static_cast<unsigned>(*fixed_quantizer_);
  vpx_codec_enc_cfg_t& config = codec_->config;
  if (config.rc_min_quantizer == least && config.rc_max_quantizer == most) return true;
  config.rc_min_quantizer = least;
  config.rc_max_quantizer = most;
  return vpx_codec_enc_config_set(&codec_->context, &codec_->config) == VPX_CODEC_OK;
}

void Vp9ColorEncoder::set_active(MaskView active) {
  // libvpx copies the map, though it takes a non-const pointer. If it refuses, the frame is only
  // longer.
  vpx_active_map_t map{const_cast<std::uint8_t*>(active.data), static_cast<unsigned>(active.height),
                       static_cast<unsigned>(active.width)};
  vpx_codec_control(&codec_->context, VP8E_SET_ACTIVEMAP, &map);
}

/// A block of colour is left out if all of depth's are that it covers.
MaskView Vp9ColorEncoder::left_out(BlockNeedsView needs, FrameRole role) {
  if (needs.data == nullptr) return {};
  const int side = ColorActivity::kSide / (kNeedSide * options_.color_scale);  // 2, or 1
  const int wide = (input_.y.width() + ColorActivity::kSide - 1) / ColorActivity::kSide;
  const int high = (input_.y.height() + ColorActivity::kSide - 1) / ColorActivity::kSide;
  left_out_.resize(wide, high, 1);
  for (int y = 0; y < std::min(needs.height, high * side); ++y) {
    const BlockNeed* const row = needs.row(y);
    for (int x = 0; x < std::min(needs.width, wide * side); ++x) {
      if (!leaves_out_color(row[x], role)) left_out_.at(x / side, y / side) = 0;
    }
  }
  return left_out_;
}

void Vp9ColorEncoder::remember_seen() {
  const std::size_t count = seen_.view().pixel_count();
  for (std::size_t i = 0; i < count; ++i) ever_seen_.data()[i] |= seen_.data()[i];
}

void Vp9ColorEncoder::fill_never_seen() {
  for (int y = 0; y < chroma_ever_seen_.height(); ++y) {
    const int y0 = 2 * y, y1 = std::min(y0 + 1, ever_seen_.height() - 1);
    for (int x = 0; x < chroma_ever_seen_.width(); ++x) {
      const int x0 = 2 * x, x1 = std::min(x0 + 1, ever_seen_.width() - 1);
      chroma_ever_seen_.at(x, y) = ever_seen_.at(x0, y0) | ever_seen_.at(x1, y0) |
                                   ever_seen_.at(x0, y1) | ever_seen_.at(x1, y1);
    }
  }
  hole_fill_.fill(input_.y.view(), ever_seen_);
  hole_fill_.fill(input_.cb.view(), chroma_ever_seen_);
  hole_fill_.fill(input_.cr.view(), chroma_ever_seen_);
}

}  // namespace roomcast::codec
