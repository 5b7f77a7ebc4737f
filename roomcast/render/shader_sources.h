// SPDX-License-Identifier: Apache-2.0
// The text of every file in shaders/, put into the program by embed_shaders.cmake so that it needs
// no files at run time. Dots in a file's name become underscores.
#pragma once

#include <string_view>

namespace roomcast::shaders {

extern const std::string_view floor_grid_frag;
extern const std::string_view floor_grid_vert;
extern const std::string_view mesh_frag;
extern const std::string_view mesh_vert;
extern const std::string_view points_frag;
extern const std::string_view points_vert;
extern const std::string_view sensor_surface_glsl;
extern const std::string_view surface_mesh_comp;

}  // namespace roomcast::shaders
