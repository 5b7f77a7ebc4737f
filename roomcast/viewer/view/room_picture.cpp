// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/view/room_picture.h"

#include <utility>

namespace roomcast::viewer {
namespace {

HostTime host_now() {
  return SteadyClock().now();
}

}  // namespace

GLuint GlQueryKind::create() {
  GLuint name = 0;
  glCreateQueries(GL_TIME_ELAPSED, 1, &name);
  return name;
}

void GlQueryKind::destroy(GLuint name) {
  glDeleteQueries(1, &name);
}

void DrawTimer::begin() {
  measures_ = begun_ - taken_ < kInFlight;  // else the GPU is far behind: skip this picture
  if (!measures_) return;
  begins_[begun_ % kInFlight] = host_now();
  glBeginQuery(GL_TIME_ELAPSED, queries_[begun_ % kInFlight].name());
}

void DrawTimer::end() {
  if (!measures_) return;
  glEndQuery(GL_TIME_ELAPSED);
  ++begun_;
}

std::optional<nanoseconds> DrawTimer::take() {
  std::optional<nanoseconds> newest;
  while (taken_ < begun_) {
    const GLuint query = queries_[taken_ % kInFlight].name();
    GLint is_finished = GL_FALSE;
    glGetQueryObjectiv(query, GL_QUERY_RESULT_AVAILABLE, &is_finished);
    if (is_finished == GL_FALSE) break;
    GLuint64 elapsed_ns = 0;
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &elapsed_ns);
    const nanoseconds longest = host_now() - begins_[taken_ % kInFlight];
    ++taken_;
    if (elapsed_ns <= static_cast<GLuint64>(longest.count())) newest = nanoseconds(elapsed_ns);
  }
  return newest;
}

Status RoomPicture::draw(RoomView& room, const render::Eyes& eyes, render::RenderMode mode) {
  const bool fits = target_ && target_->width() == eyes.width() &&
                    target_->height() == eyes.height() && target_->eyes() == eyes.count();
  if (!fits) {
    auto target = render::OffscreenTarget::create(eyes.width(), eyes.height(), eyes.count());
    if (!target) return target.error();
    target_ = std::move(*target);
  }
  timer_.begin();
  Status drawn = room.draw(eyes, *target_, mode);
  timer_.end();
  return drawn;
}

std::optional<Eigen::Vector3d> surface_at(const render::OffscreenTarget& picture,
                                          const render::ViewCamera& camera, int x, int y) {
  if (x < 0 || y < 0 || x >= picture.width() || y >= picture.height()) return std::nullopt;
  float depth = 1;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.framebuffer());
  glReadPixels(x, picture.height() - 1 - y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
  if (depth >= 1) return std::nullopt;
  return world_from_pixel(camera, x, y, depth);
}

Eigen::Vector3d world_from_pixel(const render::ViewCamera& camera, double x, double y,
                                 double depth) {
  const double near = camera.near_m, far = camera.far_m;
  const double z_m = 2 * far * near / (far + near - (2 * depth - 1) * (far - near));
  const double focal = render::focal_length_px(camera);
  const Eigen::Vector3d view_m((x + 0.5 - camera.width / 2.0) / focal * z_m,
                               (camera.height / 2.0 - y - 0.5) / focal * z_m, -z_m);
  return camera.world_from_view * view_m;
}

}  // namespace roomcast::viewer
