// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/measure/static_room.h"

#include <gtest/gtest.h>

namespace roomcast::recording {
namespace {

/// A wall 2 m away; in two of five frames a person is in front of it.
class PassedBy final : public FrameSetReader {
 public:
  explicit PassedBy(std::vector<bool> placed) : placed_(std::move(placed)) {
    const CameraIntrinsics camera = {
        .width = 16, .height = 16, .fx = 16, .fy = 16, .cx = 8, .cy = 8};
    for (std::size_t i = 0; i < placed_.size(); ++i)
      sensors_.push_back({"s" + std::to_string(i), camera, 10, 0.02});
  }
  const std::vector<SetSensor>& sensors() const override { return sensors_; }
  nanoseconds length() const override { return {}; }
  Result<bool> next(FrameSet& set) override {
    if (count_ == 5) return false;
    set.number = count_++;
    set.frames.clear();
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      auto pictures = std::make_shared<codec::DecodedFrame>();
      pictures->depth_mm = DepthImage(16, 16, set.number % 2 == 1 ? 900 : 2000);
      SetFrame frame{i, std::move(pictures), {}, {}};
      if (placed_[i]) frame.world_from_depth = RigidTransform();
      set.frames.push_back(std::move(frame));
    }
    return true;
  }

 private:
  std::vector<bool> placed_;
  std::vector<SetSensor> sensors_;
  std::uint64_t count_ = 0;
};

TEST(StaticRoom, people_passing_by_are_not_part_of_it) {
  PassedBy reader({true, true});
  const auto room = gather_static_room(reader);
  ASSERT_TRUE(room.ok());
  ASSERT_EQ(room->size(), 2u);
  EXPECT_EQ((*room)[1].depth_mm.at(5, 5), 2000);
  EXPECT_EQ((*room)[1].frame_count, 5u);
  EXPECT_EQ((*room)[1].expected_error_m, 0.02);
}

TEST(StaticRoom, sensors_without_a_place_are_left_out_unless_there_is_but_one) {
  PassedBy one_of_two({true, false});
  EXPECT_EQ(gather_static_room(one_of_two)->size(), 1u);
  PassedBy alone({false});
  EXPECT_EQ(gather_static_room(alone)->size(), 1u);
  PassedBy lost({false, false});
  EXPECT_EQ(gather_static_room(lost).error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace roomcast::recording
