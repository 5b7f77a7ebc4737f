// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <vector>

#include <draco/compression/decode.h>
#include <draco/compression/encode.h>

#include "bench/codec/cpu_stopwatch.h"
#include "bench/codec/peers/peers.h"

namespace roomcast::bench {
namespace {

constexpr int kDracoSpeed = 5;  // 0: smallest, 10: fastest; for live video

Error draco_failure(const char* what) {
  return {ErrorCode::kUnavailable, std::string("Draco could not ") + what + "."};
}

/// Every reading is a point of its column, its row and its depth in steps: whole numbers, which
/// Draco's k-d tree takes without a loss, in an order of its own.
class DracoPoints final : public CodecUnderTest {
 public:
  explicit DracoPoints(int step_mm) : step_mm_(step_mm) {}

  Result<FrameCost> run(const BenchFrame& frame, bool, BenchFrame& decoded) override {
    draco::Encoder encoder;
    encoder.SetSpeedOptions(kDracoSpeed, kDracoSpeed);
    encoder.SetEncodingMethod(draco::POINT_CLOUD_KD_TREE_ENCODING);
    draco::EncoderBuffer bytes;
    const CpuStopwatch encoding;
    if (!encoder.EncodePointCloudToBuffer(*points_of(frame.depth_mm), &bytes).ok())
      return draco_failure("encode points");
    const double encode_ms = encoding.ms();
    decoded.depth_mm.resize(frame.depth_mm.width(), frame.depth_mm.height());
    const CpuStopwatch decoding;
    if (!decode(bytes, decoded.depth_mm)) return draco_failure("decode points");
    return FrameCost{bytes.size(), 0, encode_ms, decoding.ms()};
  }

 private:
  [[nodiscard]] std::unique_ptr<draco::PointCloud> points_of(const DepthImage& depth_mm) const {
    std::vector<std::array<std::uint16_t, 3>> places;
    for (int y = 0; y < depth_mm.height(); ++y) {
      for (int x = 0; x < depth_mm.width(); ++x) {
        const int steps = (depth_mm.at(x, y) + step_mm_ / 2) / step_mm_;
        if (steps == 0) continue;
        places.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                          static_cast<std::uint16_t>(steps)});
      }
    }
    auto cloud = std::make_unique<draco::PointCloud>();
    const auto count = static_cast<std::uint32_t>(places.size());
    cloud->set_num_points(count);
    draco::GeometryAttribute kind;
    kind.Init(draco::GeometryAttribute::POSITION, nullptr, 3, draco::DT_UINT16, false,
              3 * sizeof(std::uint16_t), 0);
    draco::PointAttribute& attribute = *cloud->attribute(cloud->AddAttribute(kind, true, count));
    for (std::uint32_t i = 0; i < count; ++i)
      attribute.SetAttributeValue(draco::AttributeValueIndex(i), places[i].data());
    return cloud;
  }

  [[nodiscard]] bool decode(const draco::EncoderBuffer& bytes, DepthImage& depth_mm) const {
    draco::DecoderBuffer in;
    in.Init(bytes.data(), bytes.size());
    draco::Decoder decoder;
    auto cloud = decoder.DecodePointCloudFromBuffer(&in);
    if (!cloud.ok()) return false;
    const draco::PointCloud& points = *cloud.value();
    const draco::PointAttribute* places =
        points.GetNamedAttribute(draco::GeometryAttribute::POSITION);
    if (places == nullptr) return false;
    for (std::uint32_t i = 0; i < points.num_points(); ++i) {
      std::array<std::uint16_t, 3> place{};
      if (!places->ConvertValue(places->mapped_index(draco::PointIndex(i)), 3, place.data()))
        return false;
      if (place[0] >= depth_mm.width() || place[1] >= depth_mm.height()) return false;
      depth_mm.at(place[0], place[1]) = static_cast<std::uint16_t>(place[2] * step_mm_);
    }
    return true;
  }

  const int step_mm_;
};

}  // namespace

PeerResult make_draco_depth(const BenchPicture&, int step_mm) {
  return std::unique_ptr<CodecUnderTest>(std::make_unique<DracoPoints>(step_mm));
}

}  // namespace roomcast::bench
