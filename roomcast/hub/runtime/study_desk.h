// SPDX-License-Identifier: Apache-2.0
// StudyDesk: the pages' view of the study that this hub runs (docs/spec/study.md). The hub itself
// keeps nothing of it. All texts are JSON objects. Threading: called on the rooms' thread; no
// member may block. Answers come later, on any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "roomcast/core/result.h"

namespace roomcast::hub {

/// Who asks, and the secret that only this participant's page has.
struct StudyCaller {
  std::string participant;
  std::string key;
};

/// One of the two pictures of a pair that a participant compares.
struct StudyPicture {
  std::string comparison;
  std::size_t pair = 0;  // its number in the plan
  bool is_real = false;  // the photograph
};

struct PictureFile {
  std::string content_type;
  std::string bytes;
};

class StudyDesk {
 public:
  using WhenDone = std::function<void(Result<std::string>)>;
  virtual ~StudyDesk() = default;

  /// What a page shows and does; "id" names this version of the plan.
  [[nodiscard]] virtual std::string plan() const = 0;
  /// In which it takes place; empty: the hub's only one.
  [[nodiscard]] virtual std::string room() const = 0;
  /// Somebody agrees to the plan with this "id". kInvalidArgument: the plan is another one by now.
  /// kUnavailable: the study is full, or the disk.
  virtual void enroll(std::string plan_id, WhenDone done) = 0;
  /// How far a session is. kNotFound: no such participant, or another key.
  virtual void resume(StudyCaller caller, WhenDone done) = 0;
  /// kNotFound: no such participant, or no such picture. kUnavailable: the disk.
  virtual void picture(StudyCaller caller, StudyPicture wanted,
                       std::function<void(Result<PictureFile>)> done) = 0;
  /// `records`: a JSON list. Errors as StudyFolder::append().
  virtual void log(StudyCaller caller, std::uint64_t batch, std::string records, WhenDone done) = 0;

  /// Returns when everything asked so far has been answered. Call when the hub ends.
  virtual void settle() = 0;
};

}  // namespace roomcast::hub
