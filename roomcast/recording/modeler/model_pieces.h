// SPDX-License-Identifier: Apache-2.0
// ModelPieces: the model of a running room as it is sent to viewers: the mesh, cut along a grid of
// cubes, each piece coded by Draco. A new mesh replaces only the pieces that look different, so
// that viewers who have the others need not get them again. docs/spec/model.md. Metres, world
// frame. Single-threaded.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/model/room_mesh.h"
#include "roomcast/model/room_volume.h"

namespace roomcast::recording {

/// Edge of the cubes.
inline constexpr float kPieceEdge_m = 2;

class ModelPieces {
 public:
  /// `version` is larger than that of all updates before. True: something is different.
  bool update(const model::RoomMesh& mesh, std::uint64_t version);

  /// That of the newest piece; 0: there is none.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  [[nodiscard]] std::size_t bytes() const;

  /// The answer to a viewer that has the pieces up to `known` (0: none): the newer pieces, and the
  /// places where a piece has gone. A version from before the first update is of an earlier run:
  /// then the answer has all pieces, and tells the viewer to forget those it has.
  [[nodiscard]] std::string changes_after(std::uint64_t known) const;

 private:
  /// What of a piece can be told apart by eye: where it is, and its colour.
  struct Look {
    std::vector<std::uint64_t> places;  // sorted: small cubes with points
    double level = 0;                   // mean of its colours
  };
  struct Piece {
    std::uint64_t version = 0;
    std::uint64_t update = 0;         // in which it changed last
    std::vector<std::uint8_t> draco;  // empty: it has gone
    Look look;
  };
  [[nodiscard]] static Look look_of(const model::RoomMesh& mesh);
  [[nodiscard]] static bool look_alike(const Look& a, const Look& b, std::int64_t same_things);

  std::map<model::GridPlace, Piece> pieces_;
  std::uint64_t first_version_ = 0, version_ = 0, updates_ = 0;
};

/// The parts of `mesh` by the cube in which the middle of their triangles is, points numbered anew.
[[nodiscard]] std::map<model::GridPlace, model::RoomMesh> cut_mesh(const model::RoomMesh& mesh,
                                                                   float edge_m);

}  // namespace roomcast::recording
