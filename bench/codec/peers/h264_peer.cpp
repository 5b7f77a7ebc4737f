// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include <wels/codec_api.h>

#include "bench/codec/cpu_stopwatch.h"
#include "bench/codec/peers/peers.h"
#include "roomcast/codec/color/i420_image.h"

namespace roomcast::bench {
namespace {

Error h264_failure(const char* what) {
  return {ErrorCode::kUnavailable, std::string("OpenH264 could not ") + what + "."};
}

struct EncoderEnd {
  void operator()(ISVCEncoder* encoder) const {
    encoder->Uninitialize();
    WelsDestroySVCEncoder(encoder);
  }
};
struct DecoderEnd {
  void operator()(ISVCDecoder* decoder) const {
    decoder->Uninitialize();
    WelsDestroyDecoder(decoder);
  }
};
using EncoderPtr = std::unique_ptr<ISVCEncoder, EncoderEnd>;
using DecoderPtr = std::unique_ptr<ISVCDecoder, DecoderEnd>;

EncoderPtr open_encoder(const BenchPicture& picture) {
  ISVCEncoder* made = nullptr;
  if (WelsCreateSVCEncoder(&made) != 0) return nullptr;
  EncoderPtr encoder(made);
  int quiet = WELS_LOG_QUIET;
  encoder->SetOption(ENCODER_OPTION_TRACE_LEVEL, &quiet);
  SEncParamExt parameters;
  encoder->GetDefaultParams(&parameters);
  parameters.iUsageType = CAMERA_VIDEO_REAL_TIME;
  parameters.iPicWidth = picture.width;
  parameters.iPicHeight = picture.height;
  parameters.iTargetBitrate = picture.color_kbit_per_s * 1000;
  parameters.iRCMode = RC_BITRATE_MODE;
  parameters.fMaxFrameRate = static_cast<float>(picture.fps);
  parameters.iComplexityMode = MEDIUM_COMPLEXITY;
  parameters.iEntropyCodingModeFlag = 1;  // CABAC
  parameters.iMultipleThreadIdc = 1;
  parameters.bEnableFrameSkip = false;
  parameters.bEnableDenoise = false;
  SSpatialLayerConfig& layer = parameters.sSpatialLayers[0];
  layer.uiProfileIdc = PRO_HIGH;
  layer.iVideoWidth = picture.width;
  layer.iVideoHeight = picture.height;
  layer.fFrameRate = parameters.fMaxFrameRate;
  layer.iSpatialBitrate = parameters.iTargetBitrate;
  return encoder->InitializeExt(&parameters) == cmResultSuccess ? std::move(encoder) : nullptr;
}

DecoderPtr open_decoder() {
  ISVCDecoder* made = nullptr;
  if (WelsCreateDecoder(&made) != 0) return nullptr;
  DecoderPtr decoder(made);
  int quiet = WELS_LOG_QUIET;
  decoder->SetOption(DECODER_OPTION_TRACE_LEVEL, &quiet);
  const SDecodingParam parameters{};
  return decoder->Initialize(&parameters) == cmResultSuccess ? std::move(decoder) : nullptr;
}

class H264Color final : public CodecUnderTest {
 public:
  H264Color(const BenchPicture& picture, EncoderPtr encoder, DecoderPtr decoder)
      : picture_(picture), encoder_(std::move(encoder)), decoder_(std::move(decoder)) {
    input_.resize(picture.width, picture.height);
  }

  Result<FrameCost> run(const BenchFrame& frame, bool want_key, BenchFrame& decoded) override {
    const CpuStopwatch encoding;
    if (!encode(frame, want_key)) return h264_failure("encode a picture");
    const double encode_ms = encoding.ms();
    decoded.color.resize(frame.color.width(), frame.color.height());
    decoded.seen = frame.seen;
    const CpuStopwatch decoding;
    if (!decode(decoded.color.view())) return h264_failure("decode a picture");
    return FrameCost{0, stream_.size(), encode_ms, decoding.ms()};
  }

 private:
  bool encode(const BenchFrame& frame, bool want_key) {
    codec::convert_seen(frame.color, frame.seen, input_);
    SSourcePicture source{};
    source.iColorFormat = videoFormatI420;
    source.iPicWidth = picture_.width;
    source.iPicHeight = picture_.height;
    Image<std::uint8_t>* const planes[] = {&input_.y, &input_.cb, &input_.cr};
    for (int i = 0; i < 3; ++i) {
      source.pData[i] = planes[i]->data();
      source.iStride[i] = planes[i]->width();
    }
    source.uiTimeStamp = std::llround(1000.0 * frame_count_++ / picture_.fps);
    if (want_key) encoder_->ForceIntraFrame(true);
    SFrameBSInfo packets{};
    if (encoder_->EncodeFrame(&source, &packets) != cmResultSuccess) return false;
    stream_.clear();
    for (int i = 0; i < packets.iLayerNum; ++i) append(packets.sLayerInfo[i]);
    return true;
  }
  void append(const SLayerBSInfo& layer) {
    std::size_t length = 0;
    for (int i = 0; i < layer.iNalCount; ++i)
      length += static_cast<std::size_t>(layer.pNalLengthInByte[i]);
    stream_.insert(stream_.end(), layer.pBsBuf, layer.pBsBuf + length);
  }

  bool decode(ImageView<Rgb8> color) {
    unsigned char* planes[3] = {};
    SBufferInfo info{};
    if (decoder_->DecodeFrameNoDelay(stream_.data(), static_cast<int>(stream_.size()), planes,
                                     &info) != dsErrorFree) {
      return false;
    }
    // Flush: the decoder delays a picture in case an earlier one follows.
    if (info.iBufferStatus != 1) decoder_->FlushFrame(planes, &info);
    if (info.iBufferStatus != 1) return false;
    const SSysMEMBuffer& buffer = info.UsrData.sSystemBuffer;
    const int chroma_width = picture_.width / 2, chroma_height = picture_.height / 2;
    codec::convert_to_rgb({{planes[0], picture_.width, picture_.height, buffer.iStride[0]},
                           {planes[1], chroma_width, chroma_height, buffer.iStride[1]},
                           {planes[2], chroma_width, chroma_height, buffer.iStride[1]}},
                          color);
    return true;
  }

  const BenchPicture picture_;
  EncoderPtr encoder_;
  DecoderPtr decoder_;
  codec::I420Image input_;
  std::vector<std::uint8_t> stream_;
  std::int64_t frame_count_ = 0;
};

}  // namespace

PeerResult make_h264_color(const BenchPicture& picture) {
  if (picture.width % 2 != 0 || picture.height % 2 != 0) {
    return Error{ErrorCode::kUnsupported, "H.264 codes pictures of even sides only."};
  }
  auto encoder = open_encoder(picture);
  auto decoder = open_decoder();
  if (!encoder || !decoder) return h264_failure("start");
  return std::unique_ptr<CodecUnderTest>(
      std::make_unique<H264Color>(picture, std::move(encoder), std::move(decoder)));
}

}  // namespace roomcast::bench
