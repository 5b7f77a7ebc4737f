// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/gl/gl_fixture.h"
#include "roomcast/render/gl/gl_program.h"

namespace roomcast::render {
namespace {

using GlProgramTest = GlTest;

constexpr std::string_view kShared = "vec4 place() { return vec4(0.0); }\n";
constexpr std::string_view kVertex = "void main() { gl_Position = place(); }\n";
constexpr std::string_view kFragment =
    "in vec3 tint;\nout vec4 picture;\nvoid main() { picture = vec4(tint, 1.0); }\n";

TEST_F(GlProgramTest, sources_of_a_stage_are_read_one_after_the_other) {
  const Result<GlProgram> program = make_program({{GL_VERTEX_SHADER, {kShared, kVertex}}});
  ASSERT_TRUE(program.ok()) << program.error().message;
  EXPECT_TRUE(glIsProgram(program->name()));
}

TEST_F(GlProgramTest, a_compile_error_comes_back_with_the_compilers_log) {
  const Result<GlProgram> program = make_program({{GL_VERTEX_SHADER, {kVertex}}});
  ASSERT_FALSE(program.ok());
  EXPECT_EQ(program.error().code, ErrorCode::kUnsupported);
  EXPECT_NE(program.error().message.find("place"), std::string::npos) << program.error().message;
}

TEST_F(GlProgramTest, a_link_error_comes_back_with_the_linkers_log) {
  const Result<GlProgram> program =
      make_program({{GL_VERTEX_SHADER, {kShared, kVertex}}, {GL_FRAGMENT_SHADER, {kFragment}}});
  ASSERT_FALSE(program.ok());
  EXPECT_NE(program.error().message.find("tint"), std::string::npos) << program.error().message;
}

}  // namespace
}  // namespace roomcast::render
