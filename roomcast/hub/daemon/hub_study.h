// SPDX-License-Identifier: Apache-2.0
// HubStudy: the study that a hub runs: its plan, and the folder of its sessions. The disk can take
// long, so a thread of its own writes. Threading: thread-safe.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>

#include "roomcast/core/result.h"
#include "roomcast/hub/runtime/study_desk.h"
#include "roomcast/study/comparison_pictures.h"
#include "roomcast/study/plan.h"
#include "roomcast/study/study_folder.h"

namespace roomcast::hub::daemon {

class HubStudy final : public hub::StudyDesk {
 public:
  /// Errors as study::load_plan(), study::ComparisonPictures::find() and
  /// study::StudyFolder::create().
  static Result<std::shared_ptr<HubStudy>> open(const std::filesystem::path& plan,
                                                const std::filesystem::path& folder);
  ~HubStudy() override;

  [[nodiscard]] std::string plan() const override { return plan_json_; }
  [[nodiscard]] std::string room() const override { return plan_.room; }
  void enroll(std::string plan_id, WhenDone done) override;
  void resume(hub::StudyCaller caller, WhenDone done) override;
  void picture(hub::StudyCaller caller, hub::StudyPicture wanted,
               std::function<void(Result<hub::PictureFile>)> done) override;
  void log(hub::StudyCaller caller, std::uint64_t batch, std::string records,
           WhenDone done) override;
  void settle() override;

 private:
  HubStudy(study::StudyPlan plan, std::string plan_id, study::ComparisonPictures pictures,
           study::StudyFolder folder);
  // On the worker.
  Result<std::string> enroll_now(const std::string& plan_id);
  Result<std::string> resume_now(const hub::StudyCaller& caller);
  [[nodiscard]] Result<study::Participant> admitted(const hub::StudyCaller& caller) const;

  const study::StudyPlan plan_;
  const study::ComparisonPictures pictures_;
  const std::string plan_id_, plan_json_;
  study::StudyFolder folder_;
  boost::asio::io_context orders_{1};
  std::optional<boost::asio::executor_work_guard<boost::asio::io_context::executor_type>>
      keep_open_{orders_.get_executor()};
  std::jthread worker_;  // uses all of the above
};

}  // namespace roomcast::hub::daemon
