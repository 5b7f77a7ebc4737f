// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/xr/headset.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>
#include <epoxy/gl.h>

#include "roomcast/viewer/xr/xr_status.h"
#include "roomcast/viewer/xr/xr_struct.h"

namespace roomcast::viewer::xr {
namespace {

constexpr XrViewConfigurationType kStereo = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
constexpr std::array<std::int64_t, 2> kColorFormats = {GL_SRGB8_ALPHA8, GL_RGBA8};
constexpr std::array<std::int64_t, 1> kDepthFormats = {GL_DEPTH_COMPONENT32F};
constexpr float kEyeHeight_m = 1.6F;

RigidTransform midway(const RigidTransform& a, const RigidTransform& b) {
  const Eigen::Quaterniond rotation =
      Eigen::Quaterniond(a.rotation).slerp(0.5, Eigen::Quaterniond(b.rotation));
  return {rotation.toRotationMatrix(), (a.translation_m + b.translation_m) / 2};
}

Result<bool> offers_stage(XrSession session) {
  const char* const what = "asking for the floor";
  std::uint32_t count = 0;
  ROOMCAST_XR_TRY(xrEnumerateReferenceSpaces(session, 0, &count, nullptr), what);
  std::vector<XrReferenceSpaceType> offered(count);
  ROOMCAST_XR_TRY(xrEnumerateReferenceSpaces(session, count, &count, offered.data()), what);
  return std::ranges::find(offered, XR_REFERENCE_SPACE_TYPE_STAGE) != offered.end();
}

Result<std::array<XrViewConfigurationView, kEyes>> recommended_views(const Runtime& runtime) {
  std::array<XrViewConfigurationView, kEyes> views;
  views.fill({XR_TYPE_VIEW_CONFIGURATION_VIEW, nullptr, 0, 0, 0, 0, 0, 0});
  std::uint32_t count = 0;
  ROOMCAST_XR_TRY(xrEnumerateViewConfigurationViews(runtime.instance(), runtime.system(), kStereo,
                                                    static_cast<std::uint32_t>(views.size()),
                                                    &count, views.data()),
                  "asking for the size of the headset's pictures");
  if (count == kEyes) return views;
  return Error{ErrorCode::kUnavailable, "the headset does not have two eyes"};
}

}  // namespace

Result<std::unique_ptr<Headset>> Headset::open() {
  auto binding = GraphicsBinding::of_current_context();
  if (!binding) return binding.error();
  auto runtime = Runtime::open(binding->extension());
  if (!runtime) return runtime.error();
  std::unique_ptr<Headset> headset(new Headset(std::move(*runtime), std::move(*binding)));
  if (auto status = headset->create_session(); !status) return status.error();
  if (auto status = headset->create_stage(); !status) return status.error();
  if (auto status = headset->create_layers(); !status) return status.error();
  auto actions = Actions::create(headset->runtime_.instance(), headset->session_);
  if (!actions) return actions.error();
  headset->actions_ = std::move(*actions);
  return headset;
}

Status Headset::create_session() {
  auto info = xr_struct<XrSessionCreateInfo>(XR_TYPE_SESSION_CREATE_INFO);
  info.next = binding_.chain();
  info.systemId = runtime_.system();
  return xr_status(xrCreateSession(runtime_.instance(), &info, &session_),
                   "beginning a session with the headset");
}

/// A space without a floor has its origin at the eyes' first position; the floor is assumed
/// kEyeHeight_m below.
Status Headset::create_stage() {
  const auto has_stage = offers_stage(session_);
  if (!has_stage) return has_stage.error();
  auto info = xr_struct<XrReferenceSpaceCreateInfo>(XR_TYPE_REFERENCE_SPACE_CREATE_INFO);
  info.referenceSpaceType =
      *has_stage ? XR_REFERENCE_SPACE_TYPE_STAGE : XR_REFERENCE_SPACE_TYPE_LOCAL;
  info.poseInReferenceSpace.orientation.w = 1;
  if (!*has_stage) info.poseInReferenceSpace.position.y = -kEyeHeight_m;
  return xr_status(xrCreateReferenceSpace(session_, &info, &stage_), "asking for the floor");
}

Status Headset::create_layers() {
  const auto views = recommended_views(runtime_);
  if (!views) return views.error();
  const auto color = choose_format(session_, kColorFormats);
  if (!color) return color.error();
  if (*color == 0)
    return Error{ErrorCode::kUnavailable, "the headset takes no pictures of 8 bits per colour"};
  const auto depth =
      runtime_.takes_depth() ? choose_format(session_, kDepthFormats) : Result<std::int64_t>(0);
  if (!depth) return depth.error();
  for (const XrViewConfigurationView& view : *views) {
    const PictureSize size = {static_cast<int>(view.recommendedImageRectWidth),
                              static_cast<int>(view.recommendedImageRectHeight)};
    const int number = static_cast<int>(eyes_.size());
    auto eye = EyeTarget::create(session_, *color, *depth, size, number);
    if (!eye) return eye.error();
    eyes_.push_back(std::move(*eye));
  }
  auto notices = NoticeLayer::create(session_, *color);
  if (!notices) return notices.error();
  notices_ = std::move(*notices);
  return {};
}

Headset::~Headset() {
  actions_.reset();
  notices_.reset();
  eyes_.clear();
  if (stage_ != XR_NULL_HANDLE) xrDestroySpace(stage_);
  if (session_ != XR_NULL_HANDLE) xrDestroySession(session_);
}

Status Headset::poll() {
  for (;;) {
    auto event = xr_struct<XrEventDataBuffer>(XR_TYPE_EVENT_DATA_BUFFER);
    const XrResult polled = xrPollEvent(runtime_.instance(), &event);
    if (polled == XR_EVENT_UNAVAILABLE) return {};
    ROOMCAST_XR_TRY(polled, "listening to the headset");
    if (event.type == XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING)
      return Error{ErrorCode::kClosed, "the headset's software ends"};
    if (event.type != XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED) continue;
    const auto& change = reinterpret_cast<const XrEventDataSessionStateChanged&>(event);
    if (change.session != session_) continue;
    if (auto status = take(change); !status) return status;
  }
}

Status Headset::take(const XrEventDataSessionStateChanged& change) {
  state_ = change.state;
  switch (change.state) {
    case XR_SESSION_STATE_READY: {
      auto info = xr_struct<XrSessionBeginInfo>(XR_TYPE_SESSION_BEGIN_INFO);
      info.primaryViewConfigurationType = kStereo;
      ROOMCAST_XR_TRY(xrBeginSession(session_, &info), "beginning to draw for the headset");
      is_running_ = true;
      return {};
    }
    case XR_SESSION_STATE_STOPPING:
      is_running_ = false;
      return xr_status(xrEndSession(session_), "ending to draw for the headset");
    case XR_SESSION_STATE_LOSS_PENDING:
      is_running_ = false;
      return Error{ErrorCode::kClosed, "the headset is lost"};
    case XR_SESSION_STATE_EXITING:
      is_running_ = false;
      return Error{ErrorCode::kClosed, "the headset was put away"};
    default:
      return {};
  }
}

Result<HeadsetFrame> Headset::begin_frame() {
  frame_ = xr_struct<XrFrameState>(XR_TYPE_FRAME_STATE);
  ROOMCAST_XR_TRY(xrWaitFrame(session_, nullptr, &frame_), "waiting for the headset");
  frame_begin_ = clock_.now();
  ROOMCAST_XR_TRY(xrBeginFrame(session_, nullptr), "beginning a frame");
  HeadsetFrame frame;
  frame_is_seen_ = frame_.shouldRender == XR_TRUE;
  if (auto status = locate_eyes(frame.input); !status) return status.error();
  if (auto status = actions_->read(session_, stage_, frame_.predictedDisplayTime, frame.input);
      !status)
    return status.error();
  frame.is_seen = frame_is_seen_;
  return frame;
}

/// The head is midway between the eyes and looks midway between their directions, which differ
/// where the displays are canted. Without tracking, nothing is drawn.
Status Headset::locate_eyes(VrInput& input) {
  auto info = xr_struct<XrViewLocateInfo>(XR_TYPE_VIEW_LOCATE_INFO);
  info.viewConfigurationType = kStereo;
  info.displayTime = frame_.predictedDisplayTime;
  info.space = stage_;
  auto state = xr_struct<XrViewState>(XR_TYPE_VIEW_STATE);
  std::array<XrView, kEyes> views;
  views.fill({XR_TYPE_VIEW, nullptr, {}, {}});
  std::uint32_t count = 0;
  ROOMCAST_XR_TRY(xrLocateViews(session_, &info, &state, kEyes, &count, views.data()),
                  "asking where the head is");
  constexpr XrViewStateFlags kBoth =
      XR_VIEW_STATE_POSITION_VALID_BIT | XR_VIEW_STATE_ORIENTATION_VALID_BIT;
  if ((state.viewStateFlags & kBoth) != kBoth || count != kEyes) {
    frame_is_seen_ = false;
    return {};
  }
  for (std::size_t eye = 0; eye < kEyes; ++eye) {
    if (auto status = eyes_[eye].look(views[eye]); !status) return status;
  }
  draw_alike(eyes_[0], eyes_[1]);
  input.stage_from_head =
      midway(transform_from_pose(views[0].pose), transform_from_pose(views[1].pose));
  return {};
}

void Headset::show(const render::OffscreenTarget& picture) {
  for (EyeTarget& eye : eyes_) eye.show(picture);
}

/// Whether both eyes have this frame's picture. Where the headset gives an image too late, nothing
/// is shown for this frame, and the next one has a picture again.
Result<bool> Headset::has_pictures() const {
  if (!frame_is_seen_) return false;
  bool has_all = true;
  for (const EyeTarget& eye : eyes_) {
    if (!eye.shown()) return eye.shown().error();
    has_all &= *eye.shown();
  }
  return has_all;
}

Status Headset::end_frame() {
  const Result<bool> has_layer = has_pictures();
  std::array<XrCompositionLayerProjectionView, kEyes> views;
  for (std::size_t eye = 0; eye < kEyes; ++eye) views[eye] = eyes_[eye].layer();
  auto layer = xr_struct<XrCompositionLayerProjection>(XR_TYPE_COMPOSITION_LAYER_PROJECTION);
  layer.space = stage_;
  layer.viewCount = kEyes;
  layer.views = views.data();
  const XrCompositionLayerQuad notices = notices_->layer();
  const std::array layers = {reinterpret_cast<const XrCompositionLayerBaseHeader*>(&layer),
                             reinterpret_cast<const XrCompositionLayerBaseHeader*>(&notices)};
  auto info = xr_struct<XrFrameEndInfo>(XR_TYPE_FRAME_END_INFO);
  info.displayTime = frame_.predictedDisplayTime;
  info.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
  const std::uint32_t count = notices_->is_shown() ? 2 : 1;
  info.layerCount = has_layer && *has_layer ? count : 0;
  info.layers = layers.data();
  const XrResult ended = xrEndFrame(session_, &info);
  timing_.add(frame_.predictedDisplayTime, frame_.predictedDisplayPeriod,
              clock_.now() - frame_begin_);
  if (!has_layer) return has_layer.error();
  return xr_status(ended, "handing a frame over to the headset");
}

Status Headset::request_exit() {
  return xr_status(xrRequestExitSession(session_), "asking the headset for the end");
}

}  // namespace roomcast::viewer::xr
