// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/alignment_text.h"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace roomcast::cli {
namespace {

/// Two placed sensors and one that could not be connected with them.
alignment::AlignmentReport report() {
  alignment::AlignmentReport report;
  for (const char* id : {"s0", "s1"}) {
    alignment::SensorReport& sensor = report.sensors.emplace_back();
    sensor.id = id;
    sensor.placed = true;
    sensor.world_from_depth = RigidTransform();
    sensor.overlap = 0.4;
    sensor.inliers = 31;
    sensor.residual_mm = 3.25;
    sensor.reason = "placed";
  }
  alignment::SensorReport& apart = report.sensors.emplace_back();
  apart.id = "s2";
  apart.reason = "nothing is shared";

  alignment::PairReport& accepted = report.pairs.emplace_back();
  accepted.a = "s0";
  accepted.b = "s1";
  accepted.accepted = true;
  accepted.b_from_a = RigidTransform();
  accepted.residual_mm = 3.25;
  accepted.expected_error_mm = 4.5;
  accepted.reason = "31 places agree";
  alignment::PairReport& refused = report.pairs.emplace_back();
  refused.a = "s0";
  refused.b = "s2";
  refused.reason = "nothing is shared";
  return report;
}

TEST(AlignmentText, json_has_all_known_values_and_null_for_unknown_ones) {
  const auto json = nlohmann::json::parse(alignment_json(report()));
  const auto& sensor = json["sensors"][0];
  for (const char* key :
       {"id", "placed", "world_from_depth", "expected_error_mm", "expected_error_deg",
        "color_shift_px", "overlap", "inliers", "residual_mm", "reason"}) {
    EXPECT_TRUE(sensor.contains(key)) << key;
  }
  EXPECT_EQ(sensor["residual_mm"], 3.25);
  EXPECT_EQ(sensor["inliers"], 31);
  EXPECT_TRUE(json["sensors"][2]["residual_mm"].is_null());
  EXPECT_TRUE(json["sensors"][2]["world_from_depth"].is_null());

  const auto& pair = json["pairs"][0];
  for (const char* key : {"a", "b", "accepted", "b_from_a", "overlap", "inliers", "residual_mm",
                          "expected_error_mm", "conflict", "correlation", "margin", "reason"}) {
    EXPECT_TRUE(pair.contains(key)) << key;
  }
  EXPECT_EQ(pair["expected_error_mm"], 4.5);
  EXPECT_TRUE(json["pairs"][1]["residual_mm"].is_null());
  EXPECT_TRUE(json["pairs"][1]["expected_error_mm"].is_null());
}

TEST(AlignmentText, scripts_get_the_numbers_of_every_stage_on_request) {
  EXPECT_FALSE(nlohmann::json::parse(alignment_json(report())).contains("options"));
  const alignment::AlignmentOptions options;
  auto json = nlohmann::json::parse(alignment_json(report(), options));
  const nlohmann::json printed = json["options"];
  options.for_each_field([&](std::string_view stage, const auto& of_stage) {
    of_stage.for_each_field([&](std::string_view field, const auto&, auto...) {
      EXPECT_TRUE(printed[std::string(stage)].contains(std::string(field)))
          << stage << "." << field;
    });
  });
  EXPECT_EQ(printed["view"]["surface"]["noise"]["per_square_metre_m"], 0.0015);
  EXPECT_EQ(printed["rig"]["pair"]["coarse_voting"]["max_matches"], 4000);
  EXPECT_EQ(printed["trajectories"]["other_offsets_s"].size(), 6U);
  EXPECT_EQ(printed["pose_change"]["check_interval_ms"], 400);
  json.erase("options");
  EXPECT_EQ(json, nlohmann::json::parse(alignment_json(report())));
}

TEST(AlignmentText, the_table_has_no_figures_for_refused_pairs) {
  const std::string table = alignment_table(report());
  EXPECT_NE(table.find("3.2 mm"), std::string::npos) << table;
  EXPECT_NE(table.find("4.5 mm"), std::string::npos) << table;
  EXPECT_EQ(table.find("0.0 mm"), std::string::npos) << table;
  EXPECT_NE(table.find("nothing is shared"), std::string::npos) << table;
}

TEST(AlignmentText, says_what_is_known_of_calibrations) {
  alignment::AlignmentReport of_calibrated = report();
  of_calibrated.scale_error = 0.0025;
  EXPECT_EQ(alignment_table(of_calibrated).find("roomcast calibrate"), std::string::npos);
  EXPECT_EQ(alignment_table(of_calibrated).find("alike"), std::string::npos);

  alignment::AlignmentReport doubted = report();
  doubted.uncalibrated_belief = 0.9;
  EXPECT_NE(alignment_table(doubted).find("walks through all views"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(alignment_json(doubted))["uncalibrated_belief"], 0.9);

  doubted.sensors[1].depth_scale = 1.044;
  doubted.sensors[1].depth_scale_standard_error = 0.009;
  doubted.scale_error = 0.0173;
  const std::string table = alignment_table(doubted);
  EXPECT_NE(table.find("alike, by 1.7 %"), std::string::npos) << table;
  EXPECT_EQ(nlohmann::json::parse(alignment_json(doubted))["scale_error"], 0.0173);
  EXPECT_NE(table.find("multiplied by: s1 1.044 (+-0.009)."), std::string::npos) << table;
  EXPECT_NE(table.find("roomcast calibrate"), std::string::npos);
  EXPECT_EQ(table.find("walks through all views"), std::string::npos);
}

TEST(AlignmentText, the_factor_to_which_the_others_are_relative_has_no_error) {
  alignment::AlignmentReport scaled = report();
  scaled.sensors[0].depth_scale = 0.98;
  scaled.sensors[1].depth_scale = 1.02;
  scaled.sensors[1].depth_scale_standard_error = 0.009;
  const std::string table = alignment_table(scaled);
  const std::string first = scaled.sensors[0].id, second = scaled.sensors[1].id;
  EXPECT_NE(table.find("multiplied by: " + first + " 0.980, " + second +
                       " 1.020 (+-0.009). Errors are relative to " + first + "."),
            std::string::npos)
      << table;
  const auto json = nlohmann::json::parse(alignment_json(scaled));
  EXPECT_TRUE(json["sensors"][0]["depth_scale_standard_error"].is_null());
  EXPECT_EQ(json["sensors"][1]["depth_scale_standard_error"], 0.009);
}

}  // namespace
}  // namespace roomcast::cli
