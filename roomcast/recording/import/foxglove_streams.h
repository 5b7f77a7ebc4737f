// SPDX-License-Identifier: Apache-2.0
// Finds the streams of pictures, the calibrations and the frames in a recording of Foxglove's
// schemas, by reading all messages once. Single-threaded.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "roomcast/recording/import/frame_tree.h"
#include "roomcast/recording/import/message_store.h"
#include "roomcast/recording/ros/messages.h"

namespace roomcast::recording {

enum class FoxglovePictures { kRaw, kCompressed, kVideo };

/// The pictures of one topic, in order of their stamps.
struct FoxgloveStream {
  std::string topic;
  FoxglovePictures pictures{};
  bool is_depth = false;
  // Of the first picture; a compressed one does not tell its size.
  std::string frame_id, encoding;
  std::uint32_t width = 0, height = 0;
  double fps = 0;  // as the file states it; 0: it does not

  std::vector<std::size_t> messages;  // in the store
  std::vector<nanoseconds> stamps;    // in the same order
  std::vector<std::size_t> keys;      // of a video: positions of pictures that need no other
};

struct FoxgloveStreams {
  std::vector<FoxgloveStream> streams;                         // with at least one picture each
  std::map<std::string, ros::CameraInfoMessage> calibrations;  // by topic: the first of each
  FrameTree frames;             // with the last transform of each frame
  std::set<std::string> moved;  // frames whose transforms differ
  bool z_is_up = true;          // in the root frame
};

/// Messages that cannot be read are left out.
[[nodiscard]] FoxgloveStreams find_foxglove_streams(MessageStore& store);

}  // namespace roomcast::recording
