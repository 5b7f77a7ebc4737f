// SPDX-License-Identifier: Apache-2.0
#include "bench/model/model_bench.h"

#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/io/file_bytes.h"
#include "roomcast/io/image_file.h"
#include "roomcast/model/pieces/draco_mesh.h"
#include "roomcast/model/pieces/model_message.h"
#include "roomcast/recording/dataset/rig_writer.h"

namespace roomcast::bench {
namespace {

const CameraIntrinsics kSmallLens = {
    .width = 128, .height = 96, .fx = 100, .fy = 100, .cx = 63.5, .cy = 47.5};

class ModelBenchTest : public testing::Test {
 protected:
  /// One sensor before a wall that is 2 m away; a thing passes in the second frame.
  void write_rig() const {
    recording::RigSensor sensor;
    sensor.description.name = "s0";
    sensor.description.calibration.depth = sensor.description.calibration.color = kSmallLens;
    sensor.description.calibration.color_is_registered = true;
    sensor.description.world_from_depth = RigidTransform{};
    auto writer = recording::RigWriter::create(rig, 30, std::vector{sensor});
    ASSERT_TRUE(writer) << writer.error().message;
    source::CapturedFrame frame;
    for (; frame.index < 5; ++frame.index) {
      frame.depth_mm = DepthImage(kSmallLens.width, kSmallLens.height, 2000);
      frame.color = ColorImage(kSmallLens.width, kSmallLens.height, Rgb8{90, 90, 90});
      if (frame.index == 1)
        for (int x = 20; x < 60; ++x) frame.depth_mm.at(x, 50) = 1000;
      const nanoseconds time(33'333'333 * static_cast<std::int64_t>(frame.index + 1));
      ASSERT_TRUE(writer->add(0, frame, time));
    }
    ASSERT_TRUE(writer->finish());
  }

  void write_truth() const {
    std::filesystem::create_directories(rig / "truth" / "s0");
    const DepthImage depth(kSmallLens.width, kSmallLens.height, 2001);
    for (const char* name : {"000000.png", "000001.png", "000002.png"})
      ASSERT_TRUE(io::write_depth_png(rig / "truth" / "s0" / name, depth));
  }

  [[nodiscard]] Result<std::vector<ModelRow>> run(bool compressed = false) const {
    ModelBenchOptions options;
    options.compressed = compressed;
    options.rigs = {rig};
    return run_model_bench(options, [](const std::string&) {});
  }

  TemporaryFolder folder;
  std::filesystem::path rig = folder / "rig";
};

TEST_F(ModelBenchTest, compares_the_model_with_the_truth) {
  write_rig();
  write_truth();
  const auto rows = run();
  ASSERT_TRUE(rows) << rows.error().message;
  const ModelRow& row = rows->at(0);
  EXPECT_EQ(row.frames, 5u);
  EXPECT_EQ(row.views, 1u);
  EXPECT_NEAR(row.sensors.median_mm, 1, 0.2);
  EXPECT_GT(row.sensors.coverage, 0.97);  // the outermost cells are not known on all sides
  EXPECT_EQ(row.sensors.floating, 0);
  EXPECT_EQ(row.free.pixels, 0u);
  std::ostringstream json, table;
  print_json(*rows, json);
  print_table(*rows, table);
  EXPECT_EQ(nlohmann::json::parse(json.str())[0]["frames"], 5);
  EXPECT_NE(table.str().find("rig"), std::string::npos);
}

TEST_F(ModelBenchTest, looks_at_the_compressed_mesh) {
  write_rig();
  write_truth();
  const auto exact = run(), compressed = run(true);
  ASSERT_TRUE(compressed) << compressed.error().message;
  const ModelRow& row = compressed->at(0);
  EXPECT_EQ(row.triangles, exact->at(0).triangles);
  EXPECT_LT(row.file_bytes, 4 * row.triangles);
  EXPECT_GT(row.file_bytes, 1000u);
  EXPECT_NEAR(row.sensors.median_mm, 1, 0.9) << "points lie on a grid of 1.5 mm";
}

TEST_F(ModelBenchTest, looks_at_a_model_that_a_hub_has_given) {
  write_rig();
  write_truth();
  model::RoomMesh part;
  part.points_m = {{-0.5F, -0.5F, 2}, {0.5F, -0.5F, 2}, {0.5F, 0.5F, 2}, {-0.5F, 0.5F, 2}};
  part.colors.assign(4, {90, 90, 90});
  part.triangles = {{0, 2, 1}, {0, 3, 2}};
  const auto coded = model::encode_draco(part).value();
  ModelBenchOptions options;
  options.rigs = {rig};
  options.kept = folder / "model.rcm";
  ASSERT_TRUE(io::write_file(
      *options.kept, model::write_model_message(
                         {.is_whole = true,
                          .version = 1,
                          .pieces = {{{-1, 0, 1}, coded.bytes}, {{0, 0, 1}, coded.bytes}}})));
  const auto rows = run_model_bench(options, [](const std::string&) {});
  ASSERT_TRUE(rows) << rows.error().message;
  const ModelRow& row = rows->at(0);
  EXPECT_EQ(row.triangles, 4u);
  EXPECT_NEAR(row.sensors.median_mm, 1, 0.9);
  EXPECT_GT(row.sensors.coverage, 0.15);
  EXPECT_LT(row.sensors.coverage, 0.25) << "a square metre of a wall of 2.6 x 1.9 m";
  options.rigs = {rig, rig};
  EXPECT_FALSE(run_model_bench(options, [](const std::string&) {}));
}

TEST_F(ModelBenchTest, needs_the_truth) {
  write_rig();
  const auto rows = run();
  ASSERT_FALSE(rows);
  EXPECT_EQ(rows.error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace roomcast::bench
