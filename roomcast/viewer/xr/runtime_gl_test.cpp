// SPDX-License-Identifier: Apache-2.0
// Tests what a headset and its software offer, or why there is none, with the test runtime.
#include <fstream>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/viewer/xr/headset_fixture.h"

namespace roomcast::viewer::xr {
namespace {

class RuntimeTest : public HeadsetTest {};

TEST_F(RuntimeTest, stands_on_the_best_floor_that_is_offered) {
  constexpr auto kLocalFloorSpace = static_cast<XrReferenceSpaceType>(1000426000);
  const auto stage_of = [this](std::vector<XrReferenceSpaceType> offered) {
    runtime.spaces = std::move(offered);
    open();
    EXPECT_TRUE(draw().ok());
    headset.reset();
    return runtime.stage;
  };
  constexpr auto kView = XR_REFERENCE_SPACE_TYPE_VIEW, kLocal = XR_REFERENCE_SPACE_TYPE_LOCAL,
                 kStage = XR_REFERENCE_SPACE_TYPE_STAGE;
  runtime.more_extensions = {"XR_EXT_local_floor"};
  EXPECT_EQ(stage_of({kView, kLocal, kLocalFloorSpace, kStage}), kStage);
  EXPECT_EQ(stage_of({kView, kLocal, kLocalFloorSpace}), kLocalFloorSpace);
  EXPECT_EQ(stage_of({kView, kLocal}), kLocal);
}

TEST_F(RuntimeTest, shows_pictures_as_its_displays_can) {
  const auto mode_of = [this](std::vector<XrEnvironmentBlendMode> offered) {
    runtime.blend_modes = std::move(offered);
    open();
    EXPECT_TRUE(draw().ok());
    EXPECT_EQ(headset->adds_light(), runtime.blend_mode == XR_ENVIRONMENT_BLEND_MODE_ADDITIVE);
    headset.reset();
    return runtime.blend_mode;
  };
  constexpr auto kOpaque = XR_ENVIRONMENT_BLEND_MODE_OPAQUE,
                 kAdditive = XR_ENVIRONMENT_BLEND_MODE_ADDITIVE,
                 kAlpha = XR_ENVIRONMENT_BLEND_MODE_ALPHA_BLEND;
  EXPECT_EQ(mode_of({kAlpha, kOpaque}), kOpaque);
  EXPECT_EQ(mode_of({kAdditive}), kAdditive);
  EXPECT_EQ(mode_of({kAlpha, kAdditive}), kAlpha);
}

TEST_F(RuntimeTest, without_a_headset_the_error_is_a_sentence) {
  runtime.is_connected = false;
  const auto none = Headset::open();
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().message, "no headset is connected: connect it, or wake it up");
}

TEST_F(RuntimeTest, without_its_service_the_error_is_a_sentence) {
  runtime.service_runs = false;
  const auto none = Headset::open();
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().message,
            "the headset's software does not answer: start its service (SteamVR, monado-service, "
            "...), and connect the headset");
}

TEST_F(RuntimeTest, a_wrong_name_of_the_runtime_is_in_the_error) {
  const TemporaryFolder folder;
  const auto missing = folder / "typo.json", malformed = folder / "malformed.json",
             without_library = folder / "without_library.json";
  std::ofstream(malformed) << "{";
  std::ofstream(without_library)
      << R"({"file_format_version": "1.0.0", "runtime": {"library_path": "/nonexistent.so"}})";
  for (const auto& named : {missing, malformed, without_library}) {
    ::setenv("XR_RUNTIME_JSON", named.c_str(), 1);
    const auto none = Headset::open();
    ASSERT_FALSE(none.ok());
    EXPECT_EQ(none.error().message.find("XR_RUNTIME_JSON is \"" + named.string() + "\""), 0U)
        << none.error().message;
  }
}

TEST_F(RuntimeTest, without_a_runtime_the_error_is_a_sentence) {
  ::unsetenv("XR_RUNTIME_JSON");
  const TemporaryFolder empty;
  for (const char* const folders : {"XDG_CONFIG_HOME", "XDG_CONFIG_DIRS", "XDG_DATA_DIRS"})
    ::setenv(folders, empty.path().c_str(), 1);
  const auto none = Headset::open();
  for (const char* const folders : {"XDG_CONFIG_HOME", "XDG_CONFIG_DIRS", "XDG_DATA_DIRS"})
    ::unsetenv(folders);
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().message.find("no headset software runs here"), 0U) << none.error().message;
}

// Last: the loader keeps a runtime that it has only asked for its extensions.
TEST_F(RuntimeTest, without_egl_the_error_names_the_variable_that_helps) {
  runtime.offers_egl = false;
  const auto none = Headset::open();
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().message,
            "the headset's software does not offer XR_MNDX_egl_enable, which this window needs; "
            "start the viewer with SDL_VIDEODRIVER=x11 and without SDL_VIDEO_X11_FORCE_EGL");
}

}  // namespace
}  // namespace roomcast::viewer::xr
