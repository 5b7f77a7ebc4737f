// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/window/desktop_input.h"

#include <SDL2/SDL.h>
#include <gtest/gtest.h>

namespace roomcast::viewer {
namespace {

SDL_Event key_event(SDL_Scancode code, SDL_Keycode sym, bool down, int mod = KMOD_NONE) {
  SDL_Event event{};
  event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
  event.key.keysym.scancode = code;
  event.key.keysym.sym = sym;
  event.key.keysym.mod = static_cast<Uint16>(mod);
  return event;
}

SDL_Event motion_event(int dx, int dy, Uint32 buttons) {
  SDL_Event event{};
  event.type = SDL_MOUSEMOTION;
  event.motion.x = 100 + dx;
  event.motion.y = 50 + dy;
  event.motion.xrel = dx;
  event.motion.yrel = dy;
  event.motion.state = buttons;
  return event;
}

SDL_Event wheel_event(float notches) {
  SDL_Event event{};
  event.type = SDL_MOUSEWHEEL;
  event.wheel.preciseY = notches;
  return event;
}

SDL_Event axis_event(SDL_GameControllerAxis axis, int value) {
  SDL_Event event{};
  event.type = SDL_CONTROLLERAXISMOTION;
  event.caxis.axis = static_cast<Uint8>(axis);
  event.caxis.value = static_cast<Sint16>(value);
  return event;
}

class DesktopInputTest : public testing::Test {
 protected:
  std::optional<ViewerCommand> take(const SDL_Event& event) {
    return input.take(event, {720, 1}, navigation);
  }

  const ViewState start = look_from({0, 1.6, 0}, {0, 1.6, -2});
  Navigation navigation{start};
  DesktopInput input;
};

TEST_F(DesktopInputTest, w_walks_until_it_is_released) {
  EXPECT_FALSE(take(key_event(SDL_SCANCODE_W, SDLK_w, true)));
  EXPECT_TRUE(navigation.is_walking());
  EXPECT_FALSE(take(key_event(SDL_SCANCODE_W, SDLK_w, false)));
  EXPECT_FALSE(navigation.is_walking());
}

TEST_F(DesktopInputTest, walking_keys_are_at_the_same_place_on_any_keyboard) {
  EXPECT_FALSE(take(key_event(SDL_SCANCODE_W, SDLK_z, true)));  // a French keyboard
  EXPECT_TRUE(navigation.is_walking());
}

TEST_F(DesktopInputTest, arrows_turn_and_look_up_and_down_as_on_the_page) {
  constexpr double kTurned_rad = 0.1 * 1.2;
  const std::pair<SDL_Scancode, Eigen::Vector2d> arrows[] = {
      {SDL_SCANCODE_LEFT, {kTurned_rad, 0}},
      {SDL_SCANCODE_RIGHT, {-kTurned_rad, 0}},
      {SDL_SCANCODE_UP, {0, kTurned_rad}},
      {SDL_SCANCODE_DOWN, {0, -kTurned_rad}}};
  for (const auto& [key, turn] : arrows) {
    navigation.go_to(start);
    EXPECT_FALSE(take(key_event(key, SDL_SCANCODE_TO_KEYCODE(key), true)));
    navigation.advance(0.1);
    EXPECT_FALSE(take(key_event(key, SDL_SCANCODE_TO_KEYCODE(key), false)));
    navigation.advance(0.1);
    EXPECT_NEAR(navigation.view().yaw_rad, start.yaw_rad + turn.x(), 1e-9);
    EXPECT_NEAR(navigation.view().pitch_rad, start.pitch_rad + turn.y(), 1e-9);
    EXPECT_EQ(navigation.view().position_m, start.position_m);
  }
}

TEST_F(DesktopInputTest, a_window_that_loses_the_keyboard_stands_still) {
  EXPECT_FALSE(take(key_event(SDL_SCANCODE_W, SDLK_w, true)));
  EXPECT_FALSE(take(key_event(SDL_SCANCODE_L, SDLK_l, true)));
  EXPECT_FALSE(take(key_event(SDL_SCANCODE_SPACE, SDLK_SPACE, true)));
  EXPECT_TRUE(input.is_pointing());
  EXPECT_TRUE(input.is_talking());
  SDL_Event lost{};
  lost.type = SDL_WINDOWEVENT;
  lost.window.event = SDL_WINDOWEVENT_FOCUS_LOST;
  EXPECT_FALSE(take(lost));
  EXPECT_FALSE(navigation.is_walking());
  EXPECT_FALSE(input.is_pointing());
  EXPECT_FALSE(input.is_talking());
}

TEST_F(DesktopInputTest, the_space_bar_talks_while_it_is_held) {
  EXPECT_FALSE(take(key_event(SDL_SCANCODE_SPACE, SDLK_SPACE, true)));
  EXPECT_TRUE(input.is_talking());
  EXPECT_FALSE(take(key_event(SDL_SCANCODE_SPACE, SDLK_SPACE, false)));
  EXPECT_FALSE(input.is_talking());
  EXPECT_EQ(take(key_event(SDL_SCANCODE_T, SDLK_t, true)), ViewerCommand::kMicrophone);
}

TEST_F(DesktopInputTest, keys_give_the_commands_in_the_help) {
  EXPECT_EQ(take(key_event(SDL_SCANCODE_R, SDLK_r, true)), ViewerCommand::kStart);
  EXPECT_EQ(take(key_event(SDL_SCANCODE_5, SDLK_5, true)), ViewerCommand::kModeBlend);
  EXPECT_EQ(take(key_event(SDL_SCANCODE_6, SDLK_6, true)), ViewerCommand::kModeStill);
  EXPECT_EQ(take(key_event(SDL_SCANCODE_P, SDLK_p, true)), ViewerCommand::kScreenshot);
  EXPECT_EQ(take(key_event(SDL_SCANCODE_ESCAPE, SDLK_ESCAPE, true)), ViewerCommand::kRelease);
  EXPECT_EQ(take(key_event(SDL_SCANCODE_Q, SDLK_q, true, KMOD_LCTRL)), ViewerCommand::kQuit);
  EXPECT_FALSE(take(key_event(SDL_SCANCODE_R, SDLK_r, false))) << "once, when it goes down";
  EXPECT_FALSE(take(key_event(SDL_SCANCODE_P, SDLK_p, true, KMOD_LCTRL))) << "not ours";
  SDL_Event quit{};
  quit.type = SDL_QUIT;
  EXPECT_EQ(take(quit), ViewerCommand::kQuit);
}

TEST_F(DesktopInputTest, a_mouse_without_a_button_moves_nothing_but_its_place_is_known) {
  EXPECT_FALSE(take(motion_event(20, 10, 0)));
  EXPECT_EQ(navigation.view().yaw_rad, start.yaw_rad);
  EXPECT_EQ(input.mouse().x, 120);
}

TEST_F(DesktopInputTest, the_left_button_orbits_and_the_right_one_pans) {
  EXPECT_FALSE(take(motion_event(20, 0, SDL_BUTTON_LMASK)));
  EXPECT_LT((pivot_m(navigation.view()) - pivot_m(start)).norm(), 1e-9);
  EXPECT_NE(navigation.view().yaw_rad, start.yaw_rad);
  navigation.go_to(start);
  EXPECT_FALSE(take(motion_event(20, 0, SDL_BUTTON_RMASK)));
  EXPECT_EQ(navigation.view().yaw_rad, start.yaw_rad);
  EXPECT_LT(navigation.view().position_m.x(), 0);
}

TEST_F(DesktopInputTest, a_captured_mouse_looks_and_its_wheel_sets_the_speed) {
  input.set_mouse_look(true);
  EXPECT_FALSE(take(motion_event(20, 0, 0)));
  EXPECT_EQ(navigation.view().position_m, start.position_m);
  EXPECT_LT(navigation.view().yaw_rad, 0);
  EXPECT_FALSE(take(wheel_event(2)));
  EXPECT_GT(navigation.speed_m_per_s(), kWalkSpeed_m_per_s);
  input.set_mouse_look(false);
  EXPECT_FALSE(take(wheel_event(2)));
  EXPECT_LT(navigation.view().pivot_distance_m, start.pivot_distance_m);
}

TEST_F(DesktopInputTest, a_gamepads_sticks_walk_and_its_triggers_lift) {
  EXPECT_FALSE(take(axis_event(SDL_CONTROLLER_AXIS_LEFTY, -32768)));
  EXPECT_FALSE(take(axis_event(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 32767)));
  navigation.advance(0.1);
  EXPECT_LT(navigation.view().position_m.z(), -0.1);
  EXPECT_GT(navigation.view().position_m.y(), 1.7);
  SDL_Event gone{};
  gone.type = SDL_CONTROLLERDEVICEREMOVED;
  EXPECT_FALSE(take(gone));
  EXPECT_FALSE(navigation.is_walking());
}

TEST_F(DesktopInputTest, a_gamepads_button_points_while_it_is_held) {
  SDL_Event button{};
  button.type = SDL_CONTROLLERBUTTONDOWN;
  button.cbutton.button = SDL_CONTROLLER_BUTTON_A;
  EXPECT_FALSE(take(button));
  EXPECT_TRUE(input.is_pointing());
  button.type = SDL_CONTROLLERBUTTONUP;
  EXPECT_FALSE(take(button));
  EXPECT_FALSE(input.is_pointing());
}

}  // namespace
}  // namespace roomcast::viewer
