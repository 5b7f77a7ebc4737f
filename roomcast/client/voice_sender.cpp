// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/voice_sender.h"

#include <utility>

#include "roomcast/wire/audio_header.h"

namespace roomcast::client {

void VoiceSender::joined() {
  lost();
  seq_ = 0;
}

void VoiceSender::lost() {
  clock_.reset();
  waiting_.clear();
}

void VoiceSender::say(std::span<const std::uint8_t> opus, bool ends, HostTime first_sample) {
  if (!clock_) return;
  net::MessageBuffer message;
  message.appendable().resize(net::MessageBuffer::kHeadroom + wire::kAudioHeaderBytes);
  message.append(opus);
  wire::AudioHeader header;
  header.ends = ends;
  header.seq = seq_++;
  header.capture_time = clock_->room_time(first_sample);
  header.payload_length = static_cast<std::uint16_t>(opus.size());
  wire::write_audio_header(header, message.payload().first<wire::kAudioHeaderBytes>());
  if (waiting_.size() == kMaxWaiting) waiting_.pop_front();
  waiting_.push_back(net::frame_message(std::move(message)));
}

net::FramedMessagePtr VoiceSender::next() {
  if (waiting_.empty()) return nullptr;
  auto message = std::move(waiting_.front());
  waiting_.pop_front();
  return message;
}

}  // namespace roomcast::client
