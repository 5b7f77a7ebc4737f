// SPDX-License-Identifier: Apache-2.0
// StudyFolder: what a study keeps on disk (docs/spec/study.md). People are known by a number only
// ("P007"); the key that lets a page continue a session is kept as its SHA-256. Everything of a
// participant is in one folder, which erase() removes. Single-threaded; a second process may erase
// and read meanwhile.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"
#include "roomcast/study/plan.h"

namespace roomcast::study {

inline constexpr std::uint64_t kMaxLogBytes = 256U << 20U;  // of a participant
inline constexpr std::size_t kMaxBatchRecords = 2000;

struct Participant {
  std::string id;  // "P007"
  std::size_t number = 0;
  std::vector<std::string> order = {};  // names of conditions
  std::string consented_at;             // UTC, as 2026-11-26T12:00:00.123Z
  std::string consent;                  // the text that was agreed to
  std::string key_sha256;               // hexadecimal
  std::string plan_sha256;              // of the plan, as in the folder's plans/
};

class StudyFolder {
 public:
  /// Creates the folder, closed to other users, with a copy of the plan. kUnavailable: it cannot be
  /// created or written. kInvalidArgument: it belongs to a study of another name.
  static Result<StudyFolder> create(const std::filesystem::path& folder, const StudyPlan& plan,
                                    std::string_view plan_text, std::string plan_sha256);
  /// For reading and erasing. kNotFound: it is no folder of a study.
  static Result<StudyFolder> open(const std::filesystem::path& folder);

  /// Somebody has agreed: gives them the next number. `now`: since 1970. kUnavailable: the study is
  /// full, or the disk.
  [[nodiscard]] Result<Participant> enroll(const StudyPlan& plan, std::string key_sha256,
                                           nanoseconds now);

  /// kNotFound: no such participant, or it was erased. kMalformed: the file is damaged.
  [[nodiscard]] Result<Participant> participant(const std::string& id) const;
  /// Sorted.
  [[nodiscard]] std::vector<std::string> participants() const;

  /// The plan that they took part in. Errors of load_plan().
  [[nodiscard]] Result<StudyPlan> plan_of(const Participant& participant) const;

  /// Appends checked records. A batch whose number is not above the last one is there already and
  /// is not written again. kNotFound, kMalformed as check_record(); kTooLarge: the log is full;
  /// kUnavailable: the disk.
  [[nodiscard]] Status append(const std::string& id, std::uint64_t batch,
                              const nlohmann::json& records);

  struct Progress {
    std::uint64_t batch = 0;  // the last one; 0: none
    double t = 0;             // of the last record
    std::size_t steps = 0;    // that have ended
  };
  [[nodiscard]] Result<Progress> progress(const std::string& id);

  struct Log {
    std::vector<nlohmann::json> records;
    Progress progress;
  };
  /// The participant's log, without a batch that a crash cut off. Errors of participant().
  [[nodiscard]] Result<Log> log(const std::string& id) const;

  /// Removes all of a participant, for good. kNotFound.
  [[nodiscard]] Status erase(const std::string& id, nanoseconds now);

  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
  [[nodiscard]] const std::string& study() const { return study_; }

 private:
  StudyFolder(std::filesystem::path folder, std::string study)
      : folder_(std::move(folder)), study_(std::move(study)) {}
  [[nodiscard]] std::filesystem::path folder_of(const std::string& id) const;
  [[nodiscard]] std::size_t next_number() const;
  [[nodiscard]] Log read_log(const std::string& id) const;
  static void count(const nlohmann::json& record, Progress& progress);

  std::filesystem::path folder_;
  std::string study_;                         // its name
  std::string plan_sha256_;                   // of the plan in use
  std::map<std::string, Progress> progress_;  // of sessions that were asked for
};

}  // namespace roomcast::study
