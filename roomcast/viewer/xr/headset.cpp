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
constexpr auto kSeeThrough = XR_ENVIRONMENT_BLEND_MODE_ALPHA_BLEND;
constexpr float kEyeHeight_m = 1.6F;
/// XR_REFERENCE_SPACE_TYPE_LOCAL_FLOOR_EXT
constexpr auto kLocalFloorSpace = static_cast<XrReferenceSpaceType>(1000426000);

RigidTransform midway(const RigidTransform& a, const RigidTransform& b) {
  const Eigen::Quaterniond rotation =
      Eigen::Quaterniond(a.rotation).slerp(0.5, Eigen::Quaterniond(b.rotation));
  return {rotation.toRotationMatrix(), (a.translation_m + b.translation_m) / 2};
}

/// The best of the spaces that the headset offers. Every headset has LOCAL.
Result<XrReferenceSpaceType> choose_stage(const Runtime& runtime, XrSession session) {
  const char* const what = "asking for the floor";
  std::uint32_t count = 0;
  ROOMCAST_XR_TRY(xrEnumerateReferenceSpaces(session, 0, &count, nullptr), what);
  std::vector<XrReferenceSpaceType> offered(count);
  ROOMCAST_XR_TRY(xrEnumerateReferenceSpaces(session, count, &count, offered.data()), what);
  const auto is_offered = [&](XrReferenceSpaceType type) {
    return std::ranges::find(offered, type) != offered.end();
  };
  if (is_offered(XR_REFERENCE_SPACE_TYPE_STAGE)) return XR_REFERENCE_SPACE_TYPE_STAGE;
  const bool has_floor = runtime.has(kLocalFloor) && is_offered(kLocalFloorSpace);
  return has_floor ? kLocalFloorSpace : XR_REFERENCE_SPACE_TYPE_LOCAL;
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
  if (auto status = headset->choose_blend_mode(); !status) return status.error();
  if (auto status = headset->create_stage(); !status) return status.error();
  if (auto status = headset->create_layers(); !status) return status.error();
  auto actions = Actions::create(headset->runtime_, headset->session_);
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

/// The room hides what is around the wearer, unless the displays cannot.
Status Headset::choose_blend_mode() {
  const char* const what = "asking how the headset mixes pictures with what is around";
  const auto ask = [this](std::uint32_t capacity, std::uint32_t* count,
                          XrEnvironmentBlendMode* modes) {
    return xrEnumerateEnvironmentBlendModes(runtime_.instance(), runtime_.system(), kStereo,
                                            capacity, count, modes);
  };
  std::uint32_t count = 0;
  ROOMCAST_XR_TRY(ask(0, &count, nullptr), what);
  std::vector<XrEnvironmentBlendMode> offered(count);
  ROOMCAST_XR_TRY(ask(count, &count, offered.data()), what);
  const auto opaque = std::ranges::find(offered, XR_ENVIRONMENT_BLEND_MODE_OPAQUE);
  if (offered.empty()) return unavailable("the headset does not say how it shows pictures");
  blend_mode_ = opaque != offered.end() ? *opaque : offered.front();
  may_see_through_ = std::ranges::find(offered, kSeeThrough) != offered.end();
  return {};
}

/// A space without a floor has its origin at the eyes' first position; the floor is assumed
/// kEyeHeight_m below.
Status Headset::create_stage() {
  const auto type = choose_stage(runtime_, session_);
  if (!type) return type.error();
  stage_type_ = *type;
  auto info = xr_struct<XrReferenceSpaceCreateInfo>(XR_TYPE_REFERENCE_SPACE_CREATE_INFO);
  info.referenceSpaceType = stage_type_;
  info.poseInReferenceSpace.orientation.w = 1;
  if (stage_type_ == XR_REFERENCE_SPACE_TYPE_LOCAL)
    info.poseInReferenceSpace.position.y = -kEyeHeight_m;
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
      runtime_.has(kDepth) ? choose_format(session_, kDepthFormats) : Result<std::int64_t>(0);
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
    if (event.type == XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING) {
      const auto& moved = reinterpret_cast<const XrEventDataReferenceSpaceChangePending&>(event);
      if (moved.session == session_ && moved.referenceSpaceType == stage_type_)
        space_changes_.push_back(moved);
    }
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
  take_space_changes(frame.input);
  if (auto status = locate_eyes(frame.input); !status) return status.error();
  if (auto status = actions_->read(session_, stage_, frame_.predictedDisplayTime, frame.input);
      !status)
    return status.error();
  frame.is_seen = frame_is_seen_;
  return frame;
}

/// A stage that its software moves, because the wearer has drawn its borders anew, leaves the
/// wearer where they are in the room. Other spaces move when the wearer asks the headset's software
/// to recentre: then they go to the start, as they do where the stage's move is not known.
void Headset::take_space_changes(VrInput& input) {
  RigidTransform old_stage_from_stage;
  bool has_moved = false;
  std::erase_if(space_changes_, [&](const XrEventDataReferenceSpaceChangePending& change) {
    if (change.changeTime > frame_.predictedDisplayTime) return false;
    if (stage_type_ == XR_REFERENCE_SPACE_TYPE_STAGE && change.poseValid) {
      has_moved = true;
      old_stage_from_stage = old_stage_from_stage * transform_from_pose(change.poseInPreviousSpace);
    } else {
      input.recenters = true;
    }
    return true;
  });
  if (has_moved) input.old_stage_from_stage = old_stage_from_stage;
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
  const bool sees_through = may_see_through_ && sees_through_;
  if (sees_through) layer.layerFlags = XR_COMPOSITION_LAYER_BLEND_TEXTURE_SOURCE_ALPHA_BIT;
  info.environmentBlendMode = sees_through ? kSeeThrough : blend_mode_;
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
