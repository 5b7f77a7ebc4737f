// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/hub_study.h"

#include <future>
#include <utility>

#include <boost/asio/post.hpp>
#include <nlohmann/json.hpp>
#include <openssl/crypto.h>

#include "roomcast/core/hex_text.h"
#include "roomcast/hub/access/one_time_code.h"
#include "roomcast/hub/access/sha256.h"
#include "roomcast/io/file_bytes.h"
#include "roomcast/recording/recorder/unix_clock.h"

namespace roomcast::hub::daemon {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kPlanIdDigits = 16;

std::string hex_digest(std::string_view bytes) {
  return hex_text(hub::sha256_of(bytes));
}

/// In a time that tells nothing of where they differ.
bool are_equal(const std::string& a, const std::string& b) {
  return a.size() == b.size() && CRYPTO_memcmp(a.data(), b.data(), a.size()) == 0;
}

nanoseconds now_since_1970() {
  return recording::UnixClock().now();
}

}  // namespace

Result<std::shared_ptr<HubStudy>> HubStudy::open(const std::filesystem::path& file,
                                                 const std::filesystem::path& folder) {
  std::vector<std::uint8_t> bytes;
  if (auto status = io::read_file(file, study::kMaxPlanBytes, bytes); !status)
    return status.error();
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  auto plan = study::plan_of(text, file);
  if (!plan) return plan.error();
  auto pictures = study::ComparisonPictures::find(*plan, file.parent_path());
  if (!pictures) return pictures.error();
  const std::string digest = hex_digest(text);
  auto opened = study::StudyFolder::create(folder, *plan, text, digest);
  if (!opened) return opened.error();
  return std::shared_ptr<HubStudy>(new HubStudy(*std::move(plan), digest.substr(0, kPlanIdDigits),
                                                *std::move(pictures), *std::move(opened)));
}

HubStudy::HubStudy(study::StudyPlan plan, std::string plan_id, study::ComparisonPictures pictures,
                   study::StudyFolder folder)
    : plan_(std::move(plan)),
      pictures_(std::move(pictures)),
      plan_id_(std::move(plan_id)),
      plan_json_([this] {
        Json json = study::to_json(plan_);
        json["id"] = plan_id_;
        for (Json& comparison : json["comparisons"])
          comparison["pairs"] = pictures_.pairs(comparison["name"].get<std::string>());
        return json.dump();
      }()),
      folder_(std::move(folder)),
      worker_([this] { orders_.run(); }) {}

HubStudy::~HubStudy() {
  keep_open_.reset();
  worker_.join();
}

void HubStudy::enroll(std::string plan_id, WhenDone done) {
  boost::asio::post(orders_, [this, plan_id = std::move(plan_id), done = std::move(done)] {
    done(enroll_now(plan_id));
  });
}

void HubStudy::resume(hub::StudyCaller caller, WhenDone done) {
  boost::asio::post(orders_, [this, caller = std::move(caller), done = std::move(done)] {
    done(resume_now(caller));
  });
}

void HubStudy::picture(hub::StudyCaller caller, hub::StudyPicture wanted,
                       std::function<void(Result<hub::PictureFile>)> done) {
  boost::asio::post(orders_, [this, caller = std::move(caller), wanted = std::move(wanted),
                              done = std::move(done)] {
    if (const auto known = admitted(caller); !known) return done(known.error());
    auto picture = pictures_.read(wanted.comparison, wanted.pair, wanted.is_real);
    if (!picture) return done(picture.error());
    done(hub::PictureFile{picture->content_type, std::move(picture->bytes)});
  });
}

void HubStudy::log(hub::StudyCaller caller, std::uint64_t batch, std::string records,
                   WhenDone done) {
  boost::asio::post(orders_, [this, caller = std::move(caller), batch, records = std::move(records),
                              done = std::move(done)] {
    if (const auto known = admitted(caller); !known) return done(known.error());
    const Status status =
        folder_.append(caller.participant, batch, Json::parse(records, nullptr, false));
    done(status ? Result<std::string>("{}") : Result<std::string>(status.error()));
  });
}

void HubStudy::settle() {
  std::promise<void> answered;
  boost::asio::post(orders_, [&answered] { answered.set_value(); });
  answered.get_future().wait();
}

Result<std::string> HubStudy::enroll_now(const std::string& plan_id) {
  if (plan_id != plan_id_)
    return invalid_argument("the study has been changed since this page was loaded; load it again");
  const std::string key = hub::make_token_id();
  const auto person = folder_.enroll(plan_, hex_digest(key), now_since_1970());
  if (!person) return person.error();
  return Json{{"participant", person->id},
              {"key", key},
              {"order", person->order},
              {"steps", 0},
              {"batch", 0},
              {"t", 0}}
      .dump();
}

Result<std::string> HubStudy::resume_now(const hub::StudyCaller& caller) {
  const auto person = admitted(caller);
  if (!person) return person.error();
  const auto progress = folder_.progress(caller.participant);
  if (!progress) return progress.error();
  return Json{{"participant", person->id},
              {"order", person->order},
              {"steps", progress->steps},
              {"batch", progress->batch},
              {"t", progress->t}}
      .dump();
}

Result<study::Participant> HubStudy::admitted(const hub::StudyCaller& caller) const {
  auto person = folder_.participant(caller.participant);
  if (person && are_equal(person->key_sha256, hex_digest(caller.key))) return person;
  if (person || person.error().code == ErrorCode::kNotFound) {
    return Error{ErrorCode::kNotFound,
                 "this study has no such participant: the session was erased, or is another "
                 "person's"};
  }
  return person.error();
}

}  // namespace roomcast::hub::daemon
