// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/sender/frame_sender.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "roomcast/client/uplink/bandwidth_estimator.h"

namespace roomcast::sensor {
namespace {

/// RateControl asks for key frames earlier.
constexpr double kKeyIntervalWithTarget_s = 3600;
/// While all viewers tell where they look. They are here to stay: newcomers get a key frame of
/// their own, and nobody records, who would search for them.
constexpr double kKeyIntervalWatched_s = 30;
/// Less waits where the line is estimated: its pace leaves time between frames anyway.
constexpr double kReserveOnLine_s = 0.02;

net::Pace pace_of(double line_mbit_per_s) {
  return net::pace_for(line_mbit_per_s * 1e6 / 8);
}

codec::FrameEncoderOptions encoder_options(const client::PublisherOptions& sensor,
                                           const CodecChoice& codec) {
  codec::FrameEncoderOptions options;
  options.width = sensor.calibration.depth.width;
  options.height = sensor.calibration.depth.height;
  options.fps = sensor.fps;
  options.depth_bound_mm = codec.depth_bound_mm;
  options.color_scale = codec.color_scale;
  options.color_kbit_per_s = codec.color_kbit();
  options.temporal_layers = codec.layers;
  options.depth_mode = codec.depth_mode;
  if (codec.has_target()) options.key_interval_s = kKeyIntervalWithTarget_s;
  return options;
}

/// Sets `sensor` up for the target, if there is one.
std::optional<RateControl> rate_control(const CodecChoice& codec,
                                        client::PublisherOptions& sensor) {
  if (codec.fits_line) {
    sensor.estimate_uplink = true;
    sensor.pace.reset();
    return RateControl({.bytes_per_s = client::BandwidthEstimator::kStart,
                        .fps = sensor.fps,
                        .reserve_s = kReserveOnLine_s,
                        .reserve_frames = 0});
  }
  if (codec.target_mbit_per_s <= 0) return std::nullopt;
  net::Pace pace = pace_of(codec.target_mbit_per_s);
  const RateControl::Options options{.bytes_per_s = pace.payload_bytes_per_s, .fps = sensor.fps};
  pace.payload_bytes_per_s *= RateControl::kPaceMargin;
  sensor.pace = pace;
  return RateControl(options);
}

/// On a line that does not carry the target rate.
codec::FrameTarget share_of(const codec::FrameTarget& target, double share) {
  return {share * target.bytes, share * target.key_bytes};
}

}  // namespace

FrameSender::FrameSender(HoleRegistration registration,
                         std::unique_ptr<codec::FrameEncoder> encoder, const CodecChoice& codec,
                         double fps, std::optional<RateControl> rate)
    : registration_(std::move(registration)),
      encoder_(std::move(encoder)),
      codec_(codec),
      fps_(fps),
      rate_(std::move(rate)) {}

Result<std::unique_ptr<FrameSender>> FrameSender::open(client::PublisherOptions options,
                                                       const CodecChoice& codec) {
  if (auto status = codec.check(); !status) return status.error();
  const codec::FrameEncoderOptions encoding = encoder_options(options, codec);
  if (auto status = encoding.check(); !status) return status.error();  // before memory is taken
  auto registration =
      HoleRegistration::create(options.calibration, {.color_scale = codec.color_scale});
  if (!registration) return registration.error();
  auto encoder = codec::FrameEncoder::create(encoding);
  if (!encoder) return encoder.error();
  options.follows_rate = options.follows_rate && codec.depth_mode == codec::DepthMode::kLive;
  options.takes_views = codec.depth_mode == codec::DepthMode::kLive;
  std::unique_ptr<FrameSender> sender(new FrameSender(std::move(*registration), std::move(*encoder),
                                                      codec, options.fps,
                                                      rate_control(codec, options)));
  sender->follows_rate_ = options.follows_rate;
  sender->encoding_ = encoding;
  if (options.takes_views) {
    sender->watched_.emplace(
        options.calibration.depth,
        WatchedBlocksOptions{.references_per_s = options.fps / (1 << (codec.layers - 1))});
  }
  auto publisher = client::Publisher::open(std::move(options));
  if (!publisher) return publisher.error();
  sender->publisher_ = std::move(*publisher);
  return sender;
}

Result<std::optional<client::Publisher::Published>> FrameSender::send(DepthView depth_mm,
                                                                      ColorView color,
                                                                      HostTime capture_time) {
  using Sent = std::optional<client::Publisher::Published>;
  if (!publisher_->frames_wanted()) return Sent();
  follow_demand();
  if (is_left_out()) return Sent();
  std::optional<RateControl::Plan> plan;
  if (rate_) {
    if (const auto line = publisher_->uplink())
      rate_->follow_line(std::min(line->bytes_per_s, room_bytes_per_s()),
                         static_cast<double>(line->waiting_bytes));
    plan = rate_->next_frame(capture_time, publisher_->control_bytes() + all_small_bytes());
    if (!plan) return Sent();
  }
  const auto turn = publisher_->next_turn();
  if (!turn) return Sent();
  follow_network(turn->rate_share);
  if (plan) encoder_->set_target(share_of(plan->target, turn->rate_share));
  if (auto status = register_color(depth_mm, color); !status) return status.error();
  if (auto status = follow_views(depth_mm); !status) return status.error();
  if (auto status = send_small(*turn, depth_mm, capture_time); !status) return status.error();
  auto message = client::Publisher::begin_frame();
  const bool want_key = turn->want_key || (plan && plan->wants_key);
  const auto info =
      encoder_->encode(depth_mm, registered_.color, known_colors(), want_key, message.appendable());
  if (!info) return info.error();
  has_encoded_ = true;
  const std::size_t bytes = message.payload().size();
  const bool fits = client::Publisher::fits(message);
  if (rate_) rate_->sent(bytes, *info);
  if (!info->key) has_finest_quality_ = info->quantizer == codec::FrameQuality::kMinQuantizer;
  const Sent sent = publisher_->publish(*turn, *info, capture_time, std::move(message));
  if (fits) return sent;
  return Error{ErrorCode::kTooLarge,
               "this frame has " + std::to_string(bytes) +
                   " bytes when encoded, more than a hub takes: send depth less exactly, or "
                   "smaller pictures"};
}

/// Sends the frame's small rendition ahead of it, while some viewer's line takes no more.
Status FrameSender::send_small(const client::Publisher::Turn& turn, DepthView depth_mm,
                               HostTime capture_time) {
  if (!demand_.small || codec_.small_mbit() <= 0) {
    small_bytes_ = all_small_bytes();
    small_.reset();
    return {};
  }
  if (!small_) {
    auto small =
        SmallRendition::create(encoding_, pace_of(codec_.small_mbit()).payload_bytes_per_s);
    if (!small) return small.error();
    small_ = std::move(*small);
    small_->set_base_only(demand_.base_only);
  }
  auto message = client::Publisher::begin_frame();
  const auto info = small_->encode(depth_mm, registered_.color, known_colors(), capture_time,
                                   turn.want_small_key, message.appendable());
  if (!info) return info.error();
  if (*info) publisher_->publish_small(turn, **info, capture_time, std::move(message));
  return {};
}

std::uint64_t FrameSender::all_small_bytes() const {
  return small_bytes_ + (small_ ? small_->bytes() : 0);
}

void FrameSender::follow_demand() {
  const client::Publisher::Demand demand = publisher_->demand();
  const client::Publisher::Demand before = std::exchange(demand_, demand);
  if (demand.base_only != before.base_only) {
    encoder_->set_base_only(demand.base_only);
    if (small_) small_->set_base_only(demand.base_only);
    since_base_ = 0;
  }
  if (follows_rate_ && demand.mbit != before.mbit) follow_room_rate();
}

/// What the room gives, but no more than the sensor was started with.
void FrameSender::follow_room_rate() {
  if (codec_.fits_line) return publisher_->set_pace(RateControl::kPaceMargin * room_bytes_per_s());
  const double own = codec_.target_mbit_per_s;
  const double mbit =
      demand_.mbit > 0 && own > 0 ? std::min(own, demand_.mbit) : std::max(own, demand_.mbit);
  if (mbit <= 0) {
    rate_.reset();
    choose_key_interval();
    encoder_->set_target({});
    return publisher_->set_pace(std::nullopt);
  }
  const double bytes_per_s = pace_of(mbit).payload_bytes_per_s;
  if (rate_) {
    rate_->set_rate(bytes_per_s);
  } else {
    rate_.emplace(RateControl::Options{.bytes_per_s = bytes_per_s, .fps = fps_});
  }
  choose_key_interval();
  publisher_->set_pace(RateControl::kPaceMargin * bytes_per_s);
}

double FrameSender::room_bytes_per_s() const {
  if (!follows_rate_ || demand_.mbit <= 0) return std::numeric_limits<double>::infinity();
  return pace_of(demand_.mbit).payload_bytes_per_s;
}

/// Has the encoder leave out what no viewer sees.
Status FrameSender::follow_views(DepthView depth_mm) {
  if (!watched_) return {};
  if (auto views = publisher_->views(); views != views_) {
    const bool was_watched = views_ != nullptr;
    views_ = std::move(views);
    watched_->watch_from(views_ ? *views_ : wire::pb::WatchedFrom());
    if (was_watched != (views_ != nullptr)) choose_key_interval();
  }
  const int frames_per_reference = demand_.base_only ? 1 : 1 << (codec_.layers - 1);
  const DepthView shown_mm = has_encoded_ ? encoder_->decoded_depth() : DepthView();
  return encoder_->set_needs(watched_->update(depth_mm, shown_mm, frames_per_reference));
}

void FrameSender::choose_key_interval() {
  const double without_rate =
      views_ ? kKeyIntervalWatched_s : codec::FrameEncoderOptions().key_interval_s;
  encoder_->set_key_interval(rate_ ? kKeyIntervalWithTarget_s : without_rate);
}

/// While layer 0 suffices, as many frames are encoded as it has.
bool FrameSender::is_left_out() {
  if (!demand_.base_only) return false;
  const int every = 1 << (codec_.layers - 1);
  return since_base_++ % every != 0;
}

void FrameSender::follow_network(double rate_share) {
  if (rate_share == rate_share_) return;
  rate_share_ = rate_share;
  encoder_->set_color_rate(static_cast<int>(codec_.color_kbit() * rate_share));
}

/// The pixels of the registered colour that are new.
MaskView FrameSender::known_colors() const {
  return registered_.color.empty() ? MaskView{} : registration_.fresh();
}

Status FrameSender::register_color(DepthView depth_mm, ColorView color) {
  if (color.pixel_count() > 0) return registration_.run(depth_mm, color, registered_);
  registered_.color = {};  // resized to nothing, it would keep its memory, and look like a picture
  registered_.seen.resize(0, 0);
  return {};
}

}  // namespace roomcast::sensor
