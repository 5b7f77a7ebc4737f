// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <cstdlib>
#include <thread>

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "roomcast/render/gl/gl_context.h"

namespace roomcast::render {
namespace {

constexpr GLenum kNoSuchCapability = 0xBEEF;

TEST(EglContext, offers_opengl_4_5_core) {
  Result<EglContext> context = EglContext::create();
  ASSERT_TRUE(context.ok()) << context.error().message;
  EXPECT_GE(epoxy_gl_version(), 45);
  GLint profile = 0;
  glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
  EXPECT_NE(context->driver_name().find("4.5"), std::string::npos) << context->driver_name();
}

TEST(EglContext, tells_drivers_in_software_from_graphics_cards) {
  EXPECT_TRUE(is_in_software("llvmpipe (LLVM 15.0.6, 256 bits), 4.5"));
  EXPECT_FALSE(is_in_software("NVIDIA GeForce RTX 3060/PCIe/SSE2, 4.6.0"));
}

TEST(EglContext, collects_what_the_driver_complains_about) {
  Result<EglContext> context = EglContext::create();
  ASSERT_TRUE(context.ok()) << context.error().message;
  EXPECT_EQ(context->complaints().count, 0U);
  for (std::size_t i = 0; i < GlComplaints::kMaxTexts + 3; ++i) glEnable(kNoSuchCapability);
  EXPECT_EQ(context->complaints().count, GlComplaints::kMaxTexts + 3);
  EXPECT_EQ(context->complaints().texts.size(), GlComplaints::kMaxTexts);
  EXPECT_FALSE(context->complaints().texts.front().empty());
}

TEST(EglContext, keeps_collecting_after_being_moved) {
  Result<EglContext> made = EglContext::create();
  ASSERT_TRUE(made.ok()) << made.error().message;
  const EglContext moved = std::move(made).value();
  glEnable(kNoSuchCapability);
  EXPECT_EQ(moved.complaints().count, 1U);
}

TEST(EglContext, two_of_them_live_side_by_side) {
  Result<EglContext> first = EglContext::create();
  ASSERT_TRUE(first.ok()) << first.error().message;
  {
    Result<EglContext> second = EglContext::create();
    ASSERT_TRUE(second.ok()) << second.error().message;
    glEnable(kNoSuchCapability);
    EXPECT_EQ(second->complaints().count, 1U);
  }
  ASSERT_TRUE(first->make_current().ok());
  EXPECT_EQ(first->complaints().count, 0U);
  GLint major = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  EXPECT_EQ(major, 4);
}

TEST(EglContext, cannot_be_current_on_two_threads) {
  Result<EglContext> context = EglContext::create();
  ASSERT_TRUE(context.ok()) << context.error().message;
  std::thread other([&] {
    const Status current = context->make_current();
    ASSERT_FALSE(current.ok());
    EXPECT_EQ(current.error().code, ErrorCode::kUnavailable);
  });
  other.join();
}

// Hides all drivers from EGL's loader. A process of its own, because EGL looks for drivers only
// once.
TEST(EglContextDeathTest, says_what_to_install_where_there_is_no_opengl) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto without_drivers = [] {
    setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "", 1);
    setenv("__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent", 1);
    const Result<EglContext> context = EglContext::create();
    if (context.ok()) std::exit(1);
    std::fputs(context.error().message.c_str(), stderr);
    std::exit(context.error().code == ErrorCode::kUnavailable ? 0 : 2);
  };
  EXPECT_EXIT(without_drivers(), testing::ExitedWithCode(0), "apt install .*libgl1-mesa-dri");
}

}  // namespace
}  // namespace roomcast::render
