// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/calibration/charuco_finder.h"

#include <algorithm>
#include <cmath>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

namespace roomcast::alignment::calibration {
namespace {

constexpr float kFullResolution = 1;
constexpr int kSmallestWindow = 2, kLargestWindow = 8;  // pixels to each side
constexpr double kWindowShare = 0.8;  // of the distance from a corner to the nearest tag
constexpr double kFurthestMove_px = 3;

/// Predicts the positions of the board's corners from one tag.
class TagView {
 public:
  TagView(const CharucoBoard& board, const BoardTag& tag, const alignment::TagOutline& seen)
      : tag_(tag) {
    std::vector<cv::Point2f> on_board, in_picture;
    const auto corners = tag_corners_m(board, tag);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      on_board.emplace_back(corners[i].cast<float>().x(), corners[i].cast<float>().y());
      const Eigen::Vector2f pixel = seen.corners_px[i].cast<float>();
      in_picture.emplace_back(pixel.x(), pixel.y());
    }
    picture_from_board_ = cv::getPerspectiveTransform(on_board, in_picture);
    side_px_ = (seen.corners_px[0] - seen.corners_px[1]).norm();
    for (std::size_t i = 1; i < 4; ++i)
      side_px_ = std::min(side_px_, (seen.corners_px[i] - seen.corners_px[(i + 1) % 4]).norm());
  }

  [[nodiscard]] bool touches(int column, int row) const {
    return (column == tag_.column || column == tag_.column + 1) &&
           (row == tag_.row || row == tag_.row + 1);
  }
  [[nodiscard]] Eigen::Vector2d expects(const Eigen::Vector2d& corner_m) const {
    const cv::Vec3d p = picture_from_board_ * cv::Vec3d(corner_m.x(), corner_m.y(), 1);
    return {p[0] / p[2], p[1] / p[2]};
  }
  [[nodiscard]] double side_px() const { return side_px_; }

 private:
  BoardTag tag_;
  cv::Matx33d picture_from_board_;
  double side_px_ = 0;
};

/// The largest window without a part of a tag.
int window_around(double tag_side_px) {
  const double gap_px = tag_side_px * 0.5 * (1 - kTagShare) / kTagShare;
  return std::clamp(static_cast<int>(kWindowShare * gap_px), kSmallestWindow, kLargestWindow);
}

}  // namespace

CharucoFinder::CharucoFinder(const CharucoBoard& board)
    : board_(board), tags_(tags_of(board)), detector_(kFullResolution) {}

std::vector<SeenCorner> CharucoFinder::find(ColorView color) {
  std::vector<TagView> views;
  for (const alignment::TagOutline& seen : detector_.find(color)) {
    if (seen.id >= 0 && seen.id < static_cast<int>(tags_.size()))
      views.emplace_back(board_, tags_[static_cast<std::size_t>(seen.id)], seen);
  }
  const auto grey = detector_.grey();
  const cv::Mat picture(grey.height, grey.width, CV_8U, const_cast<std::uint8_t*>(grey.data));
  std::vector<SeenCorner> corners;
  for (int corner = 0; corner < board_.corner_count(); ++corner) {
    const int column = corner % (board_.columns - 1) + 1, row = corner / (board_.columns - 1) + 1;
    Eigen::Vector2d expected = Eigen::Vector2d::Zero();
    double tag_side_px = 0;
    int count = 0;
    for (const TagView& view : views) {
      if (!view.touches(column, row)) continue;
      expected += view.expects(board_.corner_m(corner));
      tag_side_px = count == 0 ? view.side_px() : std::min(tag_side_px, view.side_px());
      ++count;
    }
    if (count == 0) continue;
    expected /= count;
    const int window = window_around(tag_side_px);
    if (expected.minCoeff() < window + 1 || expected.x() > grey.width - window - 2 ||
        expected.y() > grey.height - window - 2)
      continue;
    std::vector<cv::Point2f> point = {
        {static_cast<float>(expected.x()), static_cast<float>(expected.y())}};
    cv::cornerSubPix(picture, point, {window, window}, {-1, -1},
                     {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 40, 0.001});
    const Eigen::Vector2d found(static_cast<double>(point[0].x), static_cast<double>(point[0].y));
    if ((found - expected).norm() < kFurthestMove_px) corners.push_back({corner, found});
  }
  return corners;
}

}  // namespace roomcast::alignment::calibration
