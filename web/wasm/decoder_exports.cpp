// SPDX-License-Identifier: Apache-2.0
// The exports of roomcast_codec.wasm. README.md in this folder describes their use from JavaScript.
// Colour is not decoded here: the page passes the payload's VP9 frame to WebCodecs.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "roomcast/codec/color/vp9_header.h"
#include "roomcast/codec/depth_section_decoder.h"
#include "roomcast/codec/mask/color_mask.h"
#include "roomcast/codec/payload/payload_sections.h"

#define ROOMCAST_EXPORT(name) __attribute__((export_name(name)))

namespace {

using namespace roomcast;         // NOLINT: this file is nothing but glue
using namespace roomcast::codec;  // NOLINT

enum ReturnCode : int { kOk = 0, kMalformed = 1, kUnsupported = 2 };

struct Decoder {
  int width = 0, height = 0;
  std::vector<std::uint8_t> payload;
  DepthImage depth;
  MaskImage mask;
  DepthSectionDecoder depth_decoder;
  ColorMaskDecoder mask_decoder;
  bool has_color = false, color_is_key = false;
  std::uint32_t color_offset = 0, color_length = 0;
  std::string error;
};

int failed(Decoder& decoder, const Error& error) {
  decoder.error = error.message;
  return error.code == ErrorCode::kUnsupported ? kUnsupported : kMalformed;
}

Status take_color(Decoder& decoder, const PayloadSections& sections) {
  const auto header = parse_vp9_header(sections.color);
  if (!header.ok()) return header.error();
  if (header->width != 0 && (header->width != decoder.width || header->height != decoder.height)) {
    return malformed("The colour is not of the sensor's size.");
  }
  const Status mask = decoder.mask_decoder.decode(sections.mask_codec, sections.color_mask,
                                                  decoder.depth, decoder.mask.view());
  if (!mask.ok()) return mask;
  decoder.has_color = true;
  decoder.color_is_key = header->key;
  decoder.color_offset = static_cast<std::uint32_t>(sections.color.data() - decoder.payload.data());
  decoder.color_length = static_cast<std::uint32_t>(sections.color.size());
  return {};
}

Status decode(Decoder& decoder, std::size_t length) {
  decoder.has_color = false;
  const auto payload = std::span<const std::uint8_t>(decoder.payload).first(length);
  const auto sections = parse_sections(payload, decoder.width, decoder.height);
  if (!sections.ok()) return sections.error();
  const Status depth = decoder.depth_decoder.decode(*sections, decoder.depth.view());
  if (!depth.ok() || !sections->has_color) return depth;
  return take_color(decoder, *sections);
}

}  // namespace

extern "C" {

ROOMCAST_EXPORT("decoder_create") Decoder* decoder_create(int width, int height) {
  if (!is_grid_side(width) || !is_grid_side(height)) return nullptr;
  auto decoder = std::make_unique<Decoder>();
  decoder->width = width;
  decoder->height = height;
  decoder->depth.resize(width, height);
  decoder->mask.resize(width, height);
  decoder->payload.resize(1);  // so that data() is not null even for an empty payload
  return decoder.release();
}

ROOMCAST_EXPORT("decoder_destroy") void decoder_destroy(Decoder* decoder) {
  std::unique_ptr<Decoder> owned(decoder);
}

ROOMCAST_EXPORT("decoder_input")
std::uint8_t* decoder_input(Decoder* decoder, std::uint32_t length) {
  if (length > max_payload_length(decoder->width, decoder->height)) return nullptr;
  if (decoder->payload.size() < length) decoder->payload.resize(length);
  return decoder->payload.data();
}

ROOMCAST_EXPORT("decoder_decode") int decoder_decode(Decoder* decoder, std::uint32_t length) {
  if (length > decoder->payload.size()) {
    return failed(*decoder, malformed("More bytes than were asked room for."));
  }
  const Status status = decode(*decoder, length);
  return status.ok() ? kOk : failed(*decoder, status.error());
}

ROOMCAST_EXPORT("decoder_depth") const std::uint16_t* decoder_depth(const Decoder* decoder) {
  return decoder->depth.data();
}

ROOMCAST_EXPORT("decoder_mask") const std::uint8_t* decoder_mask(const Decoder* decoder) {
  return decoder->has_color ? decoder->mask.data() : nullptr;
}

ROOMCAST_EXPORT("decoder_color_offset") std::uint32_t decoder_color_offset(const Decoder* decoder) {
  return decoder->has_color ? decoder->color_offset : 0;
}

ROOMCAST_EXPORT("decoder_color_length") std::uint32_t decoder_color_length(const Decoder* decoder) {
  return decoder->has_color ? decoder->color_length : 0;
}

ROOMCAST_EXPORT("decoder_color_is_key") int decoder_color_is_key(const Decoder* decoder) {
  return decoder->has_color && decoder->color_is_key;
}

ROOMCAST_EXPORT("decoder_error") const char* decoder_error(const Decoder* decoder) {
  return decoder->error.c_str();
}

ROOMCAST_EXPORT("decoder_error_length") std::uint32_t decoder_error_length(const Decoder* decoder) {
  return static_cast<std::uint32_t>(decoder->error.size());
}

}  // extern "C"
