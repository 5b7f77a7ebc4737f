// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/control.h"

#include <algorithm>
#include <string_view>

#include <gtest/gtest.h>

#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/limits.h"

namespace roomcast::wire {
namespace {

pb::Control ping(std::uint64_t client_ns) {
  pb::Control control;
  control.mutable_clock_ping()->set_client_ns(client_ns);
  return control;
}

std::vector<std::uint8_t> message_of(const pb::Control& control) {
  std::vector<std::uint8_t> message;
  encode_control(control, message);
  return message;
}

TEST(Control, decoding_reverses_encoding) {
  const auto message = message_of(ping(77));
  EXPECT_EQ(*message_type(message), MessageType::kControl);
  const auto control = decode_control(message, Sender::kClient);
  ASSERT_TRUE(control.ok()) << control.error().message;
  EXPECT_EQ(control->clock_ping().client_ns(), 77u);
}

TEST(Control, encoding_appends_to_the_buffer) {
  std::vector<std::uint8_t> bytes = {1, 2, 3};
  encode_control(ping(1), bytes);
  EXPECT_EQ(bytes[0], 1);
  EXPECT_TRUE(decode_control(std::span(bytes).subspan(3), Sender::kClient).ok());
}

TEST(Control, a_message_kind_of_a_later_version_has_no_content) {
  auto message = message_of(ping(1));
  message.resize(kPreambleBytes);
  message.insert(message.end(), {0xBA, 0x3E, 0x00});  // field 999, length-delimited, empty
  const auto control = decode_control(message, Sender::kHub);
  ASSERT_TRUE(control.ok());
  EXPECT_EQ(control->message_case(), pb::Control::MESSAGE_NOT_SET);
}

TEST(Control, truncated_protobuf_is_refused) {
  auto message = message_of(ping(1));
  message.pop_back();
  const auto control = decode_control(message, Sender::kClient);
  ASSERT_FALSE(control.ok());
  EXPECT_EQ(control.error().code, ErrorCode::kMalformed);
}

TEST(Control, invalid_bytes_bring_no_lines_of_the_library) {
  testing::internal::CaptureStderr();
  pb::Control control;
  control.mutable_join()->set_name("name");
  std::vector<std::uint8_t> bytes;
  encode_control(control, bytes);
  const auto name = std::ranges::search(bytes, std::string_view("name"));
  ASSERT_FALSE(name.empty());
  name.front() = 0xff;  // no UTF-8
  EXPECT_FALSE(decode_control(bytes, Sender::kClient).ok());
  control.mutable_join()->set_name("\xff");
  encode_control(control, bytes);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Control, a_frame_is_not_a_control_message) {
  std::vector<std::uint8_t> message(kFrameHeaderBytes);
  write_frame_header({}, std::span(message).first<kFrameHeaderBytes>());
  EXPECT_FALSE(decode_control(message, Sender::kClient).ok());
}

TEST(Control, clients_may_say_less_than_the_hub) {
  pb::Control control;
  control.mutable_error()->set_sentence(std::string(kMaxControlFromClientBytes, 'x'));
  const auto message = message_of(control);
  const auto from_client = decode_control(message, Sender::kClient);
  ASSERT_FALSE(from_client.ok());
  EXPECT_EQ(from_client.error().code, ErrorCode::kTooLarge);
  EXPECT_TRUE(decode_control(message, Sender::kHub).ok());
}

TEST(Control, the_hub_has_a_limit_too) {
  pb::Control control;
  control.mutable_error()->set_sentence(std::string(kMaxControlFromHubBytes, 'x'));
  EXPECT_FALSE(decode_control(message_of(control), Sender::kHub).ok());
}

TEST(Control, only_bundles_are_large_and_only_for_sensors_and_aligners) {
  pb::Control bundle;
  bundle.mutable_calibration_bundle()->set_depth(std::string(kMaxControlFromHubBytes, 'x'));
  EXPECT_TRUE(decode_control(message_of(bundle), Sender::kSensor).ok());
  EXPECT_TRUE(decode_control(message_of(bundle), Sender::kHubToAligner).ok());
  EXPECT_FALSE(decode_control(message_of(bundle), Sender::kClient).ok());
  EXPECT_FALSE(decode_control(message_of(bundle), Sender::kHub).ok());
  pb::Control other;
  other.mutable_error()->set_sentence(std::string(kMaxControlFromHubBytes, 'x'));
  EXPECT_FALSE(decode_control(message_of(other), Sender::kSensor).ok());
  bundle.mutable_calibration_bundle()->set_depth(std::string(kMaxBundleBytes, 'x'));
  EXPECT_FALSE(decode_control(message_of(bundle), Sender::kSensor).ok());
}

}  // namespace
}  // namespace roomcast::wire
