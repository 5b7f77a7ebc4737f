// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/admin_routes.h"

#include <cctype>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsSupersetOf;

std::optional<MatchedRoute> find(std::string_view method, std::string_view path) {
  const auto found = match_admin_route(method, path);
  const auto* match = std::get_if<MatchedRoute>(&found);
  return match == nullptr ? std::nullopt : std::optional(*match);
}

std::ifstream specification() {
  return std::ifstream(std::string(ROOMCAST_SOURCE_DIR) + "/docs/spec/admin.openapi.yaml");
}

/// The components that the specification defines, as "#/components/schemas/Error": the names two
/// levels below `components:`, indented by four spaces.
std::set<std::string> specified_components() {
  std::ifstream file = specification();
  std::set<std::string> components;
  std::string top, kind;
  for (std::string line; std::getline(file, line);) {
    const auto indent = line.find_first_not_of(' ');
    if (indent == std::string::npos || line[indent] == '#') continue;
    const std::string name = line.substr(indent, line.find(':') - indent);
    if (indent == 0) top = name;
    if (indent == 2) kind = name;
    if (indent == 4 && top == "components") components.insert("#/components/" + kind + "/" + name);
  }
  return components;
}

/// The targets of all `$ref: "..."` in the specification.
std::set<std::string> specified_references() {
  std::ifstream file = specification();
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::string before = "$ref: \"";
  std::set<std::string> references;
  for (auto at = text.find(before); at != std::string::npos; at = text.find(before, at)) {
    at += before.size();
    references.insert(text.substr(at, text.find('"', at) - at));
  }
  return references;
}

/// The routes in the specification, as "GET /rooms". There a path is indented by two spaces, a
/// method by four.
std::set<std::string> specified_routes() {
  const std::set<std::string> methods = {"get", "post", "put", "patch", "delete"};
  std::ifstream file = specification();
  std::set<std::string> routes;
  std::string path;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("  /") && line.ends_with(":")) path = line.substr(2, line.size() - 3);
    if (!line.starts_with("    ") || !line.ends_with(":") || path.empty()) continue;
    std::string method = line.substr(4, line.size() - 5);
    if (!methods.contains(method)) continue;
    for (char& c : method) c = static_cast<char>(std::toupper(c));
    routes.insert(method + " " + path);
  }
  return routes;
}

TEST(AdminRoutes, match_the_specification) {
  std::set<std::string> routes;
  for (const AdminRoute& route : admin_routes()) {
    routes.insert(std::string(route.method) + " " + std::string(route.path));
  }
  EXPECT_EQ(routes, specified_routes());
}

TEST(AdminRoutes, specification_defines_all_that_it_references) {
  EXPECT_FALSE(specified_references().empty());
  EXPECT_THAT(specified_components(), IsSupersetOf(specified_references()));
}

TEST(AdminRoutes, are_found_with_their_parameters) {
  const auto end = find("DELETE", "/api/v1/rooms/my%20lab/sensors/left%2Fright");
  ASSERT_TRUE(end);
  EXPECT_EQ(end->route.call, AdminCall::kEndSensor);
  EXPECT_THAT(end->parameters, ElementsAre("my lab", "left/right"));
  EXPECT_THAT(find("GET", "/api/v1/rooms")->parameters, IsEmpty());
}

TEST(AdminRoutes, an_unknown_path_differs_from_an_unsupported_method) {
  EXPECT_EQ(std::get<NoRoute>(match_admin_route("GET", "/api/v1/nothing")), NoRoute::kUnknownPath);
  EXPECT_EQ(std::get<NoRoute>(match_admin_route("GET", "/api/v2/rooms")), NoRoute::kUnknownPath);
  EXPECT_EQ(std::get<NoRoute>(match_admin_route("GET", "/api/v1/rooms/")), NoRoute::kUnknownPath);
  EXPECT_EQ(std::get<NoRoute>(match_admin_route("GET", "/api/v1/rooms/a/b")),
            NoRoute::kUnknownPath);
  EXPECT_EQ(std::get<NoRoute>(match_admin_route("PUT", "/api/v1/rooms")), NoRoute::kUnknownMethod);
}

}  // namespace
}  // namespace roomcast::hub
