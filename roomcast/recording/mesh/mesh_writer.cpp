// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/mesh/mesh_writer.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "roomcast/io/file_bytes.h"
#include "roomcast/io/new_folder.h"
#include "roomcast/model/color_gains.h"
#include "roomcast/model/volume_mesh.h"

namespace roomcast::recording {
namespace {

class MeshWriter final : public SetWriter {
 public:
  MeshWriter(std::filesystem::path out, const std::vector<SetSensor>& sensors,
             MeshWriterOptions options, MeshProgress progress, std::stop_token stop)
      : out_(std::move(out)),
        options_(std::move(options)),
        progress_(std::move(progress)),
        stop_(std::move(stop)),
        views_(sensors, options_.model) {}

  Status add(const FrameSet& set) override {
    ++totals_.sets;
    const Status status = views_.add(set);
    failed_ = failed_ || !status;
    return status;
  }

  Status finish() override {
    if (stop_.stop_requested() || failed_ || totals_.sets == 0) return {};
    const auto mesh = mesh_room(views_, options_, progress_, stop_);
    if (!mesh) return mesh.error();
    totals_.points = mesh->points_m.size();
    totals_.triangles = mesh->triangles.size();
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i < options_.files.size(); ++i) {
      if (progress_) progress_("writing files", i, options_.files.size());
      bytes.clear();
      if (auto status = append_mesh(*mesh, options_.files[i], bytes); !status) return status;
      const std::string name = "room." + std::string(ending_of(options_.files[i]));
      if (auto status = io::write_file(out_ / name, bytes); !status) return status;
    }
    return {};
  }

  ExportTotals totals() const override { return totals_; }

 private:
  const std::filesystem::path out_;
  const MeshWriterOptions options_;
  const MeshProgress progress_;
  const std::stop_token stop_;
  RoomViews views_;
  ExportTotals totals_;
  bool failed_ = false;
};

void crop(const Eigen::AlignedBox3f& box_m, model::RoomMesh& mesh) {
  std::erase_if(mesh.triangles, [&](const auto& triangle) {
    return std::ranges::any_of(
        triangle, [&](std::uint32_t point) { return !box_m.contains(mesh.points_m[point]); });
  });
}

}  // namespace

Result<model::RoomMesh> mesh_room(RoomViews& views, const MeshWriterOptions& options,
                                  const MeshProgress& progress, const std::stop_token& stop) {
  if (views.views() == 0)
    return Error{ErrorCode::kNotFound,
                 "no sensor of this recording is placed; align a rig with roomcast align --write"};
  return mesh_surfaces(views.take_surfaces(), options, progress, Workers(0, stop));
}

Result<model::RoomMesh> mesh_surfaces(std::span<const model::ViewSurface> surfaces,
                                      const MeshWriterOptions& options,
                                      const MeshProgress& progress, const Workers& workers) {
  const auto fusing = [&](std::size_t done, std::size_t total) {
    if (progress) progress("fusing surfaces", done, total);
  };
  const auto volume = model::fuse_views(surfaces, options.model, workers, fusing);
  if (!volume) return volume.error();
  model::RoomMesh mesh = model::mesh_volume(*volume);
  if (options.crop_m) crop(*options.crop_m, mesh);
  model::remove_small_parts(options.model.min_triangles, mesh);
  if (mesh.triangles.empty())
    return Error{ErrorCode::kNotFound,
                 "no surface that stands still is shown; choose another part of the recording, or "
                 "another --crop"};
  const auto shared = model::shared_colors(surfaces, options.model, workers, mesh);
  const auto gains = model::color_gains(shared, surfaces.size());
  model::color_mesh(surfaces, gains, options.model, workers, mesh);
  if (workers.stop.stop_requested()) return Error{ErrorCode::kClosed, "interrupted"};
  if (options.colored_only) model::remove_uncolored(mesh);
  return mesh;
}

Result<std::unique_ptr<SetWriter>> make_mesh_writer(const std::filesystem::path& out,
                                                    const std::vector<SetSensor>& sensors,
                                                    MeshWriterOptions options,
                                                    MeshProgress progress, std::stop_token stop) {
  if (auto status = options.model.check(); !status) return status.error();
  if (options.crop_m && options.crop_m->isEmpty())
    return invalid_argument("the crop box is empty; give two opposite corners");
  if (auto status = io::make_folder(out); !status) return status.error();
  return std::unique_ptr<SetWriter>(std::make_unique<MeshWriter>(
      out, sensors, std::move(options), std::move(progress), std::move(stop)));
}

}  // namespace roomcast::recording
