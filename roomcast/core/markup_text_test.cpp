// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/markup_text.h"

#include <gtest/gtest.h>

namespace roomcast {
namespace {

TEST(MarkupText, nothing_is_taken_for_markup) {
  EXPECT_EQ(markup_text(R"(<a href="x">b & c</a>)"),
            "&lt;a href=&quot;x&quot;&gt;b &amp; c&lt;/a&gt;");
  EXPECT_EQ(markup_text("Zoë's room"), "Zoë's room");
  EXPECT_EQ(markup_text(""), "");
}

}  // namespace
}  // namespace roomcast
