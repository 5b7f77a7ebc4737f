// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/model/model_follower.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "roomcast/core/interruptible_wait.h"
#include "roomcast/net/http_fetch.h"
#include "roomcast/net/http_request.h"

namespace roomcast::client {
namespace {

using namespace std::chrono_literals;

constexpr auto kBetweenRequests = 4s;  // as in the page (web/src/model/model_follower.ts)
constexpr int kOk = 200, kNothingNewer = 204, kNotFound = 404;

Result<std::optional<model::DecodedModel>> answered(const net::FetchedAnswer& answer) {
  if (answer.status == kNothingNewer) return std::optional<model::DecodedModel>();
  if (answer.status != kOk)
    return Error{answer.status == kNotFound ? ErrorCode::kNotFound : ErrorCode::kUnavailable,
                 "the hub does not give the room's model (HTTP status " +
                     std::to_string(answer.status) + ")"};
  auto decoded = model::decode_model(
      {reinterpret_cast<const std::uint8_t*>(answer.body.data()), answer.body.size()});
  if (!decoded) return decoded.error();
  return std::optional(*std::move(decoded));
}

}  // namespace

Result<std::optional<model::DecodedModel>> fetch_model(const ModelSource& source,
                                                       const std::string& room,
                                                       std::uint64_t version,
                                                       const std::stop_token& stop) {
  const auto hubs = net::parse_hub_urls(source.hub_url);
  if (!hubs) return hubs.error();
  std::string target = "/api/v1/rooms/" + net::percent_encoded(room) + "/model";
  if (version != 0) target += "/after/" + std::to_string(version);
  net::FetchOptions options;
  options.token = source.token;
  options.stop = stop;
  Error last{ErrorCode::kUnavailable, "there is no hub"};
  for (const net::HubUrl& hub : *hubs) {
    const auto answer = net::fetch(hub, target, options);
    if (answer) return answered(*answer);
    last = answer.error();
  }
  return last;
}

class ModelFollower::Work {
 public:
  explicit Work(ModelSource source)
      : source_(std::move(source)), thread_([this](const std::stop_token& stop) { run(stop); }) {}

  void follow(const std::string& room) {
    const std::lock_guard lock(mutex_);
    if (!room_.empty()) return;
    room_ = room;
    room_is_known_.notify_one();
  }

  std::vector<model::DecodedModel> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(news_, {});
  }

 private:
  void run(const std::stop_token& stop) {
    const std::string room = wait_for_room(stop);
    std::uint64_t version = 0;
    while (!stop.stop_requested()) {
      auto changes = fetch_model(source_, room, version, stop);
      if (changes && *changes) {
        version = (*changes)->version;
        const std::lock_guard lock(mutex_);
        news_.push_back(**std::move(changes));
      }
      (void)wait_for(kBetweenRequests, stop);
    }
  }

  std::string wait_for_room(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    room_is_known_.wait(lock, stop, [this] { return !room_.empty(); });
    return room_;
  }

  const ModelSource source_;
  std::mutex mutex_;
  std::condition_variable_any room_is_known_;
  std::string room_;  // the rest by both threads
  std::vector<model::DecodedModel> news_;
  std::jthread thread_;  // last: uses all of the above
};

ModelFollower::ModelFollower(ModelSource source)
    : work_(std::make_unique<Work>(std::move(source))) {}
ModelFollower::~ModelFollower() = default;

void ModelFollower::follow(const std::string& room) {
  work_->follow(room);
}

std::vector<model::DecodedModel> ModelFollower::take() {
  return work_->take();
}

}  // namespace roomcast::client
