// SPDX-License-Identifier: Apache-2.0
#include "bench/model/model_bench.h"

#include <utility>

#include <fmt/format.h>

#include "bench/model/mesh_depth.h"
#include "bench/render/drawing_cost.h"
#include "roomcast/io/file_bytes.h"
#include "roomcast/io/image_file.h"
#include "roomcast/io/new_folder.h"
#include "roomcast/model/pieces/decoded_model.h"
#include "roomcast/model/pieces/draco_mesh.h"
#include "roomcast/model/volume_mesh.h"
#include "roomcast/recording/export/set_writer.h"
#include "roomcast/recording/mesh/room_views.h"

namespace roomcast::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxKeptBytes = 100'000'000;

Result<std::vector<StillTruth>> sensor_truths(const fs::path& rig,
                                              const std::vector<recording::SetSensor>& sensors) {
  const auto description = recording::read_rig_json(rig / "rig.json");
  if (!description) return description.error();
  std::vector<StillTruth> truths;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    auto truth = read_sensor_truth(rig, description->sensors[i], sensors[i].depth);
    if (!truth) return truth.error();
    truths.push_back(*std::move(truth));
  }
  return truths;
}

struct Gathered {
  recording::RoomViews views;
  std::vector<StillTruth> truths;  // of the sensors
  double cpu_ms = 0;
};

Result<Gathered> gather(const fs::path& rig, const ModelBenchOptions& options,
                        const std::function<void(const std::string&)>& progress) {
  auto reader = recording::open_frame_sets(rig);
  if (!reader) return reader.error();
  auto truths = sensor_truths(rig, (*reader)->sensors());
  if (!truths) return truths.error();
  Gathered gathered{recording::RoomViews((*reader)->sensors(), options.model), *std::move(truths)};
  recording::FrameSet set;
  for (;;) {
    const auto more = (*reader)->next(set);
    if (!more) return more.error();
    if (!*more) return gathered;
    progress(fmt::format("{}: frame set {}", rig.string(), set.number));
    const double before_ms = process_cpu_ms();
    if (auto status = gathered.views.add(set); !status) return status.error();
    gathered.cpu_ms += process_cpu_ms() - before_ms;
    for (const recording::SetFrame& frame : set.frames)
      add_readings(frame.pictures->depth_mm, gathered.truths[frame.sensor]);
  }
}

/// `pictures`: where to write them, up to their number; empty for nowhere.
Result<ScoreFigures> score(const model::RoomMesh& mesh, const std::vector<StillTruth>& truths,
                           const std::string& pictures) {
  SurfaceScore score;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const StillTruth& truth = truths[i];
    const ColorImage picture =
        add_score(mesh_depth_m(mesh, truth.camera, truth.world_from_camera), truth, score);
    if (pictures.empty()) continue;
    if (auto status = io::write_color_png(fmt::format("{}{}.png", pictures, i), picture); !status)
      return status.error();
  }
  return figures_of(std::move(score));
}

Result<ModelRow> add_scores(const fs::path& rig, const model::RoomMesh& mesh,
                            const std::vector<StillTruth>& truths, const ModelBenchOptions& options,
                            ModelRow row) {
  std::string pictures;
  if (options.pictures) {
    if (auto status = io::make_folder(*options.pictures); !status) return status.error();
    pictures = (*options.pictures / row.rig).string();
  }
  const auto sensors = score(mesh, truths, pictures.empty() ? "" : pictures + "-s");
  if (!sensors) return sensors.error();
  row.sensors = *sensors;
  const auto views = read_view_truths(rig, truths);
  if (!views) return views.error();
  const auto free = score(mesh, *views, pictures.empty() ? "" : pictures + "-view");
  if (!free) return free.error();
  row.free = *free;
  return row;
}

/// Counts the bytes; with `keep` the mesh is the compressed one from here on.
Status compress(bool keep, model::RoomMesh& mesh, ModelRow& row) {
  const auto coded = model::encode_draco(mesh);
  if (!coded) return coded.error();
  row.file_bytes = coded->bytes.size();
  if (!keep) return {};
  auto decoded = model::decode_draco(coded->bytes);
  if (!decoded) return decoded.error();
  mesh = *std::move(decoded);
  return {};
}

/// The pieces as one mesh.
Result<model::RoomMesh> read_kept(const fs::path& file) {
  std::vector<std::uint8_t> bytes;
  if (auto status = io::read_file(file, kMaxKeptBytes, bytes); !status) return status.error();
  const auto model = model::decode_model(bytes);
  if (!model) return model.error();
  model::RoomMesh mesh;
  for (const model::DecodedModel::Piece& piece : model->pieces) {
    const auto first = static_cast<std::uint32_t>(mesh.points_m.size());
    mesh.points_m.insert(mesh.points_m.end(), piece.mesh.points_m.begin(),
                         piece.mesh.points_m.end());
    mesh.colors.insert(mesh.colors.end(), piece.mesh.colors.begin(), piece.mesh.colors.end());
    for (const auto& [a, b, c] : piece.mesh.triangles)
      mesh.triangles.push_back({first + a, first + b, first + c});
  }
  return mesh;
}

Result<ModelRow> measure_kept(const fs::path& rig, const ModelBenchOptions& options,
                              Gathered gathered, ModelRow row) {
  const auto mesh = read_kept(*options.kept);
  if (!mesh) return mesh.error();
  row.views = gathered.views.views();
  row.points = mesh->points_m.size();
  row.triangles = mesh->triangles.size();
  std::error_code error;
  row.file_bytes = fs::file_size(*options.kept, error);
  return add_scores(rig, *mesh, gathered.truths, options, row);
}

Result<ModelRow> measure(const fs::path& rig, const ModelBenchOptions& options,
                         const std::function<void(const std::string&)>& progress) {
  auto gathered = gather(rig, options, progress);
  if (!gathered) return gathered.error();
  ModelRow row;
  row.rig = rig.lexically_normal().filename().string();
  row.frames = gathered->views.frames();
  row.frame_cpu_ms = gathered->cpu_ms / static_cast<double>(std::max<std::size_t>(1, row.frames));
  if (options.kept) return measure_kept(rig, options, *std::move(gathered), row);
  progress(row.rig + ": fusing");
  const double before_ms = process_cpu_ms();
  const auto surfaces = gathered->views.take_surfaces();
  row.views = surfaces.size();
  const auto volume = model::fuse_views(surfaces, options.model);
  if (!volume) return volume.error();
  model::RoomMesh mesh = model::mesh_volume(*volume);
  model::remove_small_parts(options.model.min_triangles, mesh);
  const auto shared = model::shared_colors(surfaces, options.model, {}, mesh);
  const auto gains = model::color_gains(shared, surfaces.size());
  model::color_mesh(surfaces, gains, options.model, {}, mesh);
  row.fuse_cpu_s = 0.001 * (process_cpu_ms() - before_ms);
  row.colors = color_steps(shared, surfaces.size());
  row.volume_bytes = volume->bytes();
  if (auto status = compress(options.compressed, mesh, row); !status) return status.error();
  row.points = mesh.points_m.size();
  row.triangles = mesh.triangles.size();
  return add_scores(rig, mesh, gathered->truths, options, row);
}

}  // namespace

Result<std::vector<ModelRow>> run_model_bench(
    const ModelBenchOptions& options, const std::function<void(const std::string&)>& progress) {
  if (options.kept && options.rigs.size() != 1)
    return invalid_argument("--kept is the model of one rig");
  std::vector<ModelRow> rows;
  for (const fs::path& rig : options.rigs) {
    auto row = measure(rig, options, progress);
    if (!row) return row.error();
    rows.push_back(*std::move(row));
  }
  return rows;
}

}  // namespace roomcast::bench
