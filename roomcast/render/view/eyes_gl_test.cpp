// SPDX-License-Identifier: Apache-2.0
// Compares drawing for two eyes at once with drawing for each eye alone.
#include <cstdlib>
#include <string>
#include <utility>

#include "roomcast/render/room_fixture.h"
#include "roomcast/render/scene_fixture.h"
#include "roomcast/render/view/eyes.h"

namespace roomcast::render {
namespace {

using Eigen::Vector3d;

const CameraIntrinsics kEyesLens = pinhole(128, 96, 100);
const CameraIntrinsics kEyesEyeLens = pinhole(120, 90, 120);
const Vector3d kAhead(0, 1.5, -2.4);

ViewCamera eye_at(const Vector3d& place_m, const Vector3d& target_m = kAhead) {
  return eye_of(kEyesEyeLens, world_from_optical_looking_at(place_m, target_m));
}

Picture read_eye(const OffscreenTarget& target, int eye) {
  return {target.read_color(eye), target.read_sensors(eye)};
}

/// Some drivers draw a square whose centre lies beside the picture, others do not. At the border
/// between the eyes none does, so near the sides two eyes can lack squares that one eye has.
constexpr int kSideOfSquares_px = 8;

/// Share of the pixels that differ by more than a rounding of their colour.
double share_of_others(const Picture& a, const Picture& b, RenderMode mode) {
  constexpr int kRounding = 1;
  const int side = mode == RenderMode::kSplats ? kSideOfSquares_px : 0;
  int others = 0, pixels = 0;
  for (int y = 0; y < a.color.height(); ++y) {
    for (int x = side; x < a.color.width() - side; ++x, ++pixels) {
      const Rgb8 p = a.color.at(x, y), q = b.color.at(x, y);
      const bool alike = std::abs(p.r - q.r) <= kRounding && std::abs(p.g - q.g) <= kRounding &&
                         std::abs(p.b - q.b) <= kRounding &&
                         a.sensors.at(x, y) == b.sensors.at(x, y);
      others += alike ? 0 : 1;
    }
  }
  return static_cast<double>(others) / pixels;
}

class TwoEyes : public RoomTest, public ::testing::WithParamInterface<RenderMode> {
 protected:
  void SetUp() override {
    RoomTest::SetUp();
    if (HasFatalFailure()) return;
    options_.floor_grid = true;
    options_.unseen = Unseen::kSurroundings;
    ASSERT_TRUE(room_->set_options(options_).ok());
    show(Vector3d(-0.3, 1.5, 0), kFirst);
    show(Vector3d(0.4, 1.6, 0), kSecond);
  }

  /// The second sensor's surface is slightly in front of the first one's. At equal depth, rounding
  /// would decide which one wins.
  void show(const Vector3d& place_m, SensorId id) {
    const RigidTransform pose = world_from_optical_looking_at(place_m, kAhead);
    SensorPictures pictures = true_pictures(kEyesLens, pose);
    for (std::size_t i = 0; id == kSecond && i < pictures.depth_mm.view().pixel_count(); ++i) {
      pictures.depth_mm.data()[i] -= 8;
    }
    add(id, kEyesLens, pose, pictures);
  }

  OffscreenTarget draw_both(const Eyes& eyes) {
    auto target = OffscreenTarget::create(eyes.width(), eyes.height(), eyes.count());
    EXPECT_TRUE(target.ok());
    const Status drawn = room_->draw(eyes, *target, GetParam());
    EXPECT_TRUE(drawn.ok()) << drawn.error().message;
    return *std::move(target);
  }
};
INSTANTIATE_TEST_SUITE_P(Modes, TwoEyes, ::testing::ValuesIn(kRenderModes),
                         [](const auto& mode) { return std::string(name_of(mode.param)); });

TEST_P(TwoEyes, see_what_each_sees_alone) {
  const ViewCamera left = eye_at({-0.03, 1.65, 0.1}), right = eye_at({0.034, 1.65, 0.1});
  const OffscreenTarget both = draw_both({left, right});
  EXPECT_LT(share_of_others(read_eye(both, 0), draw(left, GetParam()), GetParam()), 2e-3);
  EXPECT_LT(share_of_others(read_eye(both, 1), draw(right, GetParam()), GetParam()), 2e-3);
  EXPECT_GT(share_of_others(read_eye(both, 0), read_eye(both, 1), GetParam()), 0.02)
      << "and not the same";
}

TEST_P(TwoEyes, keep_to_their_parts_of_the_picture) {
  options_.floor_grid = false;
  ASSERT_TRUE(room_->set_options(options_).ok());
  const ViewCamera ahead = eye_at({0, 1.5, -1.5}), away = eye_at({0, 1.5, 0}, {0, 1.5, 5});
  const Picture nothing = {ColorImage(ahead.width, ahead.height, kNothing),
                           Image<std::int32_t>(ahead.width, ahead.height, kDrawnByNoSensor)};
  const OffscreenTarget left_sees = draw_both({ahead, away});
  EXPECT_EQ(read_eye(left_sees, 1).color, nothing.color);
  EXPECT_EQ(read_eye(left_sees, 1).sensors, nothing.sensors);
  EXPECT_EQ(left_sees.read_depth_m(away, 1), Image<float>(ahead.width, ahead.height, 0.F));
  const OffscreenTarget right_sees = draw_both({away, ahead});
  EXPECT_EQ(read_eye(right_sees, 0).color, nothing.color);
  EXPECT_EQ(read_eye(right_sees, 0).sensors, nothing.sensors);
  EXPECT_LT(share_of_others(read_eye(right_sees, 1), draw(ahead, GetParam()), GetParam()), 2e-3);
}

TEST_P(TwoEyes, may_have_different_lenses_and_an_odd_width) {
  ViewCamera left = eye_at({-0.03, 1.65, 0.1}), right = eye_at({0.034, 1.65, 0.1});
  left.width = right.width = 117;
  right.vertical_fov_rad *= 0.8;
  const OffscreenTarget both = draw_both({left, right});
  EXPECT_LT(share_of_others(read_eye(both, 0), draw(left, GetParam()), GetParam()), 2e-3);
  EXPECT_LT(share_of_others(read_eye(both, 1), draw(right, GetParam()), GetParam()), 2e-3);
}

/// Counts the draw and dispatch calls to the driver.
struct Calls {
  static inline int draws = 0, dispatches = 0;
  static inline decltype(epoxy_glDrawElementsIndirect) indirect = nullptr;
  static inline decltype(epoxy_glDrawElementsInstanced) elements = nullptr;
  static inline decltype(epoxy_glDrawArraysInstanced) arrays = nullptr;
  static inline decltype(epoxy_glDispatchCompute) dispatch = nullptr;

  static void APIENTRY count_indirect(GLenum mode, GLenum type, const void* command) {
    ++draws;
    indirect(mode, type, command);
  }
  static void APIENTRY count_elements(GLenum mode, GLsizei count, GLenum type, const void* indices,
                                      GLsizei instances) {
    ++draws;
    elements(mode, count, type, indices, instances);
  }
  static void APIENTRY count_arrays(GLenum mode, GLint first, GLsizei count, GLsizei instances) {
    ++draws;
    arrays(mode, first, count, instances);
  }
  static void APIENTRY count_dispatch(GLuint x, GLuint y, GLuint z) {
    ++dispatches;
    dispatch(x, y, z);
  }

  /// Counts from construction to destruction.
  Calls() {
    draws = dispatches = 0;
    indirect = std::exchange(epoxy_glDrawElementsIndirect, count_indirect);
    elements = std::exchange(epoxy_glDrawElementsInstanced, count_elements);
    arrays = std::exchange(epoxy_glDrawArraysInstanced, count_arrays);
    dispatch = std::exchange(epoxy_glDispatchCompute, count_dispatch);
  }
  ~Calls() {
    epoxy_glDrawElementsIndirect = indirect;
    epoxy_glDrawElementsInstanced = elements;
    epoxy_glDrawArraysInstanced = arrays;
    epoxy_glDispatchCompute = dispatch;
  }
};

TEST_P(TwoEyes, ask_as_much_of_the_driver_as_one) {
  const ViewCamera left = eye_at({-0.03, 1.65, 0.1}), right = eye_at({0.034, 1.65, 0.1});
  draw_both({left, right});  // epoxy resolves the driver's functions at their first call
  struct Count {
    int draws, dispatches;
  };
  const auto count_of = [&](const Eyes& eyes) {
    show(Vector3d(-0.3, 1.5, 0), kFirst);  // a new picture: counts the work per picture, too
    const Calls calls;
    draw_both(eyes);
    return Count{Calls::draws, Calls::dispatches};
  };
  const Count one = count_of(left), two = count_of({left, right});
  EXPECT_GE(one.draws, 3) << "the floor and two sensors";
  EXPECT_EQ(one.draws, two.draws);
  EXPECT_EQ(one.dispatches, two.dispatches);
}

using EyesTest = RoomTest;

TEST_F(EyesTest, that_do_not_fit_together_are_refused) {
  const ViewCamera left = eye_at({0, 1.5, 0});
  const auto code = [&](const ViewCamera& right) {
    const Status status = Eyes(left, right).check();
    return status.ok() ? "taken" : status.error().message;
  };
  EXPECT_EQ(code(left), "taken");
  ViewCamera wider = left, farther = left, illegal = left;
  wider.width += 2;
  farther.far_m += 1;
  illegal.vertical_fov_rad = 0;
  EXPECT_NE(code(wider).find("same size"), std::string::npos);
  EXPECT_NE(code(farther).find("near and far"), std::string::npos);
  EXPECT_NE(code(illegal).find("field of view"), std::string::npos);
}

// The software driver applies these clip distances even while they are disabled; others do not.
TEST_F(EyesTest, have_borders_only_while_two_are_drawn) {
  const ViewCamera eye = eye_at({0, 1.5, 0});
  {
    const EyeBorders one(eye);
    EXPECT_FALSE(glIsEnabled(GL_CLIP_DISTANCE0));
  }
  {
    const EyeBorders two(Eyes(eye, eye));
    EXPECT_TRUE(glIsEnabled(GL_CLIP_DISTANCE0) && glIsEnabled(GL_CLIP_DISTANCE1));
  }
  EXPECT_FALSE(glIsEnabled(GL_CLIP_DISTANCE0) || glIsEnabled(GL_CLIP_DISTANCE1));
}

TEST_F(EyesTest, need_a_picture_with_room_for_both) {
  const ViewCamera eye = eye_at({0, 1.5, 0});
  const auto for_one = OffscreenTarget::create(eye.width, eye.height);
  const auto for_two = OffscreenTarget::create(eye.width, eye.height, 2);
  ASSERT_TRUE(for_one.ok() && for_two.ok());
  EXPECT_FALSE(room_->draw({eye, eye}, *for_one, RenderMode::kMesh).ok());
  EXPECT_FALSE(room_->draw(eye, *for_two, RenderMode::kMesh).ok());
}

}  // namespace
}  // namespace roomcast::render
