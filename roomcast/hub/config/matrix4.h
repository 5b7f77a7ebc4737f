// SPDX-License-Identifier: Apache-2.0
// A rigid transform as it is on the wire. The hub does no geometry but for where people start.
#pragma once

#include <array>

namespace roomcast::hub {

using Matrix4 = std::array<double, 16>;  // row-major, metres

}  // namespace roomcast::hub
