// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/bundle_message.h"

#include <cmath>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/room_fixture.h"
#include "roomcast/wire/limits.h"

namespace roomcast::alignment {
namespace {

alignment::CalibrationBundle some_bundle() {
  auto bundle = alignment::bundle_fixture({}, "s0", alignment::corner_pose(2, 1.5));
  bundle.moving = MaskImage(bundle.depth_mm.width(), bundle.depth_mm.height());
  bundle.moving.at(7, 5) = 255;
  bundle.up.emplace(0, -1, 0);
  return bundle;
}

TEST(BundleMessage, what_was_seen_arrives) {
  const auto sent = some_bundle();
  const auto message = message_from_bundle(sent);
  ASSERT_TRUE(message.ok()) << message.error().message;
  EXPECT_LT(message->ByteSizeLong(), wire::kMaxBundleBytes);
  const auto received = bundle_from_message(*message, "s0", sent.calibration);
  ASSERT_TRUE(received.ok()) << received.error().message;
  EXPECT_EQ(received->name, "s0");
  EXPECT_EQ(received->depth_mm, sent.depth_mm);
  EXPECT_EQ(received->moving, sent.moving);
  EXPECT_EQ(received->up, sent.up);
  double error = 0;
  for (std::size_t i = 0; i < sent.color.view().pixel_count(); ++i) {
    error += std::abs(received->color.data()[i].g - sent.color.data()[i].g);
  }
  EXPECT_LT(error / static_cast<double>(sent.color.view().pixel_count()), 3);
}

TEST(BundleMessage, a_bundle_of_no_use_is_not_sent) {
  auto dark = some_bundle();
  dark.color = ColorImage(dark.color.width(), dark.color.height());
  EXPECT_FALSE(message_from_bundle(dark).ok());
}

TEST(BundleMessage, damaged_pictures_are_refused) {
  const auto sent = some_bundle();
  const auto message = *message_from_bundle(sent);
  auto no_color = message;
  no_color.clear_color_jpeg();
  EXPECT_FALSE(bundle_from_message(no_color, "s0", sent.calibration).ok());
  auto no_depth = message;
  no_depth.set_depth("nonsense");
  EXPECT_FALSE(bundle_from_message(no_depth, "s0", sent.calibration).ok());
  auto other_size = sent.calibration;
  other_size.depth.width += 8;
  EXPECT_FALSE(bundle_from_message(message, "s0", other_size).ok());
}

}  // namespace
}  // namespace roomcast::alignment
