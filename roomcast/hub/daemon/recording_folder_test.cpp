// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/recording_folder.h"

#include <fstream>
#include <future>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/recording/recorder/unix_clock.h"
#include "roomcast/recording/room/room_recording_writer.h"

namespace roomcast::hub::daemon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class RecordingFolderTest : public testing::Test {
 protected:
  void record(const std::string& name, const std::string& room = "lab", bool finish = true) {
    auto writer = recording::RoomRecordingWriter::create(file(name), room, "Ada");
    ASSERT_TRUE(writer.ok());
    constexpr nanoseconds kStart{1'700'000'000'000'000'000};
    ASSERT_TRUE(writer->add_roster({}, kStart).ok());
    ASSERT_TRUE(writer->add_roster({}, kStart + std::chrono::seconds(3)).ok());
    if (finish) {
      ASSERT_TRUE(writer->finish().ok());
    }
  }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const {
    return folder_ / (name + ".mcap");
  }

  RecordingList list(const RecordingScope& scope = {.room = "lab", .unknown_too = true}) {
    std::promise<RecordingList> list;
    kept_.list(scope, [&](Result<RecordingList> found) { list.set_value(*std::move(found)); });
    return list.get_future().get();
  }
  std::vector<std::string> names(const RecordingScope& scope = {.room = "lab"}) {
    std::vector<std::string> names;
    for (const auto& recording : list(scope).recordings) names.push_back(recording.name);
    std::ranges::sort(names);
    return names;
  }
  Result<KeptRecording> rename(const std::string& name, const std::string& to) {
    std::promise<Result<KeptRecording>> renamed;
    kept_.rename({.room = "lab"}, name, to,
                 [&](Result<KeptRecording> result) { renamed.set_value(std::move(result)); });
    return renamed.get_future().get();
  }
  Status remove(const std::string& name, const std::string& room = "lab") {
    std::promise<Status> removed;
    kept_.remove({.room = room}, name, [&](Status status) { removed.set_value(status); });
    return removed.get_future().get();
  }
  Result<std::string> content(const std::string& name) {
    std::promise<Result<std::string>> read;
    kept_.open({.room = "lab"}, name, [&](const auto& opened) {
      if (!opened) return read.set_value(opened.error());
      std::vector<std::uint8_t> bytes((*opened)->size());
      EXPECT_TRUE((*opened)->read(0, bytes).ok());
      read.set_value(std::string(bytes.begin(), bytes.end()));
    });
    return read.get_future().get();
  }

  Result<std::string> part(const std::string& name, WantedPart wanted) {
    std::promise<Result<std::string>> part;
    kept_.part({.room = "lab"}, name, wanted, [&](const auto& found) {
      part.set_value(found ? Result<std::string>(**found) : found.error());
    });
    return part.get_future().get();
  }

  RecordingFolder::Retained retain(const Retention& retention, nanoseconds now) {
    std::promise<RecordingFolder::Retained> done;
    kept_.retain(retention, now,
                 [&](RecordingFolder::Retained retained) { done.set_value(std::move(retained)); });
    return done.get_future().get();
  }

  TemporaryFolder folder_;
  std::set<std::filesystem::path> running_;
  RecordingFolder kept_{folder_.path(),
                        [this](const auto& path) { return running_.contains(path); }};
};

TEST_F(RecordingFolderTest, lists_what_each_file_says_of_itself) {
  record("one");
  const auto recordings = list().recordings;
  ASSERT_EQ(recordings.size(), 1u);
  EXPECT_EQ(recordings[0].name, "one");
  EXPECT_EQ(recordings[0].room, "lab");
  EXPECT_EQ(recordings[0].by, "Ada");
  EXPECT_EQ(recordings[0].state, KeptState::kWhole);
  EXPECT_EQ(recordings[0].seconds, 3);
  EXPECT_EQ(recordings[0].began_at, 1'700'000'000);
  EXPECT_EQ(recordings[0].bytes, std::filesystem::file_size(file("one")));
}

TEST_F(RecordingFolderTest, says_what_is_wrong_with_a_damaged_or_foreign_file) {
  record("cut", "lab", false);
  std::ofstream(file("foreign")) << "nothing";
  std::ofstream(file("empty"));
  std::map<std::string, KeptRecording> found;
  for (const auto& recording : list().recordings) found[recording.name] = recording;
  EXPECT_EQ(found["cut"].state, KeptState::kDamaged);
  EXPECT_EQ(found["cut"].problem, "Its end is missing.");
  for (const char* name : {"foreign", "empty"}) {
    EXPECT_EQ(found[name].state, KeptState::kUnreadable) << name;
    EXPECT_EQ(found[name].problem.back(), '.') << found[name].problem;
    EXPECT_THAT(found[name].problem, testing::Not(HasSubstr(folder_.path().string())));
  }
  EXPECT_THAT(names(), ElementsAre("cut")) << "who may not know of unknown ones";
}

TEST_F(RecordingFolderTest, sees_changes_of_the_folder) {
  EXPECT_THAT(names(), IsEmpty());
  record("one");
  record("two");
  record("theirs", "cellar");
  EXPECT_THAT(names(), ElementsAre("one", "two"));
  std::filesystem::remove(file("one"));
  EXPECT_THAT(names(), ElementsAre("two"));
  std::ofstream(file("two")) << "overwritten";
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(RecordingFolderTest, a_folder_that_is_not_there_has_none) {
  RecordingFolder none(folder_ / "none", [](const auto&) { return false; });
  std::promise<RecordingList> list;
  none.list({.room = "lab"}, [&](const auto& found) { list.set_value(*found); });
  EXPECT_THAT(list.get_future().get().recordings, IsEmpty());
}

TEST_F(RecordingFolderTest, passes_over_links_hidden_files_and_names_that_cannot_be_shown) {
  record("one");
  std::filesystem::create_symlink(file("one"), file("link"));
  std::filesystem::create_directory(file("folder"));
  std::filesystem::copy_file(file("one"), file(".hidden"));
  std::filesystem::copy_file(file("one"), file("line\nbreak"));
  std::filesystem::copy_file(file("one"), file("\xff"));
  std::filesystem::copy_file(file("one"), folder_ / "one.txt");
  EXPECT_THAT(names(), ElementsAre("one"));
  for (const char* name : {"link", "folder", ".hidden", "line\nbreak", "../one", "nothing", ""})
    EXPECT_EQ(remove(name).error().code, ErrorCode::kNotFound) << name;
}

TEST_F(RecordingFolderTest, renames_but_replaces_nothing) {
  record("one");
  record("two");
  const auto renamed = rename("one", "Über <b>");
  ASSERT_TRUE(renamed.ok()) << renamed.error().message;
  EXPECT_EQ(renamed->name, "Über <b>");
  EXPECT_EQ(renamed->by, "Ada");
  EXPECT_THAT(names(), ElementsAre("two", "Über <b>"));
  EXPECT_THAT(rename("two", "Über <b>").error().message, HasSubstr("already"));
  EXPECT_EQ(rename("none", "three").error().code, ErrorCode::kNotFound);
  EXPECT_TRUE(rename("two", "two").ok());
}

TEST_F(RecordingFolderTest, refuses_names_that_leave_the_folder_or_cannot_be_typed) {
  record("one");
  const std::vector<std::string> refused = {
      "../two", "a/b",  ".two",
      "",       " two", "two ",
      "a\nb",   "\xff", std::string(RecordingFolder::kMaxNameBytes + 1, 'x')};
  for (const std::string& name : refused)
    EXPECT_EQ(rename("one", name).error().code, ErrorCode::kInvalidArgument) << name;
  EXPECT_THAT(names(), ElementsAre("one"));
}

TEST_F(RecordingFolderTest, deletes_for_good_and_only_what_is_of_the_room) {
  record("one");
  record("theirs", "cellar");
  EXPECT_EQ(remove("theirs").error().code, ErrorCode::kNotFound);
  EXPECT_TRUE(remove("one").ok());
  EXPECT_FALSE(std::filesystem::exists(file("one")));
  EXPECT_EQ(remove("one").error().code, ErrorCode::kNotFound);
}

TEST_F(RecordingFolderTest, leaves_a_running_one_alone) {
  record("one");
  running_.insert(file("one"));
  EXPECT_EQ(list().recordings[0].state, KeptState::kRunning);
  EXPECT_EQ(remove("one").error().code, ErrorCode::kUnavailable);
  EXPECT_EQ(rename("one", "two").error().code, ErrorCode::kUnavailable);
  EXPECT_EQ(content("one").error().code, ErrorCode::kUnavailable);
  EXPECT_TRUE(std::filesystem::exists(file("one")));
}

TEST_F(RecordingFolderTest, opens_a_file_that_stays_readable_when_it_is_deleted) {
  record("one");
  const auto read = content("one");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->substr(1, 4), "MCAP");
  EXPECT_EQ(content("../one").error().code, ErrorCode::kNotFound);
}

TEST_F(RecordingFolderTest, gives_parts_until_the_file_is_changed_or_deleted) {
  record("one");
  const auto first = part("one", {.kind = WantedPart::Kind::kMoment, .number = 500});
  ASSERT_TRUE(first.ok()) << first.error().message;
  EXPECT_EQ(first->substr(0, 4), "RCPT");
  EXPECT_TRUE(part("one", {.number = 0}).ok());
  const auto picture =
      part("one", {.kind = WantedPart::Kind::kKeyFrame, .number = 500, .sensor = "s0"});
  ASSERT_TRUE(picture.ok());
  EXPECT_EQ(picture->size(), recording::kPartHeaderBytes);  // it has no frames
  EXPECT_EQ(part("one", {.number = 99}).error().code, ErrorCode::kNotFound);
  std::ofstream(file("one")) << "overwritten";
  EXPECT_FALSE(part("one", {.number = 0}).ok());
  record("two");
  EXPECT_TRUE(part("two", {.number = 0}).ok());
  EXPECT_TRUE(remove("two").ok());
  EXPECT_EQ(part("two", {.number = 0}).error().code, ErrorCode::kNotFound);
}

TEST_F(RecordingFolderTest, lists_no_more_than_the_newest_thousand) {
  record("one");
  for (int i = 0; i < 1050; ++i)
    std::filesystem::create_hard_link(file("one"), file("more-" + std::to_string(i)));
  RecordingList all = list({.room = "lab"});
  for (int tries = 0; all.unread > 0 && tries < 100; ++tries) all = list({.room = "lab"});
  EXPECT_EQ(all.recordings.size(), RecordingFolder::kMaxListed);
  EXPECT_EQ(all.left_out, 51u);
  EXPECT_EQ(all.unread, 0u);
}

TEST_F(RecordingFolderTest, deletes_what_is_not_kept_longer) {
  for (const char* name : {"old", "running", "new"}) record(name);
  record("elsewhere", "attic");
  std::ofstream(file("foreign")) << "no recording";
  const auto now = std::chrono::file_clock::now();
  for (const char* name : {"old", "running", "elsewhere", "foreign"})
    std::filesystem::last_write_time(file(name), now - std::chrono::days(40));
  running_.insert(file("running"));
  const nanoseconds unix_now = recording::UnixClock().now();
  const auto retained = retain({.usual = {.max_age = std::chrono::days(30)}}, unix_now);
  ASSERT_EQ(retained.deleted.size(), 2u);
  EXPECT_EQ(retained.unread, 0u);
  EXPECT_THAT(names(), ElementsAre("new", "running"));
  EXPECT_FALSE(std::filesystem::exists(file("elsewhere")));
  EXPECT_TRUE(std::filesystem::exists(file("foreign"))) << "it may be anybody's";
}

TEST_F(RecordingFolderTest, keeps_a_room_within_its_size) {
  for (const char* name : {"first", "second"}) record(name);
  std::filesystem::last_write_time(file("first"),
                                   std::chrono::file_clock::now() - std::chrono::hours(1));
  const auto bytes = std::filesystem::file_size(file("second"));
  const nanoseconds now = recording::UnixClock().now();
  EXPECT_TRUE(retain({.usual = {.max_bytes = 3 * bytes}}, now).deleted.empty());
  EXPECT_EQ(retain({.usual = {.max_bytes = bytes}}, now).deleted.size(), 1u);
  EXPECT_THAT(names(), ElementsAre("second"));
}

}  // namespace
}  // namespace roomcast::hub::daemon
