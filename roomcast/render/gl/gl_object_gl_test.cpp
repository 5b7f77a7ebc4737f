// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "roomcast/render/gl/gl_fixture.h"
#include "roomcast/render/gl/gl_object.h"

namespace roomcast::render {
namespace {

using GlObjectTest = GlTest;

TEST_F(GlObjectTest, a_name_is_deleted_with_its_owner) {
  GLuint name = 0;
  {
    const GlTexture texture = make_texture(GL_R8, 4, 4);
    name = texture.name();
    EXPECT_TRUE(glIsTexture(name));
  }
  EXPECT_FALSE(glIsTexture(name));
}

TEST_F(GlObjectTest, moving_hands_the_name_over) {
  GlBuffer first = make_buffer(16);
  const GLuint name = first.name();
  const GlBuffer second = std::move(first);
  EXPECT_EQ(first.name(), 0U);  // NOLINT: tests the moved-from object
  EXPECT_EQ(second.name(), name);
  EXPECT_TRUE(glIsBuffer(name));
}

TEST_F(GlObjectTest, assigning_a_new_object_deletes_the_old_one) {
  GlBuffer buffer = make_buffer(16);
  const GLuint old_name = buffer.name();
  buffer = make_buffer(16);
  EXPECT_FALSE(glIsBuffer(old_name));
  EXPECT_TRUE(glIsBuffer(buffer.name()));
}

}  // namespace
}  // namespace roomcast::render
