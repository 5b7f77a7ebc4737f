// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/color/vp9_color_decoder.h"
#include "roomcast/codec/depth_section_decoder.h"
#include "roomcast/codec/frame_codec.h"
#include "roomcast/codec/mask/color_mask.h"
#include "roomcast/codec/payload/payload_sections.h"

namespace roomcast::codec {
namespace {

/// Does not reallocate an image that already has the size.
template <class T>
void make_size(Image<T>& image, int width, int height) {
  if (image.width() != width || image.height() != height) image.resize(width, height);
}

class SectionFrameDecoder final : public FrameDecoder {
 public:
  SectionFrameDecoder(int width, int height) : width_(width), height_(height) {}

  Status decode(std::span<const std::uint8_t> payload, DecodedFrame& out) override {
    const auto sections = parse_sections(payload, width_, height_);
    if (!sections.ok()) return sections.error();
    make_size(out.depth_mm, width_, height_);
    if (Status s = depth_.decode(*sections, out.depth_mm.view()); !s.ok()) return s;
    if (!sections->has_color) {
      out.color.resize(0, 0);
      out.color_seen.resize(0, 0);
      return {};
    }
    if (Status s = decode_color(sections->color, out.color); !s.ok()) return s;
    make_size(out.color_seen, width_, height_);
    return mask_.decode(sections->mask_codec, sections->color_mask, out.depth_mm,
                        out.color_seen.view());
  }

 private:
  Status decode_color(std::span<const std::uint8_t> frame, ColorImage& color) {
    if (color_ == nullptr) {
      auto created = Vp9ColorDecoder::create(width_, height_);
      if (!created.ok()) return created.error();
      color_ = std::move(*created);
    }
    return color_->decode(frame, color);
  }

  const int width_, height_;
  DepthSectionDecoder depth_;
  ColorMaskDecoder mask_;
  std::unique_ptr<Vp9ColorDecoder> color_;  // created with the first colour section
};

}  // namespace

Result<std::unique_ptr<FrameDecoder>> FrameDecoder::create(int width, int height) {
  if (!is_grid_side(width) || !is_grid_side(height)) {
    return invalid_argument("A depth grid is 16..4096 pixels wide and high.");
  }
  return std::unique_ptr<FrameDecoder>(std::make_unique<SectionFrameDecoder>(width, height));
}

}  // namespace roomcast::codec
