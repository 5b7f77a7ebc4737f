// SPDX-License-Identifier: Apache-2.0
// tests/cli/ros2.test.mjs lets another DDS implementation read and write.
#include "roomcast/ros2/dds/participant.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/ros2/dds/dds_fixture.h"

namespace roomcast::ros2 {
namespace {

const std::vector<std::uint8_t> kMessage = {0, 1, 0, 0, 1, 2, 3, 4};
const Topic kTopic{"/test/numbers", "std_msgs/msg/UInt32", kSensorData};

TEST(Ros2Participant, what_is_written_is_read_as_it_is) {
  const auto participant = join_test_domain();
  const auto writer = *participant->writer(kTopic);
  EXPECT_EQ(writer->reader_count(), 0);
  const auto reader = *participant->reader(kTopic);
  EXPECT_EQ(reader->take(), nullptr);
  ASSERT_TRUE(soon(*participant, [&] { return writer->reader_count() == 1; }));
  ASSERT_TRUE(writer->write(kMessage).ok());
  Message message;
  ASSERT_TRUE(soon(*participant, [&] { return (message = reader->take()) != nullptr; }));
  EXPECT_EQ(*message, kMessage);
  EXPECT_EQ(reader->take(), nullptr);
}

TEST(Ros2Participant, two_of_a_process_exchange_large_messages) {
  const auto one = join_test_domain(), other = join_test_domain();
  Topic topic = kTopic;
  topic.quality.is_reliable = true;
  const auto writer = *one->writer(topic);
  const auto reader = *other->reader(topic);
  ASSERT_TRUE(soon(*other, [&] { return writer->reader_count() == 1; }));
  std::vector<std::uint8_t> large(3 << 20);
  for (std::size_t i = 0; i < large.size(); ++i) large[i] = static_cast<std::uint8_t>(i * i >> 7);
  ASSERT_TRUE(writer->write(large).ok());
  Message message;
  ASSERT_TRUE(soon(*other, [&] { return (message = reader->take()) != nullptr; }));
  EXPECT_TRUE(*message == large);
}

TEST(Ros2Participant, who_comes_later_gets_what_is_latched) {
  const auto participant = join_test_domain();
  const Topic topic{"/test/latched", kTopic.type, kStaticTransforms};
  const auto writer = *participant->writer(topic);
  ASSERT_TRUE(writer->write({0, 1, 0, 0, 9, 9, 9, 9}).ok());
  ASSERT_TRUE(writer->write(kMessage).ok());  // replaces the one before
  const auto reader = *participant->reader(topic);
  Message message;
  ASSERT_TRUE(soon(*participant, [&] { return (message = reader->take()) != nullptr; }));
  EXPECT_EQ(*message, kMessage);
  EXPECT_EQ(reader->take(), nullptr);
}

TEST(Ros2Participant, what_cannot_be_is_a_sentence) {
  EXPECT_FALSE(Participant::open({.domain = 1000}).ok());
  const auto participant = join_test_domain();
  const auto writer = participant->writer({"no name", kTopic.type, kSensorData});
  ASSERT_FALSE(writer.ok());
  EXPECT_THAT(writer.error().message, testing::HasSubstr("not the name of a ROS 2 topic"));
  EXPECT_FALSE(participant->reader({"/", kTopic.type, kSensorData}).ok());
  const auto numbers = *participant->writer(kTopic);
  const Status status = numbers->write(std::vector<std::uint8_t>(kMaxMessageBytes + 4));
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kTooLarge);
}

}  // namespace
}  // namespace roomcast::ros2
