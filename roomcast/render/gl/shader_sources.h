// SPDX-License-Identifier: Apache-2.0
// The text of every file in shaders/. embed_shaders.cmake compiles it in, so the program needs no
// shader files at run time. Dots in a file's name become underscores.
#pragma once

#include <string_view>

namespace roomcast::render::shaders {

extern const std::string_view adaptive_frag;
extern const std::string_view adaptive_mesh_comp;
extern const std::string_view adaptive_vert;
extern const std::string_view background_depth_comp;
extern const std::string_view blend_in_view_glsl;
extern const std::string_view blend_surface_glsl;
extern const std::string_view carve_comp;
extern const std::string_view cover_lost_comp;
extern const std::string_view depth_noise_glsl;
extern const std::string_view edge_distance_comp;
extern const std::string_view extend_edges_comp;
extern const std::string_view eyes_glsl;
extern const std::string_view fill_small_comp;
extern const std::string_view floor_grid_frag;
extern const std::string_view floor_grid_vert;
extern const std::string_view grow_comp;
extern const std::string_view judge_lost_comp;
extern const std::string_view mesh_frag;
extern const std::string_view mesh_gather_comp;
extern const std::string_view mesh_offsets_comp;
extern const std::string_view mesh_vert;
extern const std::string_view mix_frag;
extern const std::string_view mix_vert;
extern const std::string_view nearest_frag;
extern const std::string_view nearest_vert;
extern const std::string_view newest_in_view_glsl;
extern const std::string_view points_frag;
extern const std::string_view points_vert;
extern const std::string_view quality_comp;
extern const std::string_view remember_background_comp;
extern const std::string_view resolve_frag;
extern const std::string_view sensor_surface_glsl;
extern const std::string_view shrink_comp;
extern const std::string_view shrink_picture_comp;
extern const std::string_view smooth_comp;
extern const std::string_view still_color_comp;
extern const std::string_view surface_mesh_comp;
extern const std::string_view surface_view_glsl;
extern const std::string_view surroundings_comp;
extern const std::string_view weighted_color_comp;
extern const std::string_view whole_picture_vert;

}  // namespace roomcast::render::shaders
