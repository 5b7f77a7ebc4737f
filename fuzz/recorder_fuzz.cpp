// SPDX-License-Identifier: Apache-2.0
// Records what a hub says, whatever that is, as a recorder does: the file can be read to its end,
// has every frame that was counted, and nothing else.
#include <cstdint>
#include <filesystem>
#include <string>

#include <unistd.h>

#include "fuzz/hub_messages.h"
#include "roomcast/recording/room/recording_cursor.h"
#include "roomcast/recording/room/room_recording.h"
#include "roomcast/recording/room/room_recording_writer.h"
#include "roomcast/wire/control.h"
#include "roomcast/wire/frame_header.h"

namespace {

using namespace roomcast;
using recording::RoomRecordingWriter;

constexpr nanoseconds kBegin{1'700'000'000'000'000'000}, kBetween{40'000'000};

void record(RoomRecordingWriter& writer, fuzz::Bytes message, nanoseconds log_time) {
  const auto type = wire::message_type(message);
  if (type && *type == wire::MessageType::kFrame) {
    if (!writer.add_frame(message, log_time)) __builtin_trap();
    return;
  }
  const auto control = wire::decode_control(message, wire::Sender::kHub);
  if (!control) return;
  Status written;
  if (control->has_roster()) written = writer.add_roster(control->roster(), log_time);
  if (control->has_viewer_poses()) written = writer.add_poses(control->viewer_poses(), log_time);
  if (!written) __builtin_trap();
}

/// Returns the number of frames.
std::uint64_t write(const std::filesystem::path& path, fuzz::Bytes input) {
  auto writer = RoomRecordingWriter::create(path, "room");
  if (!writer) __builtin_trap();
  nanoseconds now = kBegin;
  if (!writer->add_clock({kBegin, nanoseconds(1000)}, now)) __builtin_trap();
  for (const fuzz::Bytes message : fuzz::hub_messages(input)) {
    record(*writer, message, now);
    now += kBetween;
    if (!writer->close_old_chunk(now)) __builtin_trap();
  }
  if (!writer->finish()) __builtin_trap();
  return writer->frames();
}

void read_back(const std::filesystem::path& path, std::uint64_t frames) {
  const auto recording = recording::RoomRecording::open(path);
  if (!recording || recording->damage()) __builtin_trap();
  recording::RecordingCursor cursor(*recording);
  recording::RecordedMessage message;
  std::uint64_t count = 0;
  for (;;) {
    const auto more = cursor.next(message);
    if (!more) __builtin_trap();
    if (!*more) break;
    count += message.kind == recording::MessageKind::kFrame;
  }
  if (count != frames) __builtin_trap();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path path =
      std::filesystem::temp_directory_path() /
      ("roomcast_recorder_fuzz_" + std::to_string(::getpid()) + ".mcap");
  std::filesystem::remove(path);
  read_back(path, write(path, {data, size}));
  std::filesystem::remove(path);
  return 0;
}
