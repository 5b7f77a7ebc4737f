// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/study_folder.h"

#include <algorithm>
#include <fstream>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/core/utc_text.h"
#include "roomcast/io/file_bytes.h"
#include "roomcast/io/new_folder.h"
#include "roomcast/io/private_folder.h"
#include "roomcast/study/counterbalance.h"
#include "roomcast/study/log_records.h"

namespace roomcast::study {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

// Names in the folder.
constexpr const char *kAboutFile = "study.json", *kPeople = "participants", *kPlans = "plans",
                     *kNextFile = "next", *kErasedFile = "erased.txt";
constexpr const char *kPersonFile = "participant.json", *kLogFile = "log.jsonl";
constexpr std::size_t kMaxSmallFile = 1U << 20U;

/// "2026-11-26T12:00:00.123Z"
std::string utc_millisecond(nanoseconds now) {
  return utc_text(now).substr(0, 23) + "Z";
}

bool is_id(const std::string& id) {
  return id.size() >= 4 && id.size() <= 8 && id.front() == 'P' &&
         std::ranges::all_of(id.begin() + 1, id.end(), [](char c) { return c >= '0' && c <= '9'; });
}

Error no_participant(const std::string& id) {
  return {ErrorCode::kNotFound, "this study has no participant " + id};
}

Result<Json> read_json(const fs::path& file) {
  std::vector<std::uint8_t> bytes;
  if (auto status = io::read_file(file, kMaxSmallFile, bytes); !status) return status.error();
  Json json = Json::parse(bytes.begin(), bytes.end(), nullptr, false);
  if (!json.is_object())
    return Error{ErrorCode::kMalformed, file.string() + " is damaged: it is no JSON object"};
  return json;
}

/// Empty: there is none, or it is something else.
std::string text_in(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

Json person_json(const Participant& person) {
  return {{"id", person.id},
          {"number", person.number},
          {"order", person.order},
          {"consented_at", person.consented_at},
          {"consent", person.consent},
          {"key_sha256", person.key_sha256},
          {"plan_sha256", person.plan_sha256}};
}

Result<Participant> person_from(const Json& json, const fs::path& file) {
  const auto number = json.find("number"), order = json.find("order");
  Participant person{.id = text_in(json, "id"),
                     .consented_at = text_in(json, "consented_at"),
                     .consent = text_in(json, "consent"),
                     .key_sha256 = text_in(json, "key_sha256"),
                     .plan_sha256 = text_in(json, "plan_sha256")};
  const bool is_whole =
      is_id(person.id) && number != json.end() && number->is_number_unsigned() &&
      order != json.end() && order->is_array() &&
      std::ranges::all_of(*order, [](const Json& name) { return name.is_string(); });
  if (!is_whole) return Error{ErrorCode::kMalformed, file.string() + " is damaged"};
  person.number = number->get<std::size_t>();
  person.order = order->get<std::vector<std::string>>();
  return person;
}

/// True: this is the end of a step.
bool ends_step(const Json& record) {
  const auto kind = record.find("kind"), begins = record.find("begins");
  return kind != record.end() && *kind == "steps" && begins != record.end() && *begins == false;
}

}  // namespace

Result<StudyFolder> StudyFolder::create(const fs::path& folder, const StudyPlan& plan,
                                        std::string_view plan_text, std::string plan_sha256) {
  if (const auto closed = io::make_private_folder(folder, {kAboutFile}); !closed)
    return closed.error();
  StudyFolder study(folder, plan.name);
  study.plan_sha256_ = std::move(plan_sha256);
  std::error_code error;
  if (fs::exists(folder / kAboutFile, error)) {
    const auto known = open(folder);
    if (!known) return known.error();
    if (known->study() != plan.name) {
      return Error{
          ErrorCode::kInvalidArgument,
          fmt::format("{} belongs to the study \"{}\", not to \"{}\"; choose another folder",
                      folder.string(), known->study(), plan.name)};
    }
  }
  for (const char* part : {kPeople, kPlans}) {
    if (auto status = io::make_folder(folder / part); !status) return status.error();
  }
  const fs::path copy = folder / kPlans / (study.plan_sha256_.substr(0, 16) + ".toml");
  if (auto status = io::write_file(copy, plan_text); !status) return status.error();
  const Json about = {{"study", plan.name}, {"version", 1}};
  if (auto status = io::write_file(folder / kAboutFile, about.dump(1) + "\n"); !status)
    return status.error();
  return study;
}

Result<StudyFolder> StudyFolder::open(const fs::path& folder) {
  const auto about = read_json(folder / kAboutFile);
  if (!about && about.error().code != ErrorCode::kNotFound) return about.error();
  if (!about)
    return Error{ErrorCode::kNotFound,
                 folder.string() + " is no folder of a study: it has no " + kAboutFile};
  return StudyFolder(folder, text_in(*about, "study"));
}

Result<StudyPlan> StudyFolder::plan_of(const Participant& participant) const {
  return load_plan(folder_ / kPlans / (participant.plan_sha256.substr(0, 16) + ".toml"));
}

fs::path StudyFolder::folder_of(const std::string& id) const {
  return folder_ / kPeople / id;
}

/// Numbers of erased participants are not given again.
std::size_t StudyFolder::next_number() const {
  std::size_t next = 1;
  std::ifstream(folder_ / kNextFile) >> next;
  for (const std::string& id : participants())
    next = std::max(next, static_cast<std::size_t>(std::stoul(id.substr(1))) + 1);
  return next;
}

Result<Participant> StudyFolder::enroll(const StudyPlan& plan, std::string key_sha256,
                                        nanoseconds now) {
  if (participants().size() >= plan.participants) {
    return Error{
        ErrorCode::kUnavailable,
        fmt::format("this study has its {} participants and takes no more", plan.participants)};
  }
  const std::size_t number = next_number();
  Participant person{.id = fmt::format("P{:03}", number),
                     .number = number,
                     .consented_at = utc_millisecond(now),
                     .consent = plan.consent,
                     .key_sha256 = std::move(key_sha256),
                     .plan_sha256 = plan_sha256_};
  for (const std::size_t condition :
       order_for(number - 1, plan.conditions.size(), plan.order, plan.name))
    person.order.push_back(plan.conditions[condition].name);
  if (auto status = io::write_file(folder_ / kNextFile, fmt::format("{}\n", number + 1)); !status)
    return status.error();
  std::error_code error;
  fs::create_directory(folder_of(person.id), error);
  if (error)
    return Error{ErrorCode::kUnavailable,
                 "cannot make " + folder_of(person.id).string() + ": " + error.message()};
  if (auto status =
          io::write_file(folder_of(person.id) / kPersonFile, person_json(person).dump(1) + "\n");
      !status)
    return status.error();
  return person;
}

Result<Participant> StudyFolder::participant(const std::string& id) const {
  if (!is_id(id)) return no_participant(id);
  const fs::path file = folder_of(id) / kPersonFile;
  const auto json = read_json(file);
  if (json) return person_from(*json, file);
  return json.error().code == ErrorCode::kNotFound ? no_participant(id) : json.error();
}

std::vector<std::string> StudyFolder::participants() const {
  std::vector<std::string> ids;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_ / kPeople, error)) {
    const std::string id = entry.path().filename().string();
    if (is_id(id) && fs::exists(entry.path() / kPersonFile, error)) ids.push_back(id);
  }
  std::ranges::sort(ids, {}, [](const std::string& id) { return std::pair(id.size(), id); });
  return ids;
}

Status StudyFolder::append(const std::string& id, std::uint64_t batch, const Json& records) {
  if (!records.is_array() || records.size() > kMaxBatchRecords)
    return Error{ErrorCode::kMalformed, "the records of a session are a list of at most 2000"};
  for (const Json& record : records) {
    if (auto status = check_record(record); !status) return status;
  }
  const auto before = progress(id);
  if (!before) return before.error();
  if (batch <= before->batch) return {};
  const fs::path file = folder_of(id) / kLogFile;
  std::error_code error;
  if (fs::exists(file, error) && fs::file_size(file, error) > kMaxLogBytes)
    return Error{ErrorCode::kTooLarge, "the log of this session is full"};
  std::string lines;
  for (const Json& record : records) lines += record.dump() + "\n";
  // The mark at the end makes a batch count: one that was cut off by a crash is sent again.
  lines += Json{{"batch", batch}}.dump();
  if (auto status = io::append_line(file, lines); !status) return status;
  Progress& progress = progress_[id];
  for (const Json& record : records) count(record, progress);
  progress.batch = batch;
  return {};
}

void StudyFolder::count(const Json& record, Progress& progress) {
  progress.t = std::max(progress.t, record.at("t").get<double>());
  if (ends_step(record))
    progress.steps = std::max(progress.steps, record.at("step").get<std::size_t>() + 1);
}

StudyFolder::Log StudyFolder::read_log(const std::string& id) const {
  Log log;
  std::vector<Json> pending;
  std::ifstream file(folder_of(id) / kLogFile);
  for (std::string line; std::getline(file, line);) {
    Json record = Json::parse(line, nullptr, false);
    const auto batch = record.is_object() ? record.find("batch") : record.end();
    if (record.is_object() && batch != record.end() && batch->is_number_unsigned()) {
      log.progress.batch = batch->get<std::uint64_t>();
      for (Json& one : pending) {
        count(one, log.progress);
        log.records.push_back(std::move(one));
      }
      pending.clear();
    } else if (check_record(record)) {
      pending.push_back(std::move(record));
    } else {
      pending.clear();  // of a batch that was cut off, which follows once more
    }
  }
  return log;
}

Result<StudyFolder::Log> StudyFolder::log(const std::string& id) const {
  if (const auto known = participant(id); !known) return known.error();
  return read_log(id);
}

Result<StudyFolder::Progress> StudyFolder::progress(const std::string& id) {
  if (const auto known = participant(id); !known) return known.error();
  const auto known = progress_.find(id);
  if (known != progress_.end()) return known->second;
  return progress_[id] = read_log(id).progress;
}

Status StudyFolder::erase(const std::string& id, nanoseconds now) {
  std::error_code error;
  if (!is_id(id) || !fs::is_directory(folder_of(id), error)) return no_participant(id);
  // First away, then empty: a session that goes on finds nothing of it.
  const fs::path gone = folder_ / (".erasing-" + id);
  fs::rename(folder_of(id), gone, error);
  if (!error) fs::remove_all(gone, error);
  if (error) return Error{ErrorCode::kUnavailable, "cannot erase " + id + ": " + error.message()};
  return io::append_line(folder_ / kErasedFile, id + " erased " + utc_millisecond(now));
}

}  // namespace roomcast::study
