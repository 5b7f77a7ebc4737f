// SPDX-License-Identifier: Apache-2.0
// A GLB file under construction (Khronos glTF 2.0 specification): the JSON part and the binary part
// that it refers to. Metres, y up, as glTF requires. Single-threaded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace roomcast::recording {

inline constexpr int kGlbFloat = 5126, kGlbUnsignedInt = 5125,
                     kGlbUnsignedShort = 5123;                           // component types
inline constexpr int kGlbArrayBuffer = 34962, kGlbElementArray = 34963;  // buffer targets

struct GlbDocument {
  nlohmann::json root;
  std::vector<std::uint8_t> binary;

  GlbDocument();

  /// Adds a buffer view of the bytes appended to `binary` since `begin`; target 0 is none.
  std::size_t add_view(std::size_t begin, int target);

  struct List {
    int component = kGlbFloat;
    std::size_t count = 0;
    const char* type = "SCALAR";
    bool normalized = false;
  };
  /// Adds a buffer view, as above, and the accessor of the list that it holds.
  std::size_t add_list(std::size_t begin, int target, const List& list);
  std::size_t add_positions(std::span<const Eigen::Vector3f> points_m);
  /// Adds the accessor of a list whose values an extension of the mesh holds, compressed.
  std::size_t add_coded_list(const List& list);
  /// As above, with the box of the points before they were compressed.
  std::size_t add_coded_positions(std::span<const Eigen::Vector3f> points_m, std::size_t count);
  /// A material that light does not change, with `jpeg` as its texture, or without one.
  std::size_t add_unlit_material(const std::vector<std::uint8_t>& jpeg);
  /// Adds a node of the newest mesh to the scene.
  void add_node(nlohmann::json node);

  /// Appends the file. Lists that are still empty are left out, as glTF wants it.
  void append_to(std::vector<std::uint8_t>& out);
};

}  // namespace roomcast::recording
