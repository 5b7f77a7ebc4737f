// SPDX-License-Identifier: Apache-2.0
// A rigid transform as in wire messages. The hub computes poses only for placing viewers and
// unplaced sensors.
#pragma once

#include <array>

namespace roomcast::hub {

using Matrix4 = std::array<double, 16>;  // row-major, metres

}  // namespace roomcast::hub
