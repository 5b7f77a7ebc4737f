// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/openni2/oni_file_camera.h"

#include <utility>

#include "roomcast/source/drivers/openni2/oni_messages.h"
#include "roomcast/source/drivers/openni2/oni_reader_process.h"

namespace roomcast::source {
namespace {

using namespace std::chrono_literals;

constexpr auto kOpensWithin = 10s;
constexpr auto kSendsWithin = 2s;  // less than CameraSource takes for the loss of a camera
constexpr double kMaxFps = 1000;

class OniFileCamera final : public Camera {
 public:
  OniFileCamera(OniReaderProcess reader, std::string file)
      : reader_(std::move(reader)), file_(std::move(file)) {}

  [[nodiscard]] Status open() {
    const auto header = read_header(kOpensWithin);
    if (!header) return header.error();
    if (header->kind == OniMessageKind::kFault) return read_fault(*header);
    OniDescription read;
    if (header->kind != OniMessageKind::kDescription || header->bytes != sizeof(read))
      return not_understood();
    if (Status status = reader_.read(&read, sizeof(read), kSendsWithin); !status) return status;
    return describe(read);
  }

  [[nodiscard]] const CameraDescription& description() const override { return description_; }

  [[nodiscard]] Status wait(FramePairing& pictures, std::chrono::milliseconds patience) override {
    if (!reader_.has_bytes(patience)) return after_silence(patience);
    silence_ = silence_.zero();
    const auto header = read_header(kSendsWithin);
    if (!header) return header.error();
    switch (header->kind) {
      case OniMessageKind::kFrame:
        return read_frame(*header, pictures);
      case OniMessageKind::kEnd:
        return Error{ErrorCode::kClosed, "the file has ended"};
      case OniMessageKind::kFault:
        return read_fault(*header);
      case OniMessageKind::kDescription:
        break;
    }
    return not_understood();
  }

 private:
  [[nodiscard]] Result<OniMessageHeader> read_header(std::chrono::milliseconds within) {
    OniMessageHeader header;
    if (Status status = reader_.read(&header, sizeof(header), within); !status)
      return status.error();
    return header;
  }

  [[nodiscard]] Status read_fault(const OniMessageHeader& header) {
    if (header.bytes > kMaxOniFaultBytes) return not_understood();
    std::string sentence(header.bytes, '\0');
    if (Status status = reader_.read(sentence.data(), sentence.size(), kSendsWithin); !status)
      return status;
    const bool is_unsupported = header.value == static_cast<int>(ErrorCode::kUnsupported);
    return Error{is_unsupported ? ErrorCode::kUnsupported : ErrorCode::kUnavailable,
                 std::move(sentence)};
  }

  [[nodiscard]] Status describe(const OniDescription& read) {
    if (!read.depth.check() || !read.color.check() || !(read.fps >= 1 && read.fps < kMaxFps))
      return not_understood();
    SensorCalibration& calibration = description_.calibration;
    calibration.depth = read.depth;
    calibration.color = read.color;
    calibration.color_from_depth.translation_m.x() = read.color_from_depth_x_m;
    calibration.color_is_registered = read.is_registered;
    description_.has_color = read.has_color;
    description_.fps = read.fps;
    return {};
  }

  /// A process whose memory OpenNI has overwritten may send anything: sizes are those of the
  /// description.
  [[nodiscard]] Status read_frame(const OniMessageHeader& header, FramePairing& pictures) {
    const SensorCalibration& calibration = description_.calibration;
    depth_mm_.resize(calibration.depth.width, calibration.depth.height);
    if (description_.has_color) color_.resize(calibration.color.width, calibration.color.height);
    const ImageView<std::uint16_t> depth = depth_mm_.view();
    const std::size_t depth_bytes = depth.pixel_count() * sizeof(*depth.data);
    const std::size_t color_bytes =
        description_.has_color ? color_.view().pixel_count() * sizeof(Rgb8) : 0;
    if (header.bytes != depth_bytes + color_bytes) return not_understood();
    if (Status status = reader_.read(depth.data, depth_bytes, kSendsWithin); !status) return status;
    if (Status status = reader_.read(color_.view().data, color_bytes, kSendsWithin); !status)
      return status;
    pictures.depth(nanoseconds(header.value), depth_mm_);
    if (description_.has_color) pictures.color(nanoseconds(header.value), color_);
    return {};
  }

  [[nodiscard]] Status after_silence(std::chrono::milliseconds patience) {
    silence_ += patience;
    if (silence_ < kSendsWithin) return {};
    return Error{ErrorCode::kMalformed,
                 "the file " + file_ + " is damaged: OpenNI gives no more pictures of it"};
  }

  [[nodiscard]] Status not_understood() const {
    return Error{ErrorCode::kMalformed,
                 "the file " + file_ + " is damaged: OpenNI gives pictures of another size"};
  }

  OniReaderProcess reader_;
  const std::string file_;
  CameraDescription description_;
  std::chrono::milliseconds silence_{0};
  DepthImage depth_mm_;  // reused
  ColorImage color_;
};

}  // namespace

Result<std::unique_ptr<Camera>> open_oni_file(const std::string& file, bool loop) {
  auto reader = OniReaderProcess::start(file, loop);
  if (!reader) return reader.error();
  auto camera = std::make_unique<OniFileCamera>(*std::move(reader), file);
  if (Status status = camera->open(); !status) return status.error();
  return std::unique_ptr<Camera>(std::move(camera));
}

}  // namespace roomcast::source
