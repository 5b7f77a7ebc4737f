// SPDX-License-Identifier: Apache-2.0
// For tests/cli/ros2.test.mjs: a ROS 2 system by another DDS implementation, Fast DDS.
//   read DOMAIN COUNT QUALITY TOPIC=TYPE...   prints the first COUNT messages of each topic, a JSON
//                                             object a line; TYPE is Image, CameraInfo, PointCloud2
//                                             or TFMessage; QUALITY sensor_data or reliable
//   camera DOMAIN                             is a camera: depth and colour, 20 times a second
// Ends after 25 s at the latest.
#include "tests/ros2_peer.h"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <mutex>
#include <string>
#include <thread>

#include <nlohmann/json.hpp>

namespace ros2_peer {
namespace {

using nlohmann::json;
using std::chrono::steady_clock;

constexpr std::chrono::seconds kLongest{25};

std::string hex(const std::vector<std::uint8_t>& bytes) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes) text += {kDigits[byte >> 4U], kDigits[byte & 15U]};
  return text;
}

json of(const Header& header) {
  return {{"sec", header.sec}, {"nanosec", header.nanosec}, {"frame_id", header.frame_id}};
}
json of(const Picture& m) {
  return {{"header", of(m.header)},
          {"height", m.height},
          {"width", m.width},
          {"encoding", m.encoding},
          {"is_bigendian", m.is_bigendian},
          {"step", m.step},
          {"data", hex(m.data)}};
}
json of(const CameraInfo& m) {
  return {{"header", of(m.header)},
          {"height", m.height},
          {"width", m.width},
          {"distortion_model", m.distortion_model},
          {"d", m.d},
          {"k", m.k},
          {"r", m.r},
          {"p", m.p},
          {"binning", {m.binning_x, m.binning_y}},
          {"roi", {m.x_offset, m.y_offset, m.roi_height, m.roi_width, m.do_rectify}}};
}
json of(const PointCloud2& m) {
  json fields = json::array();
  for (const PointField& f : m.point_fields)
    fields.push_back({f.name, f.offset, f.datatype, f.count});
  return {{"header", of(m.header)},
          {"height", m.height},
          {"width", m.width},
          {"fields", fields},
          {"is_bigendian", m.is_bigendian},
          {"point_step", m.point_step},
          {"row_step", m.row_step},
          {"data", hex(m.data)},
          {"is_dense", m.is_dense}};
}
json of(const TFMessage& m) {
  json list = json::array();
  for (const TransformStamped& t : m.transforms)
    list.push_back({{"header", of(t.header)},
                    {"child_frame_id", t.child_frame_id},
                    {"translation", t.translation},
                    {"rotation", t.rotation}});
  return {{"transforms", list}};
}

int read(int domain, int count, const std::string& quality,
         const std::vector<std::string>& topics) {
  Peer peer(domain);
  std::mutex mutex;
  std::atomic<int> left = count * static_cast<int>(topics.size());
  const auto listen = [&]<class Message>(const std::string& name, Quality how) {
    auto seen = std::make_shared<int>(0);
    peer.reader<Message>(name, how, [&, name, seen](Message& message) {
      const std::lock_guard lock(mutex);
      if (++*seen > count) return;
      json line = of(message);
      line["topic"] = name;
      std::cout << line.dump() << std::endl;
      --left;
    });
  };
  const Quality how = quality == "reliable" ? Quality::kReliable : Quality::kSensorData;
  for (const std::string& topic : topics) {
    const std::string name = topic.substr(0, topic.find('='));
    const std::string type = topic.substr(topic.find('=') + 1);
    if (type == "Image") listen.operator()<Picture>(name, how);
    if (type == "CameraInfo") listen.operator()<CameraInfo>(name, how);
    if (type == "PointCloud2") listen.operator()<PointCloud2>(name, how);
    if (type == "TFMessage") listen.operator()<TFMessage>(name, Quality::kStaticTransforms);
  }
  for (const auto end = steady_clock::now() + kLongest; left > 0 && steady_clock::now() < end;)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return left > 0 ? 1 : 0;
}

constexpr std::uint32_t kWidth = 32, kHeight = 24;

CameraInfo info_of(const Header& header) {
  CameraInfo info;
  info.header = header;
  info.width = kWidth, info.height = kHeight;
  info.distortion_model = "plumb_bob";
  info.d = {0, 0, 0, 0, 0};
  info.k = {30, 0, 15.5, 0, 30, 11.5, 0, 0, 1};
  info.r = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  info.p = {30, 0, 15.5, 0, 0, 30, 11.5, 0, 0, 0, 1, 0};
  return info;
}

/// Depth of 1000 mm + x + 10 y; the colour is of one value.
int camera(int domain) {
  Peer peer(domain);
  auto* depth = peer.writer<Picture>("/peer/depth/image_raw", Quality::kReliable);
  auto* depth_info = peer.writer<CameraInfo>("/peer/depth/camera_info", Quality::kReliable);
  auto* color = peer.writer<Picture>("/peer/color/image_raw", Quality::kReliable);
  auto* color_info = peer.writer<CameraInfo>("/peer/color/camera_info", Quality::kReliable);
  auto* frames = peer.writer<TFMessage>("/tf_static", Quality::kStaticTransforms);
  TFMessage tree;
  tree.transforms.push_back({{0, 0, "peer_depth"}, "peer_color", {0.05, 0, 0}, {0, 0, 0, 1}});
  frames->write(&tree);
  Picture d, c;
  d.width = c.width = kWidth, d.height = c.height = kHeight;
  d.encoding = "16UC1", d.step = 2 * kWidth;
  c.encoding = "rgb8", c.step = 3 * kWidth;
  for (std::uint32_t i = 0; i < kWidth * kHeight; ++i) {
    const std::uint32_t mm = 1000 + i % kWidth + 10 * (i / kWidth);
    d.data.insert(d.data.end(),
                  {static_cast<std::uint8_t>(mm), static_cast<std::uint8_t>(mm >> 8)});
    c.data.insert(c.data.end(), {200, 100, 50});
  }
  std::cout << "camera" << std::endl;
  for (const auto end = steady_clock::now() + kLongest; steady_clock::now() < end;) {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    d.header = {
        static_cast<std::int32_t>(now / std::chrono::seconds(1)),
        static_cast<std::uint32_t>(now % std::chrono::seconds(1) / std::chrono::nanoseconds(1)),
        "peer_depth"};
    c.header = d.header;
    c.header.frame_id = "peer_color";
    CameraInfo of_depth = info_of(d.header), of_color = info_of(c.header);
    depth->write(&d), depth_info->write(&of_depth), color->write(&c), color_info->write(&of_color);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return 0;
}

}  // namespace
}  // namespace ros2_peer

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  int code = 2;
  if (arguments.size() == 2 && arguments[0] == "camera")
    code = ros2_peer::camera(std::stoi(arguments[1]));
  if (arguments.size() > 4 && arguments[0] == "read")
    code = ros2_peer::read(std::stoi(arguments[1]), std::stoi(arguments[2]), arguments[3],
                           {arguments.begin() + 4, arguments.end()});
  std::cout.flush();
  std::_Exit(code);  // readers may still be called
}
