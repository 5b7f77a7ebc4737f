// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/camera/open_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/source/camera/camera_fixture.h"

namespace roomcast::source {
namespace {

const std::vector<CameraInfo> kTwo = {{"port-a", "Camera", "A003"}, {"port-b", "Camera", ""}};

TEST(ChooseCamera, by_position_serial_number_or_place) {
  EXPECT_EQ(choose_camera(kTwo, "x", "")->place, "port-a");
  EXPECT_EQ(choose_camera(kTwo, "x", "1")->place, "port-b");
  EXPECT_EQ(choose_camera(kTwo, "x", "A003")->place, "port-a");
  EXPECT_EQ(choose_camera(kTwo, "x", "port-b")->place, "port-b");
}

TEST(ChooseCamera, an_error_for_a_missing_one_lists_those_present) {
  for (const char* place : {"2", "A004", "port-c", "-1", "0x0"}) {
    const auto chosen = choose_camera(kTwo, "x", place);
    ASSERT_FALSE(chosen.ok()) << place;
    EXPECT_EQ(chosen.error().code, ErrorCode::kNotFound);
    EXPECT_THAT(chosen.error().message, testing::HasSubstr("A003, port-b"));
  }
  EXPECT_THAT(choose_camera({}, "x", "").error().message, testing::HasSubstr("was found"));
}

/// A camera whose library refuses to open it.
class Stubborn final : public ScriptedBackend {
 public:
  [[nodiscard]] Result<std::vector<CameraInfo>> list() override {
    return std::vector<CameraInfo>{
        {"port-a", "Camera", "1", Error{ErrorCode::kUnavailable, "it is in a USB 2 port"}}};
  }
  [[nodiscard]] Result<std::unique_ptr<Camera>> open(const CameraInfo&,
                                                     const CameraSettings&) override {
    return Error{ErrorCode::kUnavailable, "error -3"};
  }
};

TEST(OpenCamera, errors_state_the_cause_instead_of_the_librarys_message) {
  Stubborn backend;
  EXPECT_EQ(open_camera(backend, "", {}).error().message, "it is in a USB 2 port");
}

TEST(OpenCamera, contradicting_settings_are_refused_before_anything_is_opened) {
  ScriptedBackend backend;
  const auto opened = open_camera(backend, "", {.trigger_delay = std::chrono::microseconds(160)});
  EXPECT_EQ(opened.error().code, ErrorCode::kInvalidArgument);
  EXPECT_TRUE(backend.opened_places().empty());
}

}  // namespace
}  // namespace roomcast::source
