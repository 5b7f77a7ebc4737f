// SPDX-License-Identifier: Apache-2.0
// MeshWriter: fuses the still surfaces of a recording into one model (model/) and writes it as a
// mesh: OUT/room.glb and others. Files are written completely or not at all. Single-threaded;
// finish() works on all cores.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "roomcast/core/parallel_rows.h"
#include "roomcast/model/model_options.h"
#include "roomcast/model/room_mesh.h"
#include "roomcast/recording/export/set_writer.h"
#include "roomcast/recording/mesh/mesh_files.h"
#include "roomcast/recording/mesh/room_views.h"

namespace roomcast::recording {

struct MeshWriterOptions {
  model::ModelOptions model;
  std::vector<MeshFile> files = {MeshFile::kGlb};
  bool colored_only = false;  // leaves out surfaces whose colour no sensor saw; else they are grey
  std::optional<Eigen::AlignedBox3f> crop_m;  // triangles that reach outside are left out
};

/// Done and total steps of one part of the work. Called by one thread at a time.
using MeshProgress =
    std::function<void(std::string_view doing, std::size_t done, std::size_t total)>;

/// The mesh of what was gathered, with colours. kNotFound if there is none: no sensor is placed, or
/// none sees a surface; errors of fuse_views.
[[nodiscard]] Result<model::RoomMesh> mesh_room(RoomViews& views, const MeshWriterOptions& options,
                                                const MeshProgress& progress,
                                                const std::stop_token& stop);

/// The mesh of these views, with colours. kNotFound if they show no surface; errors of fuse_views.
[[nodiscard]] Result<model::RoomMesh> mesh_surfaces(std::span<const model::ViewSurface> surfaces,
                                                    const MeshWriterOptions& options,
                                                    const MeshProgress& progress,
                                                    const Workers& workers);

/// Creates the folder `out`. finish() makes the mesh and writes the files, unless `stop` was
/// requested or add() failed. kInvalidArgument for options out of range; kUnavailable if the folder
/// cannot be made.
[[nodiscard]] Result<std::unique_ptr<SetWriter>> make_mesh_writer(
    const std::filesystem::path& out, const std::vector<SetSensor>& sensors,
    MeshWriterOptions options, MeshProgress progress = {}, std::stop_token stop = {});

}  // namespace roomcast::recording
