// SPDX-License-Identifier: Apache-2.0
// shaders.h is made by reading the text of shaders. So the driver, which reads it with more care,
// has to agree with every line of it.
#include "roomcast/render/gl/gl_fixture.h"
#include "roomcast/render/gl/shader_variables_fixture.h"
#include "roomcast/render/room_renderer.h"

namespace roomcast::render {
namespace {

using ShaderVariablesTest = GlTest;

TEST_F(ShaderVariablesTest, are_linked_as_declared_in_every_program_of_the_renderer) {
  const Result<RoomRenderer> renderer = RoomRenderer::create();
  ASSERT_TRUE(renderer.ok()) << renderer.error().message;
  const int programs =
      expect_programs_as_declared([](auto& visitor) { shaders::visit_all(visitor); });
  EXPECT_GE(programs, 28);
}

template <class Program, class Variable, class Value>
concept CanSet = requires(const Program& program, Variable variable, const Value& value) {
  program.set(variable, value);
};
using Mix = ProgramWith<shaders::mix_vert, shaders::surface_view_glsl>;
using Weight = decltype(shaders::mix_vert::weight);
static_assert(CanSet<Mix, Weight, float>);
static_assert(!CanSet<Mix, Weight, double>, "another type");
static_assert(!CanSet<ProgramWith<shaders::mix_frag>, Weight, float>, "another program's");
static_assert(std::convertible_to<Mix, ProgramWith<shaders::mix_vert>>);
static_assert(!std::convertible_to<ProgramWith<shaders::mix_vert>, Mix>, "one file is not there");

TEST_F(ShaderVariablesTest, arrive_in_the_program) {
  auto carve = ComputeProgram<shaders::carve_comp>::create();
  ASSERT_TRUE(carve.ok()) << carve.error().message;
  using shaders::carve_comp;
  carve->set(carve_comp::other_radial, {1, 2, 3});
  std::array<float, 3> radial{};
  glGetUniformfv(carve->name(), carve_comp::other_radial.location, radial.data());
  EXPECT_EQ(radial, (std::array<float, 3>{1, 2, 3}));
  const glsl::mat4 other_from_depth = glsl::mat4::Random();
  carve->set(carve_comp::other_from_depth, other_from_depth);
  glsl::mat4 read;
  glGetUniformfv(carve->name(), carve_comp::other_from_depth.location, read.data());
  EXPECT_EQ(read, other_from_depth);
}

struct NoShader {
  static constexpr std::string_view text = "no shader";
  static constexpr std::array<int, 2> local_size{1, 1};
};
struct SoundAndBroken {
  ComputeProgram<shaders::carve_comp> sound;
  ComputeProgram<NoShader> broken;
};

TEST_F(ShaderVariablesTest, parts_are_created_all_or_none) {
  EXPECT_EQ(create_parts(&SoundAndBroken::sound, &SoundAndBroken::broken).error().code,
            ErrorCode::kUnsupported);
}

}  // namespace
}  // namespace roomcast::render
