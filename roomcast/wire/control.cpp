// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/control.h"

#include <cmath>
#include <string>

#include "roomcast/core/assert.h"
#include "roomcast/wire/control_check.h"
#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/limits.h"
#include "roomcast/wire/parse_message.h"

namespace roomcast::wire {
namespace {

std::size_t max_bytes(Sender sender) {
  switch (sender) {
    case Sender::kClient:
      return kMaxControlFromClientBytes;
    case Sender::kHub:
      return kMaxControlFromHubBytes;
    case Sender::kSensor:
    case Sender::kHubToAligner:
      return kMaxBundleBytes;
  }
  return 0;
}

}  // namespace

void encode_control(const pb::Control& control, std::vector<std::uint8_t>& out) {
  const std::size_t begin = out.size();
  const std::size_t body_bytes = control.ByteSizeLong();
  out.resize(begin + kPreambleBytes + body_bytes);
  const google::protobuf::LogSilencer silence;  // as parse_message
  write_preamble(MessageType::kControl, std::span(out).subspan(begin).first<kPreambleBytes>());
  control.SerializeWithCachedSizesToArray(out.data() + begin + kPreambleBytes);
}

Result<pb::Control> decode_control(std::span<const std::uint8_t> message, Sender sender) {
  const auto type = message_type(message);
  if (!type) return type.error();
  if (*type != MessageType::kControl)
    return Error{ErrorCode::kMalformed, "this is not a control message"};
  const std::size_t limit = max_bytes(sender);
  if (message.size() > limit) {
    return Error{ErrorCode::kTooLarge,
                 "a control message is at most " + std::to_string(limit) + " bytes"};
  }
  const auto body = message.subspan(kPreambleBytes);
  pb::Control control;
  if (!parse_message(body, control)) {
    return Error{ErrorCode::kMalformed, "a control message is not valid Protobuf"};
  }
  if (message.size() > kMaxControlFromHubBytes && !control.has_calibration_bundle()) {
    return Error{ErrorCode::kTooLarge, "only a calibration bundle may be this large"};
  }
  if (auto status = check_control(control); !status) return status.error();
  return control;
}

}  // namespace roomcast::wire
