// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/film/film_sound.h"

#include <fstream>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::recording {
namespace {

TEST(FilmSound, that_cannot_be_added_leaves_the_film_as_it_is) {
  const TemporaryFolder folder;
  std::ofstream(folder / "film.mp4") << "no film";
  std::ofstream(folder / "voices.wav") << "no sound";
  EXPECT_EQ(add_sound(folder / "film.mp4", folder / "voices.wav").error().code,
            ErrorCode::kUnavailable);
  std::ifstream film(folder / "film.mp4");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(film), {}), "no film");
  EXPECT_FALSE(std::filesystem::exists(folder / "film.part.mp4"));
}

}  // namespace
}  // namespace roomcast::recording
