// SPDX-License-Identifier: Apache-2.0
// FrameSender: sends a sensor's frames to its hub: registers colour, encodes, publishes (the last
// three steps of the paper's Algorithm 1). A frame for which the network has no room is skipped
// before it is registered and encoded. It sends what the hub wants of it: its share of the room's
// uplink, or layer 0 only, and in live mode only blocks that somebody sees, and a small rendition
// beside for viewers whose lines carry no more. Threading: one thread
// calls all methods.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "roomcast/client/publisher.h"
#include "roomcast/codec/frame_codec.h"
#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/hole_registration.h"
#include "roomcast/sensor/sender/codec_choice.h"
#include "roomcast/sensor/sender/rate_control.h"
#include "roomcast/sensor/sender/small_rendition.h"
#include "roomcast/sensor/sender/watched_blocks.h"

namespace roomcast::sensor {

class FrameSender {
 public:
  /// Joins the hub. Errors: those of CodecChoice::check, of HoleRegistration::create, of the
  /// encoder's options, and of Publisher::open. With a target rate it replaces options.pace
  /// and options.estimate_uplink.
  static Result<std::unique_ptr<FrameSender>> open(client::PublisherOptions options,
                                                   const CodecChoice& codec);

  /// Sends a frame whose sizes are those of the calibration; `color` may be empty: none in this
  /// frame. Nothing: the frame was skipped (nobody watches, no connection, room time not known yet,
  /// earlier frames are unsent, or the target rate allows fewer frames). kInvalidArgument: a size
  /// is wrong. kTooLarge: the encoded frame exceeds the wire's limit; later frames may be sent.
  Result<std::optional<client::Publisher::Published>> send(DepthView depth_mm, ColorView color,
                                                           HostTime capture_time);

  [[nodiscard]] client::Publisher& publisher() { return *publisher_; }
  [[nodiscard]] const client::Publisher& publisher() const { return *publisher_; }
  /// Of the newest frame that was not skipped. Without colour in that frame, the picture is empty.
  [[nodiscard]] const RegisteredColor& registered() const { return registered_; }
  /// As FrameEncoder::decoded_depth.
  [[nodiscard]] DepthView decoded_depth() const { return encoder_->decoded_depth(); }
  /// Whether the newest frame has the finest quality there is: more bytes would not be used.
  [[nodiscard]] bool has_finest_quality() const { return has_finest_quality_; }
  /// Share of the full colour rate that the network carried at the last frame, 0 to 1.
  [[nodiscard]] double rate_share() const { return rate_share_; }

 private:
  FrameSender(HoleRegistration registration, std::unique_ptr<codec::FrameEncoder> encoder,
              const CodecChoice& codec, double fps, std::optional<RateControl> rate);
  void follow_demand();
  void follow_room_rate();
  [[nodiscard]] Status follow_views(DepthView depth_mm);
  void choose_key_interval();
  [[nodiscard]] double room_bytes_per_s() const;
  [[nodiscard]] bool is_left_out();
  void follow_network(double rate_share);
  [[nodiscard]] Status send_small(const client::Publisher::Turn& turn, DepthView depth_mm,
                                  HostTime capture_time);
  [[nodiscard]] std::uint64_t all_small_bytes() const;
  [[nodiscard]] Status register_color(DepthView depth_mm, ColorView color);
  [[nodiscard]] MaskView known_colors() const;

  HoleRegistration registration_;
  std::unique_ptr<codec::FrameEncoder> encoder_;
  const CodecChoice codec_;
  const double fps_;
  bool follows_rate_ = false;                           // the room's
  std::optional<RateControl> rate_;                     // with a target rate
  codec::FrameEncoderOptions encoding_;                 // of the full rendition, at first
  std::unique_ptr<SmallRendition> small_;               // while somebody needs it
  std::uint64_t small_bytes_ = 0;                       // of those before `small_`
  client::Publisher::Demand demand_;                    // that rate and encoder were set to
  std::optional<WatchedBlocks> watched_;                // in live mode
  std::shared_ptr<const wire::pb::WatchedFrom> views_;  // that `watched_` was set to
  bool has_encoded_ = false;
  int since_base_ = 0;  // frames of the source, while layer 0 suffices
  bool has_finest_quality_ = false;
  double rate_share_ = 1;  // the share that the encoder was set to
  RegisteredColor registered_;
  std::unique_ptr<client::Publisher> publisher_;  // last: destroyed before what it sends
};

}  // namespace roomcast::sensor
