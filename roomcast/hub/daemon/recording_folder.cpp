// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/recording_folder.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <future>
#include <optional>
#include <utility>

#include <boost/asio/post.hpp>
#include <fcntl.h>
#include <sys/stat.h>

#include "roomcast/recording/bytes/byte_source.h"
#include "roomcast/recording/room/recording_summary.h"
#include "roomcast/wire/name_check.h"

namespace roomcast::hub::daemon {

namespace {

using hub::KeptRecording;
using hub::KeptState;
using hub::RecordingList;
using hub::RecordingScope;

constexpr std::string_view kEnding = ".mcap";
constexpr std::chrono::milliseconds kReadingTime{200};  // of new files, before a list is answered
constexpr std::size_t kMaxPlayable = 4;                 // open at a time
constexpr std::size_t kMaxFiles = 10'000;               // older ones are not looked at

class RecordingBody final : public net::LongBody {
 public:
  explicit RecordingBody(std::unique_ptr<recording::ByteSource> file) : file_(std::move(file)) {}
  [[nodiscard]] std::uint64_t size() const override { return file_->size(); }
  [[nodiscard]] Status read(std::uint64_t offset, std::span<std::uint8_t> out) const override {
    return file_->read(offset, out);
  }

 private:
  std::unique_ptr<recording::ByteSource> file_;
};

/// Also keeps what comes from outside within the folder.
Status check_file_name(const std::string& name) {
  auto status = wire::check_text(name, RecordingFolder::kMaxNameBytes, "the name of a recording");
  if (!status) return invalid_argument(status.error().message);
  if (name.empty()) return invalid_argument("a recording needs a name");
  if (name.find('/') != std::string::npos)
    return invalid_argument("the name of a recording must not contain a /");
  if (name.front() == '.') return invalid_argument("the name of a recording must not begin with .");
  if (name.front() == ' ' || name.back() == ' ')
    return invalid_argument("the name of a recording must not begin or end with a space");
  return {};
}

/// What a file says about people and rooms is shown only if it could be a name.
std::string checked_name(std::string text) {
  return wire::check_name(text, "it") ? std::move(text) : std::string();
}

UnixSeconds seconds_of(nanoseconds since_1970) {
  return std::chrono::duration_cast<std::chrono::seconds>(since_1970).count();
}

/// A sentence of its own, without the path before it, which is the hub's matter.
std::string as_sentence(std::string text, const std::filesystem::path& path) {
  if (const std::string before = path.string() + ": "; text.starts_with(before))
    text.erase(0, before.size());
  if (const auto at = text.find(path.string()); at != std::string::npos)
    text.replace(at, path.string().size(), "the file");
  if (text.empty()) return text;
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text.back() == '.' ? text : text + '.';
}

KeptRecording kept_from(const std::filesystem::path& path) {
  KeptRecording kept;
  auto summary = recording::summarize_recording(path);
  if (!summary) {
    kept.state = KeptState::kUnreadable;
    kept.problem = as_sentence(summary.error().message, path);
    return kept;
  }
  kept.room = checked_name(std::move(summary->about.room));
  kept.by = checked_name(std::move(summary->about.by));
  kept.seconds = std::chrono::duration<double>(summary->end - summary->start).count();
  kept.began_at = seconds_of(summary->start);
  kept.sensors = summary->sensors;
  kept.has_voices = summary->has_voices;
  if (summary->damage) {
    kept.state = KeptState::kDamaged;
    kept.problem = as_sentence(*summary->damage, path);
  }
  return kept;
}

bool is_in(const RecordingScope& scope, const KeptRecording& recording) {
  return recording.room.empty() ? scope.unknown_too : recording.room == scope.room;
}

Error no_such_recording(const std::string& name) {
  return {ErrorCode::kNotFound, "this room has no recording \"" + name + "\""};
}

/// Never replaces another file.
int rename_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL) return errno;
  std::error_code error;  // a file system that cannot promise it
  if (std::filesystem::exists(to, error)) return EEXIST;
  std::filesystem::rename(from, to, error);
  return error.value();
}

}  // namespace

RecordingFolder::RecordingFolder(std::filesystem::path folder,
                                 std::function<bool(const std::filesystem::path&)> is_running)
    : folder_(std::move(folder)),
      is_running_(std::move(is_running)),
      worker_([this] { orders_.run(); }) {}

RecordingFolder::~RecordingFolder() {
  orders_.stop();
  worker_.join();
}

void RecordingFolder::list(RecordingScope scope, hub::WhenKnown<RecordingList> done) {
  boost::asio::post(
      orders_, [this, scope = std::move(scope), done = std::move(done)] { done(list_now(scope)); });
}

void RecordingFolder::about(RecordingScope scope, std::string name,
                            hub::WhenKnown<KeptRecording> done) {
  boost::asio::post(orders_, [this, scope = std::move(scope), name = std::move(name),
                              done = std::move(done)] { done(find_finished(scope, name)); });
}

void RecordingFolder::part(RecordingScope scope, std::string name, hub::WantedPart wanted,
                           hub::WhenKnown<std::shared_ptr<const std::string>> done) {
  boost::asio::post(orders_, [this, scope = std::move(scope), name = std::move(name), wanted,
                              done = std::move(done)] { done(part_now(scope, name, wanted)); });
}

void RecordingFolder::open(RecordingScope scope, std::string name,
                           hub::WhenKnown<std::shared_ptr<const net::LongBody>> done) {
  boost::asio::post(orders_, [this, scope = std::move(scope), name = std::move(name),
                              done = std::move(done)] {
    if (const auto found = find_finished(scope, name); !found) return done(found.error());
    auto file = recording::open_file(path_of(name));
    if (!file) return done(no_such_recording(name));
    done(std::shared_ptr<const net::LongBody>(std::make_shared<RecordingBody>(*std::move(file))));
  });
}

void RecordingFolder::rename(RecordingScope scope, std::string name, std::string to,
                             hub::WhenKnown<KeptRecording> done) {
  boost::asio::post(orders_,
                    [this, scope = std::move(scope), name = std::move(name), to = std::move(to),
                     done = std::move(done)] { done(rename_now(scope, name, to)); });
}

void RecordingFolder::remove(RecordingScope scope, std::string name,
                             std::function<void(Status)> done) {
  boost::asio::post(orders_, [this, scope = std::move(scope), name = std::move(name),
                              done = std::move(done)] { done(remove_now(scope, name)); });
}

void RecordingFolder::retain(Retention retention, nanoseconds now,
                             std::function<void(Retained)> done) {
  boost::asio::post(orders_, [this, retention, now, done = std::move(done)] {
    done(retain_now(retention, now));
  });
}

void RecordingFolder::settle() {
  std::promise<void> settled;
  boost::asio::post(orders_, [&settled] { settled.set_value(); });
  settled.get_future().wait();
}

// ---- on the worker

std::filesystem::path RecordingFolder::path_of(const std::string& name) const {
  return folder_ / (name + std::string(kEnding));
}

/// Nothing: there is no file, or it is a link or a folder.
std::optional<RecordingFolder::Stamp> RecordingFolder::stamp_of(const std::filesystem::path& path) {
  struct stat about {};
  if (::lstat(path.c_str(), &about) != 0 || !S_ISREG(about.st_mode)) return std::nullopt;
  const auto& changed = about.st_mtim;
  return Stamp{.bytes = static_cast<std::uint64_t>(about.st_size),
               .changed_ns = changed.tv_sec * 1'000'000'000 + changed.tv_nsec};
}

/// The files of the folder, newest first.
std::vector<RecordingFolder::Found> RecordingFolder::look() const {
  std::vector<Found> files;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder_, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().extension() != kEnding) continue;
    std::string name = entry->path().stem().string();
    if (!check_file_name(name)) continue;
    if (const auto stamp = stamp_of(entry->path())) files.push_back({std::move(name), *stamp});
  }
  std::ranges::sort(files, [](const Found& a, const Found& b) {
    return std::pair(b.stamp.changed_ns, a.name) < std::pair(a.stamp.changed_ns, b.name);
  });
  return files;
}

bool RecordingFolder::is_known(const Found& file) const {
  const auto known = known_.find(file.name);
  return known != known_.end() && known->second.stamp == file.stamp;
}

const KeptRecording& RecordingFolder::read(const Found& file) {
  Known& known = known_[file.name];
  if (known.recording.name.empty() || known.stamp != file.stamp) {
    known = {file.stamp, kept_from(path_of(file.name))};
    known.recording.name = file.name;
    known.recording.bytes = file.stamp.bytes;
    if (known.recording.state == KeptState::kUnreadable)
      known.recording.began_at = seconds_of(nanoseconds(file.stamp.changed_ns));
  }
  return known.recording;
}

RecordingList RecordingFolder::list_now(const RecordingScope& scope) {
  std::vector<Found> files = look();
  RecordingList list;
  if (files.size() > kMaxFiles) {
    list.left_out = files.size() - kMaxFiles;
    files.resize(kMaxFiles);
  }
  std::map<std::string, Known> still_there;
  const auto until = std::chrono::steady_clock::now() + kReadingTime;
  for (const Found& file : files) {
    if (!is_known(file) && std::chrono::steady_clock::now() > until) {
      ++list.unread;
      continue;
    }
    KeptRecording recording = read(file);
    still_there.insert(known_.extract(file.name));
    if (is_running_(path_of(file.name))) {
      recording.state = KeptState::kRunning;
      recording.problem.clear();
    }
    if (!is_in(scope, recording)) continue;
    if (list.recordings.size() < kMaxListed)
      list.recordings.push_back(std::move(recording));
    else
      ++list.left_out;
  }
  known_ = std::move(still_there);
  std::ranges::stable_sort(list.recordings, std::greater(), &KeptRecording::began_at);
  return list;
}

Result<KeptRecording> RecordingFolder::find(const RecordingScope& scope, const std::string& name) {
  if (!check_file_name(name)) return no_such_recording(name);
  const auto stamp = stamp_of(path_of(name));
  if (!stamp) return no_such_recording(name);
  const KeptRecording& found = read({name, *stamp});
  if (!is_in(scope, found)) return no_such_recording(name);
  return found;
}

Result<KeptRecording> RecordingFolder::find_finished(const RecordingScope& scope,
                                                     const std::string& name) {
  auto found = find(scope, name);
  if (found && is_running_(path_of(name)))
    return unavailable("\"" + name + "\" is being recorded; stop the recording first");
  return found;
}

Result<KeptRecording> RecordingFolder::rename_now(const RecordingScope& scope,
                                                  const std::string& name, const std::string& to) {
  auto found = find_finished(scope, name);
  if (!found) return found.error();
  if (auto status = check_file_name(to); !status) return status.error();
  if (to == name) return found;
  const int failed = rename_file(path_of(name), path_of(to));
  if (failed == EEXIST) return invalid_argument("there is a recording \"" + to + "\" already");
  if (failed == ENOENT) return no_such_recording(name);
  if (failed != 0)
    return unavailable("the recording cannot be renamed: " + std::string(std::strerror(failed)));
  known_.erase(name);
  return find(scope, to);
}

Result<std::shared_ptr<const std::string>> RecordingFolder::part_now(
    const RecordingScope& scope, const std::string& name, const hub::WantedPart& wanted) {
  if (const auto found = find_finished(scope, name); !found) return found.error();
  const auto recording = playable(name);
  if (!recording) return recording.error();
  const std::chrono::milliseconds time(wanted.number);
  if (wanted.kind == hub::WantedPart::Kind::kMoment)
    return std::make_shared<const std::string>((*recording)->moment(time));
  if (wanted.kind == hub::WantedPart::Kind::kKeyFrame)
    return std::make_shared<const std::string>((*recording)->key_frame(wanted.sensor, time));
  auto part = (*recording)->part(wanted.number);
  if (!part) return part.error();
  return std::make_shared<const std::string>(*std::move(part));
}

/// Opening reads more of the file than a list needs, so the last ones stay open.
Result<std::shared_ptr<const recording::PlayableRecording>> RecordingFolder::playable(
    const std::string& name) {
  const auto stamp = stamp_of(path_of(name));
  if (!stamp) return no_such_recording(name);
  const auto found = std::ranges::find(playable_, name, &Playable::name);
  if (found != playable_.end()) {
    Playable open = std::move(*found);
    playable_.erase(found);
    if (open.stamp == *stamp) {
      playable_.push_front(open);
      return open.recording;
    }
  }
  auto opened = recording::PlayableRecording::open(path_of(name));
  if (!opened) return malformed(as_sentence(opened.error().message, path_of(name)));
  playable_.push_front(
      {name, *stamp, std::make_shared<const recording::PlayableRecording>(*std::move(opened))});
  if (playable_.size() > kMaxPlayable) playable_.pop_back();
  return playable_.front().recording;
}

Status RecordingFolder::remove_now(const RecordingScope& scope, const std::string& name) {
  if (const auto found = find_finished(scope, name); !found) return found.error();
  return remove_file(name);
}

Status RecordingFolder::remove_file(const std::string& name) {
  std::error_code error;
  const bool was_there = std::filesystem::remove(path_of(name), error);
  known_.erase(name);
  std::erase_if(playable_, [&](const Playable& open) { return open.name == name; });
  if (error) return unavailable("the recording cannot be deleted: " + error.message());
  return was_there ? Status() : no_such_recording(name);
}

RecordingFolder::Retained RecordingFolder::retain_now(const Retention& retention, nanoseconds now) {
  Retained retained;
  std::vector<AgingRecording> aging;
  const auto until = std::chrono::steady_clock::now() + kReadingTime;
  for (const Found& file : look()) {
    if (!is_known(file) && std::chrono::steady_clock::now() > until) {
      ++retained.unread;
      continue;
    }
    aging.push_back({.name = file.name,
                     .room = read(file).room,
                     .bytes = file.stamp.bytes,
                     .ended_at = nanoseconds(file.stamp.changed_ns),
                     .running = is_running_(path_of(file.name))});
  }
  for (AgingRecording& recording : outdated(std::move(aging), retention, now)) {
    if (auto status = remove_file(recording.name); !status) {
      retained.problem = status.error().message;
    } else {
      retained.deleted.push_back(std::move(recording));
    }
  }
  return retained;
}

}  // namespace roomcast::hub::daemon
