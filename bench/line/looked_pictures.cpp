// SPDX-License-Identifier: Apache-2.0
#include "bench/line/looked_pictures.h"

#include <cmath>

#include "roomcast/render/gl/gl_context.h"
#include "roomcast/render/view/offscreen_target.h"
#include "roomcast/simulator/free_view.h"
#include "roomcast/simulator/people/moving_things.h"
#include "roomcast/simulator/simulated_room.h"
#include "roomcast/viewer/view/room_view.h"

namespace roomcast::bench {
namespace {

constexpr std::size_t kBackgroundMoments = 5;

render::ViewCamera camera_at(const RigidTransform& world_from_head) {
  return {.world_from_view = world_from_head,
          .vertical_fov_rad = kLookedFov_rad,
          .width = kLookedSide_px,
          .height = kLookedSide_px};
}

struct Drawn {
  ColorImage color;
  Image<float> depth_m;
};

/// One of the viewers.
class LookingViewer {
 public:
  static Result<LookingViewer> create() {
    auto view = viewer::RoomView::create();
    if (!view) return view.error();
    auto target = render::OffscreenTarget::create(kLookedSide_px, kLookedSide_px);
    if (!target) return target.error();
    return LookingViewer(std::move(*view), std::move(*target));
  }

  Result<Drawn> draw(const client::RoomSnapshot& room, const render::ViewCamera& camera) {
    client::RoomSnapshot without_people = room;
    without_people.people.clear();
    if (auto status = view_.show(without_people); !status) return status.error();
    if (auto status = view_.draw(camera, target_, render::RenderMode::kBlend); !status)
      return status.error();
    return Drawn{target_.read_color(), target_.read_depth_m(camera)};
  }

 private:
  LookingViewer(viewer::RoomView view, render::OffscreenTarget target)
      : view_(std::move(view)), target_(std::move(target)) {}
  viewer::RoomView view_;
  render::OffscreenTarget target_;
};

ColorImage true_view(const simulator::SimulatedRoom& room, simulator::MovingThings& things,
                     const render::ViewCamera& camera, nanoseconds scene_time) {
  CameraIntrinsics lens;
  lens.width = camera.width;
  lens.height = camera.height;
  lens.fx = lens.fy = render::focal_length_px(camera);
  lens.cx = 0.5 * camera.width - 0.5;
  lens.cy = 0.5 * camera.height - 0.5;
  simulator::FreeView view(room, lens,
                           camera.world_from_view * render::optical_from_view().inverse(), {});
  things.move_to(scene_time);
  view.look(things);
  return view.color();
}

/// Adds up squared differences of one picture.
struct PooledError {
  double squares = 0, samples = 0;

  void add(Rgb8 drawn, Rgb8 truth) {
    const auto square = [](int difference) { return static_cast<double>(difference * difference); };
    squares += square(drawn.r - truth.r) + square(drawn.g - truth.g) + square(drawn.b - truth.b);
    samples += 3;
  }
  [[nodiscard]] double psnr_db() const {
    return 10 * std::log10(255.0 * 255.0 * samples / std::max(squares, 1.0));
  }
};

}  // namespace

Result<LookedQuality> compare_pictures(const std::vector<LookedMoment>& moments,
                                       const std::string& scene,
                                       const std::function<void(const std::string&)>& progress) {
  auto context = render::EglContext::create();
  if (!context) return context.error();
  auto room = simulator::SimulatedRoom::build(scene, 1);
  if (!room) return room.error();
  simulator::MovingThings things((*room)->room());
  auto whole = LookingViewer::create();
  if (!whole) return whole.error();
  auto culled = LookingViewer::create();
  if (!culled) return culled.error();
  auto alone = LookingViewer::create();
  if (!alone) return alone.error();
  PooledError whole_error, culled_error, alone_error;
  LookedQuality quality;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    if (progress)
      progress("picture " + std::to_string(i + 1) + " of " + std::to_string(moments.size()));
    const LookedMoment& moment = moments[i];
    if (!moment.alone) continue;
    const render::ViewCamera camera = camera_at(moment.world_from_head);
    const auto with_all = whole->draw(*moment.whole, camera);
    if (!with_all) return with_all.error();
    const auto with_some = culled->draw(*moment.culled, camera);
    if (!with_some) return with_some.error();
    const auto when_alone = alone->draw(*moment.alone, camera);
    if (!when_alone) return when_alone.error();
    if (i < kBackgroundMoments) continue;
    ++quality.moments;
    const ColorImage truth = true_view(**room, things, camera, moment.scene_time);
    const ColorImage alone_truth = true_view(**room, things, camera, moment.alone_scene_time);
    for (int y = 0; y < kLookedSide_px; ++y) {
      for (int x = 0; x < kLookedSide_px; ++x) {
        if (!(with_all->depth_m.at(x, y) > 0)) continue;
        whole_error.add(with_all->color.at(x, y), truth.at(x, y));
        culled_error.add(with_some->color.at(x, y), truth.at(x, y));
        alone_error.add(when_alone->color.at(x, y), alone_truth.at(x, y));
      }
    }
  }
  quality.whole_db = whole_error.psnr_db();
  quality.culled_db = culled_error.psnr_db();
  quality.alone_db = alone_error.psnr_db();
  return quality;
}

}  // namespace roomcast::bench
