// SPDX-License-Identifier: Apache-2.0
// Gives points whose colour no view has the colours of the surface around them, so that a picture
// of the mesh has no grey patches. What is so coloured is not measured.
#pragma once

#include "roomcast/model/room_mesh.h"

namespace roomcast::model {

/// Points of the colour kNoColor; those that hang together with no other stay so. `mesh` has
/// colours.
void spread_color(RoomMesh& mesh);

}  // namespace roomcast::model
