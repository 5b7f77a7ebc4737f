// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/sensor_requests.h"

#include <algorithm>
#include <utility>

namespace roomcast::hub {

std::uint32_t SensorRequests::open(ConnectionId sensor, HostTime now, Answered answered) {
  if (open_.size() >= kMaxOpen) {
    answered(unavailable("too many requests to sensors wait for an answer; try again"));
    return 0;
  }
  open_.push_back({sensor, ++newest_, now + kPatience, std::move(answered)});
  return newest_;
}

/// The requests are taken out before anybody hears of them.
template <class Which>
void SensorRequests::close(Which which, const Status& outcome) {
  const auto from = std::stable_partition(open_.begin(), open_.end(), std::not_fn(which));
  std::vector<Open> closed(std::make_move_iterator(from), std::make_move_iterator(open_.end()));
  open_.erase(from, open_.end());
  for (const Open& request : closed) request.answered(outcome);
}

void SensorRequests::answer(ConnectionId from, const wire::pb::SettingsAnswer& answer) {
  const auto is_it = [&](const Open& request) {
    return request.sensor == from && request.number == answer.number();
  };
  close(is_it, answer.refusal().empty() ? Status() : invalid_argument(answer.refusal()));
}

void SensorRequests::sensor_left(ConnectionId sensor) {
  close([sensor](const Open& request) { return request.sensor == sensor; },
        unavailable("the sensor has left without an answer"));
}

void SensorRequests::give_up_before(HostTime now) {
  close([now](const Open& request) { return request.until < now; },
        unavailable("the sensor has not answered; it goes on as it does"));
}

}  // namespace roomcast::hub
