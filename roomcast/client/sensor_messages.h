// SPDX-License-Identifier: Apache-2.0
// The messages by which a sensor joins its hub and reports its state.
#pragma once

#include "roomcast/client/publisher.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::client {

[[nodiscard]] wire::pb::Join join_message(const PublisherOptions& options);
/// The sensor was moved.
[[nodiscard]] wire::pb::Control moved_message();
[[nodiscard]] wire::pb::Control health_message(const wire::pb::SensorHealth& health);

}  // namespace roomcast::client
