// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/sensor_feed.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "roomcast/client/publisher.h"
#include "roomcast/core/depth_factor.h"
#include "roomcast/sensor/bundle_monitor.h"
#include "roomcast/sensor/coarse_depth.h"
#include "roomcast/sensor/frame_log.h"
#include "roomcast/sensor/hole_completion.h"
#include "roomcast/sensor/instant_reporter.h"
#include "roomcast/sensor/interference_filter.h"
#include "roomcast/sensor/preview.h"
#include "roomcast/sensor/sender/frame_sender.h"
#include "roomcast/sensor/sighting_detector.h"
#include "roomcast/wire/limits.h"
#include "roomcast/wire/sighting_request.h"

namespace roomcast::sensor {
namespace {

constexpr std::chrono::seconds kHealthInterval(2);
/// Between frames while nobody watches: as often as moves of the sensor are looked for.
constexpr std::chrono::milliseconds kIdleInterval = alignment::kCheckInterval;

client::PublisherOptions publisher_options(const source::SensorDescription& sensor,
                                           const SensorFeedOptions& feed) {
  client::PublisherOptions options;
  options.hub_url = feed.hub_url;
  options.room = feed.room;
  options.credential = feed.credential;
  options.name = feed.name.empty() ? sensor.name : feed.name;
  options.calibration = sensor.calibration;
  if (feed.send_pose) options.world_from_depth = sensor.world_from_depth;
  options.fps = sensor.fps;
  options.send_unwatched = feed.send_unwatched;
  options.follows_rate = feed.follows_rate;
  options.wait_for_hub = feed.wait_for_hub;
  options.log = feed.log;
  options.stop = feed.stop;
  options.settings = feed.settings;
  options.on_settings_request = feed.on_settings_request;
  options.on_token = feed.on_token;
  return options;
}

}  // namespace

class SensorFeed::Worker {
 public:
  Worker(std::unique_ptr<source::FrameSource> source, std::unique_ptr<FrameSender> sender,
         std::unique_ptr<sound::Microphone> microphone, const SensorFeedOptions& options,
         std::optional<FrameLog> frame_log)
      : source_(std::move(source)),
        log_(options.log),
        bundle_(source_->description().name, source_->description().calibration),
        interference_(source_->description().fps),
        filters_interference_(options.filter_interference &&
                              options.codec.depth_mode == codec::DepthMode::kLive),
        frame_log_(std::move(frame_log)),
        sender_(std::move(sender)) {
    if (!options.preview.empty()) preview_.emplace(options.preview);
    if (options.fill_holes && options.codec.depth_mode == codec::DepthMode::kLive)
      completion_.emplace(source_->description().calibration);
    if (microphone)
      microphone_.emplace(std::move(microphone), options.microphone, sender_->publisher(), log_);
  }

  void run(const std::stop_token& stop) {
    Status status;
    while (status && !stop.stop_requested()) {
      rest_while_unwanted(stop);
      auto more = source_->next(captured_, stop);
      if (!more) {
        status = more.error();
      } else if (!*more) {
        break;
      } else {
        correct_depth();
        report_place();
        if (sender_->publisher().frames_wanted()) status = process_captured();
        if (status) show_preview();
      }
      if (auto failure = sender_->publisher().failure()) status = *failure;
    }
    std::lock_guard lock(mutex_);
    result_ = std::move(status);
  }

  void answer(std::uint32_t number, const std::string& refusal) {
    wire::pb::Control message;
    message.mutable_settings_answer()->set_number(number);
    message.mutable_settings_answer()->set_refusal(refusal);
    sender_->publisher().send(std::move(message));
  }

  SensorFeedStats stats() const {
    const client::PublisherStats sent = sender_->publisher().stats();
    const client::Publisher::Demand demand = sender_->publisher().demand();
    std::lock_guard lock(mutex_);
    return {
        sent.frames_sent,
        sent.frames_skipped,
        sent.bytes_sent,
        demand.is_watched,
        demand.is_watched && demand.is_seen,
        demand.mbit,
        source_->health(),
        figures_,
        net::line_mbit_per_s(sender_->publisher().uplink().value_or(client::Uplink()).bytes_per_s),
        microphone_ ? std::optional(microphone_->stats()) : std::nullopt,
        has_finest_quality_};
  }
  std::optional<Status> result() const {
    std::lock_guard lock(mutex_);
    return result_;
  }

 private:
  /// Whether a few frames suffice: nobody receives them, and the aligner has, or cannot get, what
  /// it needs to place this sensor.
  bool may_idle() const {
    const client::Publisher& publisher = sender_->publisher();
    if (publisher.frames_wanted() || !has_tried_bundle_) return false;
    return !wire::wants_any(publisher.wanted_sightings());
  }

  /// Waits until the next frame is needed.
  void rest_while_unwanted(const std::stop_token& stop) {
    const bool is_idle = may_idle();
    if (std::exchange(is_idle_, is_idle) != is_idle) source_->set_idle(is_idle);
    if (is_idle) sender_->publisher().wait_until_wanted(kIdleInterval, stop);
  }

  Status process_captured() {
    watch_interference();
    if (completion_) completion_->complete(captured_.depth_mm, captured_.color);
    return send_captured();
  }

  /// Sends a new bundle, a move of the sensor, and sightings.
  void report_place() {
    auto news = bundle_.add(captured_);
    if (!news || news->bundle) has_tried_bundle_ = true;
    if (!news) return complain(news.error().message);
    if (news->moved) {
      has_tried_bundle_ = false;
      sender_->publisher().report_moved();
      if (log_) log_(LogLevel::kInfo, "this sensor was moved");
    }
    if (news->bundle) sender_->publisher().send_bundle(*std::move(news->bundle));
    if (news->moved || news->bundle) stand(bundle_.bundle());
    report_sightings();
    if (sender_->publisher().demand().is_watched) report_coarse_depth();
  }

  void report_coarse_depth() {
    auto coarse = coarse_depth_.add(captured_.depth_mm, captured_.capture_time);
    if (!coarse) return;
    wire::pb::Control message;
    *message.mutable_coarse_depth() = *std::move(coarse);
    sender_->publisher().send(std::move(message));
  }

  void report_sightings() {
    sighting_detector_.want(sender_->publisher().wanted_sightings());
    const auto taken = sender_->publisher().room_time(captured_.capture_time);
    if (!taken) return;
    if (auto sightings = sighting_detector_.add(captured_, *taken)) {
      wire::pb::Control message;
      *message.mutable_sightings() = *std::move(sightings);
      sender_->publisher().send(std::move(message));
    }
    if (!sender_->publisher().wanted_sightings().instants()) return;
    if (auto instant = instants_.add(captured_.depth_mm, *taken)) {
      instant->set_depth_scale(depth_scale_);
      wire::pb::Control message;
      *message.mutable_depth_instant() = *std::move(instant);
      sender_->publisher().send(std::move(message));
    }
  }

  /// Multiplies the readings by the factor that the hub has told. A new factor means a new bundle.
  void correct_depth() {
    const double factor = sender_->publisher().depth_scale().value_or(depth_scale_);
    if (factor != depth_scale_) {
      depth_scale_ = factor;
      const source::SensorDescription& sensor = source_->description();
      bundle_ = BundleMonitor(sensor.name, sensor.calibration, factor);
      has_tried_bundle_ = false;
      stand({});
      if (log_)
        log_(LogLevel::kInfo,
             fmt::format("this sensor's depth is multiplied by {:.3f}, by which the room's sensors "
                         "agree",
                         factor));
    }
    if (depth_scale_ != 1) multiply_depth(captured_.depth_mm.view(), depth_scale_);
  }

  void stand(const std::optional<alignment::CalibrationBundle>& bundle) {
    sighting_detector_.stand(bundle);
    instants_.stand(bundle ? bundle->depth_mm : DepthImage());
  }

  /// Measures how much other sensors disturb this one, and removes what can be removed.
  void watch_interference() {
    if (filters_interference_) {
      interference_.filter(captured_.depth_mm);
    } else {
      interference_.measure(captured_.depth_mm);
    }
    const InterferenceFigures figures = interference_.figures();
    if (!figures.is_known || captured_.capture_time < next_health_) return;
    next_health_ = captured_.capture_time + kHealthInterval;
    wire::pb::Control message;
    wire::pb::SensorHealth& health = *message.mutable_sensor_health();
    health.set_flickering(static_cast<float>(figures.flickering));
    health.set_noise_ratio(std::min(static_cast<float>(figures.noise_ratio), wire::kMaxNoiseRatio));
    sender_->publisher().send(std::move(message));
    std::lock_guard lock(mutex_);
    figures_ = figures;
  }

  /// Logs a reason unless it is the same as the last one.
  void complain(const std::string& reason) {
    if (reason == complaint_) return;
    complaint_ = reason;
    if (log_) log_(LogLevel::kWarning, "this sensor cannot be aligned: " + reason);
  }

  Status send_captured() {
    const auto sent = sender_->send(captured_.depth_mm, captured_.color, captured_.capture_time);
    const bool too_large = !sent && sent.error().code == ErrorCode::kTooLarge;
    const bool was_too_large = std::exchange(too_large_, too_large);
    if (too_large) {  // its sentence has the number of bytes, which differs in every frame
      if (!was_too_large && log_) log_(LogLevel::kWarning, sent.error().message);
      return {};
    }
    if (!sent) return sent.error();
    {
      const std::lock_guard lock(mutex_);
      has_finest_quality_ = sender_->has_finest_quality();
    }
    if (*sent && frame_log_) {
      const auto logged =
          frame_log_->add((*sent)->seq, (*sent)->capture_time, sender_->decoded_depth());
      if (!logged) end_frame_log(logged.error());
    }
    return {};
  }

  /// A log with gaps would be worse than none.
  void end_frame_log(const Error& reason) {
    frame_log_.reset();
    if (log_) log_(LogLevel::kWarning, "the log of frames ends here: " + reason.message);
  }

  /// Shows the current depth and the last registered colour, which is stale while no frames can be
  /// sent.
  void show_preview() {
    if (!preview_) return;
    const Status shown =
        preview_->show(captured_.depth_mm, sender_->registered().color, SteadyClock().now());
    if (shown || preview_failed_) return;
    preview_failed_ = true;
    if (log_) log_(LogLevel::kWarning, "no preview: " + shown.error().message);
  }

  std::unique_ptr<source::FrameSource> source_;
  const LogSink log_;
  BundleMonitor bundle_;
  bool has_tried_bundle_ = false;  // since it joined, or was moved
  bool is_idle_ = false;
  double depth_scale_ = 1;  // factor on the camera's readings, by which frames are multiplied
  SightingDetector sighting_detector_;
  InstantReporter instants_;
  CoarseDepthReporter coarse_depth_;
  std::string complaint_;   // the last reason that was logged
  bool too_large_ = false;  // the last frame was
  InterferenceFilter interference_;
  const bool filters_interference_;
  HostTime next_health_{};
  std::optional<HoleCompletion> completion_;
  std::optional<FrameLog> frame_log_;
  std::optional<Preview> preview_;
  bool preview_failed_ = false;
  std::unique_ptr<FrameSender> sender_;
  std::optional<RoomMicrophone> microphone_;
  source::CapturedFrame captured_;  // reused for every frame

  mutable std::mutex mutex_;
  std::optional<Status> result_;
  InterferenceFigures figures_;
  bool has_finest_quality_ = false;
};

SensorFeed::SensorFeed(std::unique_ptr<Worker> worker) : worker_(std::move(worker)) {
  thread_ = std::jthread([this](const std::stop_token& stop) { worker_->run(stop); });
}

SensorFeed::~SensorFeed() {
  thread_.request_stop();
  thread_.join();
}

Result<std::unique_ptr<SensorFeed>> SensorFeed::start(std::unique_ptr<source::FrameSource> source,
                                                      SensorFeedOptions options) {
  const source::SensorDescription sensor = source->description();
  std::optional<FrameLog> frame_log;
  if (options.frame_log) {
    auto opened =
        FrameLog::open(*options.frame_log, options.append_to_frame_log ? FrameLog::Start::kAppended
                                                                       : FrameLog::Start::kAnew);
    if (!opened) return opened.error();
    frame_log = std::move(*opened);
  }
  std::unique_ptr<sound::Microphone> microphone;
  if (options.microphone) {
    auto opened = options.microphone();
    if (!opened) return opened.error();
    microphone = *std::move(opened);
  }
  auto sender = FrameSender::open(publisher_options(sensor, options), options.codec);
  if (!sender) return sender.error();
  auto worker = std::make_unique<Worker>(std::move(source), std::move(*sender),
                                         std::move(microphone), options, std::move(frame_log));
  return std::unique_ptr<SensorFeed>(new SensorFeed(std::move(worker)));
}

SensorFeedStats SensorFeed::stats() const {
  return worker_->stats();
}
void SensorFeed::answer(std::uint32_t number, const std::string& refusal) {
  worker_->answer(number, refusal);
}
std::optional<Status> SensorFeed::result() const {
  return worker_->result();
}

}  // namespace roomcast::sensor
