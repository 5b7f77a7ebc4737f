// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/config/hub_config.h"

#include <fstream>
#include <iterator>
#include <map>

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

HubConfig parsed(std::string_view text) {
  const auto config = read_config({}, text);
  EXPECT_TRUE(config.ok()) << config.error().message;
  return config ? *config : HubConfig();
}

std::string config_fault(std::string_view text) {
  const auto config = read_config({}, text);
  return config ? "" : config.error().message;
}

TEST(HubConfig, reads_every_field) {
  const HubConfig config = parsed(R"(
listen = "0.0.0.0:7600"
threads = 2
align = false
[tls]
cert = "a.pem"
key = "b.pem"
[access]
hosts = ["hub.example.org"]
[limits]
ban_after = 3
[[room]]
name = "lab"
max_viewers = 20
start_positions = [{x = 1.5, z = -2}]
[[room]]
name = "kitchen"
listed = false
view = "anyone"
)");
  EXPECT_EQ(config.listen, "0.0.0.0:7600");
  EXPECT_FALSE(config.align);
  EXPECT_EQ(config.tls_key, "b.pem");
  EXPECT_EQ(config.hosts, std::vector<std::string>{"hub.example.org"});
  EXPECT_EQ(config.ban_after, 3);
  const auto rooms = *rooms_of(config, AccessRule::kToken);
  ASSERT_EQ(rooms.size(), 2U);
  EXPECT_EQ(rooms[0].max_viewers, 20U);
  EXPECT_EQ(rooms[0].start_positions.at(0).x_m, 1.5);
  EXPECT_EQ(rooms[0].view, AccessRule::kToken) << "what it leaves open";
  EXPECT_EQ(rooms[1].view, AccessRule::kAnyone);
  EXPECT_FALSE(rooms[1].listed);
}

TEST(HubConfig, without_rooms_there_is_one) {
  const auto rooms = *rooms_of({}, AccessRule::kAnyone);
  ASSERT_EQ(rooms.size(), 1U);
  EXPECT_EQ(rooms[0].name, "room");
}

TEST(HubConfig, each_mistake_is_one_sentence_with_its_line) {
  const std::map<std::string, std::string> mistakes = {
      {"listen = 7", "this is no value for \"listen\" (line 1)"},
      {"\nlisen = \"x\"", "there is no field \"lisen\" (line 2)"},
      {"[tls]\ncertificate = \"x\"", "there is no field \"tls.certificate\" (line 2)"},
      {"log = \"xml\"", "log is \"text\" or \"json\""},
      {"threads = 100", "threads is 0 to 64"},
      {"[limits]\nunjoined = 0", "limits.unjoined is 1 to 1000000"},
      {"[access]\norigins = [\"rooms.example.org\"]",
       "access.origins: \"rooms.example.org\" is no web site; write https://rooms.example.org, "
       "without a path"},
      {"[access]\nhosts = [\"hub:7600\"]",
       "access.hosts: \"hub:7600\" is no name; write hub.example.org, without a port"},
      {"[access]\nproxies = [\"nginx\"]",
       "access.proxies: \"nginx\" is no numeric address; a network is written 2001:db8::/64"},
      {"room = 3", "rooms are written as [[room]] (line 1)"},
      {"[[room]]\ntitle = \"x\"", "a room needs a name (line 1)"},
      {"[[room]]\nname = \"a\"\nview = \"me\"", "this is no value for a room's \"view\" (line 1)"}};
  for (const auto& [text, sentence] : mistakes) EXPECT_EQ(config_fault(text), sentence) << text;
  EXPECT_NE(config_fault("listen = "), "");
  EXPECT_NE(config_fault("listen = ").find("line 1"), std::string::npos);
}

TEST(HubConfig, reads_usual_spellings_of_origins_names_and_addresses) {
  EXPECT_EQ(
      config_fault("[access]\norigins = [\"https://rooms.example.org\", \"http://[::1]:80\"]"), "");
  EXPECT_NE(config_fault("[access]\norigins = [\"https://rooms.example.org/\"]"), "");
  EXPECT_NE(config_fault("[access]\norigins = [\"ws://rooms.example.org\"]"), "");
  EXPECT_EQ(config_fault("[access]\nhosts = [\"hub.example.org\", \"lab-hub\"]"), "");
  EXPECT_NE(config_fault("[access]\nhosts = [\"https://hub\"]"), "");
  EXPECT_EQ(config_fault("[access]\nproxies = [\"10.0.0.1\", \"2001:db8::5\"]"), "");
  EXPECT_EQ(config_fault("public_url = \"wss://hub.example.org:7600\""), "");
  EXPECT_NE(config_fault("public_url = \"ftp://hub\"").find("public_url: "), std::string::npos);
}

TEST(HubConfig, two_rooms_of_one_name_are_refused) {
  EXPECT_FALSE(
      rooms_of(parsed("[[room]]\nname = \"a\"\n[[room]]\nname = \"a\"\n"), AccessRule::kAnyone)
          .ok());
}

TEST(HubConfig, a_room_may_keep_its_recordings_longer_or_shorter) {
  const HubConfig config = parsed(
      "[[room]]\nname = \"lab\"\nrecordings_days = 7\n[[room]]\nname = \"attic\"\n"
      "recordings_days = 0\nrecordings_gb = 50\n[[room]]\nname = \"hall\"\n");
  ASSERT_EQ(config.recording_limits.size(), 2u);
  EXPECT_EQ(config.recording_limits.at("lab"), (RecordingLimits{.days = 7, .gb = {}}));
  EXPECT_EQ(config.recording_limits.at("attic"), (RecordingLimits{.days = 0, .gb = 50}));
  EXPECT_EQ(rooms_of(config, AccessRule::kAnyone)->size(), 3u);
  for (const char* wrong : {"-1", "1000001", "\"7\"", "1.5"}) {
    const std::string fault =
        config_fault("[[room]]\nname = \"lab\"\nrecordings_days = " + std::string(wrong));
    EXPECT_EQ(fault, "recordings_days of a room is 0 to 1000000 (line 1)") << wrong;
  }
}

TEST(HubConfig, the_environment_overrides_the_file) {
  const std::map<std::string, std::string> set = {{"ROOMCAST_HUB_LISTEN", "[::1]:0"},
                                                  {"ROOMCAST_HUB_TLS_SELF_SIGNED", "true"},
                                                  {"ROOMCAST_HUB_LIMITS_BAN_S", "5"},
                                                  {"ROOMCAST_HUB_ACCESS_HOSTS", "a,b"}};
  const auto get = [&](const char* name) {
    const auto found = set.find(name);
    return found == set.end() ? nullptr : found->second.c_str();
  };
  const auto config = read_environment(parsed("listen = \"x\""), get);
  ASSERT_TRUE(config.ok());
  EXPECT_EQ(config->listen, "[::1]:0");
  EXPECT_TRUE(config->tls_self_signed);
  EXPECT_EQ(config->ban_s, 5);
  EXPECT_EQ(config->hosts, (std::vector<std::string>{"a", "b"}));
  const auto wrong = read_environment({}, [](const char* name) {
    return std::string_view(name) == "ROOMCAST_HUB_THREADS" ? "many" : nullptr;
  });
  EXPECT_EQ(wrong.error().message, "ROOMCAST_HUB_THREADS cannot be \"many\"");
}

TEST(HubConfig, every_field_is_documented) {
  std::ifstream file(std::string(ROOMCAST_SOURCE_DIR) + "/docs/guides/hub.md");
  const std::string guide{std::istreambuf_iterator<char>(file), {}};
  for (const std::string& field : config_fields()) {
    EXPECT_NE(guide.find("`" + field + "`"), std::string::npos) << field;
  }
}

}  // namespace
}  // namespace roomcast::hub
