// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/board/tag_detector.h"

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>

namespace roomcast::alignment {
namespace {

constexpr int kBitsCorrected = 1;     // correcting more causes false detections
constexpr double kMinTagMargin = 30;  // least decision margin (contrast) of a detection

}  // namespace

struct TagDetector::Detector {
  apriltag_family_t* family = tag36h11_create();
  apriltag_detector_t* detector = apriltag_detector_create();
  Image<std::uint8_t> grey;

  explicit Detector(float decimate) {
    apriltag_detector_add_family_bits(detector, family, kBitsCorrected);
    detector->quad_decimate = decimate;
    detector->nthreads = 1;
  }
  ~Detector() {
    apriltag_detector_destroy(detector);
    tag36h11_destroy(family);
  }
  Detector(const Detector&) = delete;
  Detector& operator=(const Detector&) = delete;

  void make_grey(ColorView color) {
    grey.resize(color.width, color.height);
    for (int y = 0; y < color.height; ++y) {
      for (int x = 0; x < color.width; ++x) {
        const auto& p = color.at(x, y);
        grey.at(x, y) = static_cast<std::uint8_t>((77 * p.r + 150 * p.g + 29 * p.b) >> 8);
      }
    }
  }
};

TagDetector::TagDetector(float decimate) : detector_(std::make_unique<Detector>(decimate)) {}
TagDetector::~TagDetector() = default;
TagDetector::TagDetector(TagDetector&&) noexcept = default;
TagDetector& TagDetector::operator=(TagDetector&&) noexcept = default;

ImageView<const std::uint8_t> TagDetector::grey() const {
  return detector_->grey.view();
}

std::vector<TagOutline> TagDetector::find(ColorView color) {
  detector_->make_grey(color);
  image_u8_t picture = {color.width, color.height, color.width, detector_->grey.data()};
  zarray_t* const found = apriltag_detector_detect(detector_->detector, &picture);
  std::vector<TagOutline> tags;
  for (int i = 0; i < zarray_size(found); ++i) {
    apriltag_detection_t* detection = nullptr;
    zarray_get(found, i, &detection);
    if (static_cast<double>(detection->decision_margin) < kMinTagMargin) continue;
    TagOutline tag{detection->id, {}};
    // The library puts the origin at the corner of the top left pixel, roomcast at its centre.
    for (std::size_t c = 0; c < 4; ++c)
      tag.corners_px[c] = Eigen::Vector2d(detection->p[c][0], detection->p[c][1]).array() - 0.5;
    tags.push_back(tag);
  }
  apriltag_detections_destroy(found);
  return tags;
}

}  // namespace roomcast::alignment
