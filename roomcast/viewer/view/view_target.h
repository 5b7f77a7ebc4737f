// SPDX-License-Identifier: Apache-2.0
// ViewTarget: a window or a picture in memory that displays the room. The room is drawn into an
// OffscreenTarget of the ViewTarget's size, then the finished picture is shown.
#pragma once

#include "roomcast/core/image.h"
#include "roomcast/render/view/offscreen_target.h"

namespace roomcast::viewer {

struct PictureSize {
  int width = 0, height = 0;  // pixels
  friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

class ViewTarget {
 public:
  virtual ~ViewTarget() = default;
  /// Size of the picture to draw now; may change between frames.
  [[nodiscard]] virtual PictureSize size() const = 0;
  /// Copies the picture; needs the GL context in which it was drawn.
  virtual void show(const render::OffscreenTarget& picture) = 0;
};

/// Keeps the last picture shown.
class PictureTarget final : public ViewTarget {
 public:
  explicit PictureTarget(PictureSize size) : size_(size) {}
  [[nodiscard]] PictureSize size() const override { return size_; }
  void show(const render::OffscreenTarget& picture) override { picture_ = picture.read_color(); }
  [[nodiscard]] const ColorImage& picture() const { return picture_; }

 private:
  PictureSize size_;
  ColorImage picture_;
};

}  // namespace roomcast::viewer
