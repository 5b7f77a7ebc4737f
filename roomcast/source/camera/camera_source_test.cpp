// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/camera/camera_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/source/camera/camera_fixture.h"

namespace roomcast::source {
namespace {

using std::chrono::milliseconds;

class CameraAtWork : public testing::Test {
 protected:
  std::unique_ptr<FrameSource> open(CameraSourceOptions options = {}) {
    options.log = [this](LogLevel, std::string_view sentence) {
      std::lock_guard lock(mutex_);
      said_.emplace_back(sentence);
    };
    auto source = CameraSource::open(backend_, "1", options);
    EXPECT_TRUE(source.ok()) << (source.ok() ? "" : source.error().message);
    return std::move(*source);
  }

  /// Returns the depth of the next frame; -1 at the end.
  int next(FrameSource& source) {
    const auto more = source.next(frame_, {});
    EXPECT_TRUE(more.ok());
    return *more ? frame_.depth_mm.at(0, 0) : -1;
  }

  /// Waits for `condition`, no longer than needed.
  template <class Condition>
  static bool soon(Condition condition) {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (!condition()) {
      if (std::chrono::steady_clock::now() > give_up) return false;
      std::this_thread::yield();
    }
    return true;
  }

  std::shared_ptr<ScriptedBackend> backend_ = std::make_shared<ScriptedBackend>();
  CapturedFrame frame_;
  std::mutex mutex_;
  std::vector<std::string> said_;
};

TEST_F(CameraAtWork, is_named_after_its_serial_number) {
  EXPECT_EQ(open()->description().name, "scripted-42");
}

TEST_F(CameraAtWork, frames_come_with_colour_and_a_time_on_this_host) {
  const auto source = open();
  const HostTime before = SteadyClock().now();
  backend_->show(1234);
  EXPECT_EQ(next(*source), 1234);
  EXPECT_FALSE(frame_.color.empty());
  EXPECT_GE(frame_.capture_time, before);
  EXPECT_LE(frame_.capture_time, SteadyClock().now());
}

TEST_F(CameraAtWork, a_slow_reader_gets_the_newest_frame_and_the_others_are_counted) {
  const auto source = open();
  backend_->show(1);
  EXPECT_EQ(next(*source), 1);
  backend_->show(2), backend_->show(3), backend_->show(4);
  ASSERT_TRUE(soon([&] { return source->health().frames_lost == 2; }));
  EXPECT_EQ(next(*source), 4);
}

TEST_F(CameraAtWork, frames_that_an_idle_source_is_not_asked_for_are_not_lost) {
  const auto source = open();
  source->set_idle(true);
  backend_->show(1), backend_->show(2), backend_->show(3);
  int newest = 0;
  ASSERT_TRUE(soon([&] { return (newest = next(*source)) == 3; }));
  EXPECT_EQ(source->health().frames_lost, 0U);
  source->set_idle(false);
  backend_->show(4), backend_->show(5);
  EXPECT_TRUE(soon([&] { return source->health().frames_lost == 1; }));
}

TEST_F(CameraAtWork, depth_that_finds_no_colour_is_counted) {
  const auto source = open();
  backend_->show(1, false), backend_->show(2);
  EXPECT_EQ(next(*source), 2);
  EXPECT_TRUE(soon([&] { return source->health().frames_lost == 1; }));
}

TEST_F(CameraAtWork, an_unplugged_camera_is_waited_for_and_opened_again_by_its_serial_number) {
  const auto source = open();
  backend_->unplug(true);
  backend_->fail(ErrorCode::kUnavailable);
  ASSERT_TRUE(soon([&] { return !source->health().is_connected; }));
  backend_->unplug(false);
  backend_->show(77);
  EXPECT_EQ(next(*source), 77);
  EXPECT_TRUE(source->health().is_connected);
  EXPECT_EQ(source->health().disconnect_count, 1U);
  EXPECT_THAT(backend_->opened_places(), testing::ElementsAre("port-b", "port-b"));
  std::lock_guard lock(mutex_);
  EXPECT_THAT(said_, testing::ElementsAre(testing::HasSubstr("it was unplugged"),
                                          testing::HasSubstr("back")));
}

TEST_F(CameraAtWork, a_silent_camera_counts_as_lost) {
  CameraSourceOptions options;
  options.silence = milliseconds(20);
  const auto source = open(options);
  EXPECT_TRUE(soon([&] { return source->health().disconnect_count > 0; }));
}

TEST_F(CameraAtWork, exposure_is_locked_once_after_it_has_settled) {
  CameraSourceOptions options;
  options.settings.lock_exposure = true;
  options.frames_until_lock = 3;
  const auto source = open(options);
  for (int i = 1; i <= 2; ++i) {
    backend_->show(static_cast<std::uint16_t>(i));
    EXPECT_EQ(next(*source), i);
  }
  EXPECT_EQ(backend_->times_locked(), 0);
  for (int i = 3; i <= 9; ++i) {
    backend_->show(static_cast<std::uint16_t>(i));
    EXPECT_EQ(next(*source), i);
  }
  EXPECT_EQ(backend_->times_locked(), 1);
}

TEST_F(CameraAtWork, the_last_frame_of_a_file_is_given_before_its_end) {
  const auto source = open();
  backend_->show(5);
  backend_->fail(ErrorCode::kClosed);
  EXPECT_EQ(next(*source), 5);
  EXPECT_EQ(next(*source), -1);
  EXPECT_EQ(next(*source), -1);
}

TEST_F(CameraAtWork, waiting_for_a_frame_ends_when_asked_to_stop) {
  const auto source = open();
  std::stop_source stop;
  stop.request_stop();
  const auto more = source->next(frame_, stop.get_token());
  ASSERT_TRUE(more.ok());
  EXPECT_FALSE(*more);
}

TEST_F(CameraAtWork, unsupported_settings_are_refused_before_it_is_opened) {
  CameraSourceOptions white_balance;
  white_balance.settings.lock_white_balance = true;
  const auto refused = CameraSource::open(backend_, "0", white_balance);
  EXPECT_EQ(refused.error().code, ErrorCode::kUnsupported);
  EXPECT_TRUE(backend_->opened_places().empty());
}

TEST_F(CameraAtWork, a_damaged_file_ends_with_its_reason_after_its_last_frame) {
  const auto source = open();
  backend_->show(1);
  EXPECT_EQ(next(*source), 1);
  backend_->fail(ErrorCode::kMalformed);
  for (int i = 0; i < 2; ++i) {
    const auto more = source->next(frame_, {});
    ASSERT_FALSE(more.ok());
    EXPECT_EQ(more.error().code, ErrorCode::kMalformed);
  }
  EXPECT_EQ(source->health().disconnect_count, 0U);
}

}  // namespace
}  // namespace roomcast::source
