// SPDX-License-Identifier: Apache-2.0
// Fixture for tests that draw: gives each test its own GL context and fails the test if the driver
// reported an error.
#pragma once

#include <optional>

#include <gtest/gtest.h>

#include "roomcast/render/gl/gl_context.h"

namespace roomcast::render {

class GlTest : public ::testing::Test {
 protected:
  void SetUp() override {
    Result<EglContext> made = EglContext::create();
    ASSERT_TRUE(made.ok()) << made.error().message;
    context_ = std::move(made).value();
  }

  void TearDown() override {
    if (!context_) return;
    EXPECT_EQ(context_->complaints().count, 0U);
    for (const std::string& text : context_->complaints().texts) ADD_FAILURE() << text;
  }

  std::optional<EglContext> context_;  // outlives the members of the test
};

}  // namespace roomcast::render
