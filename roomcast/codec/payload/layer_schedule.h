// SPDX-License-Identifier: Apache-2.0
// Decides which frames are key frames, and the temporal layer of each. Depth and colour follow the
// same schedule, so that a frame is dropped as a whole. Pure.
//
// With two layers every second frame is in layer 1. With three, every fourth is in layer 0, those
// halfway between in layer 1, the rest in layer 2. A frame of layer 1 or 2 depends only on the
// layer-0 frame before it.
#pragma once

#include <cstdint>

namespace roomcast::codec {

struct FrameRole {
  bool key = false;
  std::uint8_t layer = 0;
};

class LayerSchedule {
 public:
  /// `layers` 1..3; a key frame at least every `key_interval` frames.
  LayerSchedule(int layers, int key_interval) : layers_(layers), key_interval_(key_interval) {}

  /// From the next frame on.
  void set_layers(int layers) { layers_ = layers; }
  void set_key_interval(int frames) { key_interval_ = frames; }

  /// The first frame is a key frame.
  [[nodiscard]] FrameRole next(bool want_key) {
    if (want_key || since_key_ < 0 || since_key_ + 1 >= key_interval_) {
      since_key_ = 0;
      return {true, 0};
    }
    ++since_key_;
    int layer = layers_ - 1;
    while (layer > 0 && since_key_ % (1 << (layers_ - layer)) == 0) --layer;
    return {false, static_cast<std::uint8_t>(layer)};
  }

 private:
  int layers_, key_interval_;
  int since_key_ = -1;
};

}  // namespace roomcast::codec
