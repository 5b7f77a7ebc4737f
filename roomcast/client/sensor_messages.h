// SPDX-License-Identifier: Apache-2.0
// The messages by which a sensor joins its hub and says that it was moved.
#pragma once

#include "roomcast/client/publisher.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::client {

[[nodiscard]] wire::pb::Join join_message(const PublisherOptions& options);
/// The sensor was moved.
[[nodiscard]] wire::pb::Control moved_message();

}  // namespace roomcast::client
