// SPDX-License-Identifier: Apache-2.0
// docs/guides/metrics.md names every metric that a hub exports, and the dashboard in
// packaging/grafana uses no others.
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/hub/server/metrics_text.h"

namespace roomcast::hub {
namespace {

const std::filesystem::path kRoot = ROOMCAST_SOURCE_DIR;

struct Metric {
  std::string type;
  std::string unit;
  std::set<std::string> labels = {};
  bool operator==(const Metric&) const = default;
};
using Metrics = std::map<std::string, Metric>;

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<std::smatch> all_in(const std::string& text, const std::regex& wanted) {
  return {std::sregex_iterator(text.begin(), text.end(), wanted), std::sregex_iterator()};
}

/// The unit in a metric's name, by the naming convention of Prometheus.
std::string unit_in(const std::string& name) {
  if (name.find("_per_second") != std::string::npos)
    return name.find("_bytes") != std::string::npos ? "bytes/s" : "1/s";
  if (name.find("_seconds") != std::string::npos) return "s";
  return name.find("_bytes") != std::string::npos ? "bytes" : "";
}

/// The metrics of a hub with a sensor, a viewer and a backplane.
Metrics printed() {
  std::array<RoomStats, 1> rooms{RoomStats{.room = "lab"}};
  rooms[0].sensors.push_back({.name = "left", .clock_error_s = 0.001});
  rooms[0].viewers.push_back({.id = ViewerId{1}, .name = "Ada"});
  const std::string text = metrics_text({.backplane = BackplaneStats{}}, rooms);
  Metrics metrics;
  for (const auto& type : all_in(text, std::regex("# TYPE (\\S+) (\\S+)")))
    metrics[type[1]] = {.type = type[2], .unit = unit_in(type[1])};
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    const std::string name = line.substr(0, line.find_first_of("{ "));
    EXPECT_TRUE(metrics.contains(name)) << line << " has no type";
    for (const auto& label : all_in(line, std::regex("(\\w+)=\""))) {
      metrics[name].labels.insert(label[1]);
    }
  }
  return metrics;
}

/// Rows of the tables: | `name` | type | unit | labels | meaning |
Metrics documented() {
  const std::string page = read_text(kRoot / "docs" / "guides" / "metrics.md");
  const std::regex row(R"(\| `(\w+)` \| (\w*) \| ([\w/]*) ?\| ([\w, `]*) ?\| \S[^\n]*\|)");
  Metrics metrics;
  for (const auto& cells : all_in(page, row)) {
    Metric& metric = metrics[cells[1]];
    metric = {.type = cells[2], .unit = cells[3]};
    const std::string labels = cells[4];
    for (const auto& label : all_in(labels, std::regex("`(\\w+)`"))) metric.labels.insert(label[1]);
  }
  return metrics;
}

TEST(MetricsGuide, documents_exactly_the_printed_metrics) {
  const Metrics page = documented(), hub = printed();
  ASSERT_GT(hub.size(), 20U);
  for (const auto& [name, metric] : hub) {
    const auto row = page.find(name);
    ASSERT_NE(row, page.end()) << name << " is not documented";
    EXPECT_EQ(row->second.type, metric.type) << name;
    EXPECT_EQ(row->second.unit, metric.unit) << name;
    EXPECT_EQ(row->second.labels, metric.labels) << name;
  }
  for (const auto& [name, metric] : page) EXPECT_TRUE(hub.contains(name)) << name << " is no more";
}

TEST(MetricsGuide, dashboard_uses_printed_metrics_only) {
  const std::string dashboard = read_text(kRoot / "packaging" / "grafana" / "roomcast.json");
  const Metrics hub = printed();
  std::set<std::string> asked;
  for (const auto& expression : all_in(dashboard, std::regex(R"re("expr": "([^\n]*)")re"))) {
    const std::string text = expression[1];
    for (const auto& name : all_in(text, std::regex("\\b(?:roomcast|process)_\\w+"))) {
      asked.insert(name[0]);
      EXPECT_TRUE(hub.contains(name[0])) << name[0];
    }
  }
  for (const char* wanted :
       {"roomcast_viewer_dropped_sets_total", "roomcast_viewer_shown_per_second",
        "roomcast_sensor_clock_error_seconds", "roomcast_sensor_dropped_frames_total",
        "roomcast_backplane_other_hubs", "roomcast_backplane_links_up"}) {
    EXPECT_TRUE(asked.contains(wanted)) << wanted;
  }
}

}  // namespace
}  // namespace roomcast::hub
