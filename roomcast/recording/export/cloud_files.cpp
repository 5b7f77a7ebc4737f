// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/export/cloud_files.h"

#include <string>

#include "roomcast/core/utc_text.h"
#include "roomcast/recording/export/little_endian_bytes.h"

namespace roomcast::recording {
namespace {

std::string captured_comment(const char* begin, nanoseconds captured) {
  if (captured.count() <= 0) return {};
  return std::string(begin) + " captured " + utc_text(captured) + "\n";
}

}  // namespace

void append_ply(const PointCloud& cloud, nanoseconds captured, std::vector<std::uint8_t>& out) {
  append_text("ply\nformat binary_little_endian 1.0\ncomment roomcast, metres, y up\n" +
                  captured_comment("comment", captured) + "element vertex " +
                  std::to_string(cloud.size()) +
                  "\nproperty float x\nproperty float y\nproperty float z\n"
                  "property float nx\nproperty float ny\nproperty float nz\n"
                  "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
              out);
  out.reserve(out.size() + 27 * cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    append_floats(cloud.points_m[i], out);
    append_floats(cloud.normals[i], out);
    const Rgb8 color = cloud.colors[i];
    out.insert(out.end(), {color.r, color.g, color.b});
  }
}

void append_pcd(const PointCloud& cloud, nanoseconds captured, std::vector<std::uint8_t>& out) {
  const std::string count = std::to_string(cloud.size());
  append_text(
      "# .PCD v0.7 - Point Cloud Data file format\n" + captured_comment("#", captured) +
          "VERSION 0.7\n"
          "FIELDS x y z normal_x normal_y normal_z rgb\nSIZE 4 4 4 4 4 4 4\nTYPE F F F F F F F\n"
          "COUNT 1 1 1 1 1 1 1\nWIDTH " +
          count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA binary\n",
      out);
  out.reserve(out.size() + 28 * cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    append_floats(cloud.points_m[i], out);
    append_floats(cloud.normals[i], out);
    const Rgb8 color = cloud.colors[i];
    append_u32(static_cast<std::uint32_t>(color.r) << 16U |
                   static_cast<std::uint32_t>(color.g) << 8U | color.b,
               out);
  }
}

}  // namespace roomcast::recording
