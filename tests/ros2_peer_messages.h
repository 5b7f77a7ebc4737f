// SPDX-License-Identifier: Apache-2.0
// For tests: ROS 2 messages for Fast DDS and Fast CDR, field by field as the .msg files of
// common_interfaces and geometry2 list them. Nothing here is roomcast's: it is the other
// implementation.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <fastcdr/Cdr.h>

namespace ros2_peer {

struct Header {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
  std::string frame_id;
  template <class Cdr>
  void fields(Cdr& cdr) {
    cdr(sec), cdr(nanosec), cdr(frame_id);
  }
};

struct Picture {
  static constexpr const char* kName = "sensor_msgs::msg::dds_::Image_";
  Header header;
  std::uint32_t height = 0, width = 0;
  std::string encoding;
  std::uint8_t is_bigendian = 0;
  std::uint32_t step = 0;
  std::vector<std::uint8_t> data;
  template <class Cdr>
  void fields(Cdr& cdr) {
    header.fields(cdr);
    cdr(height), cdr(width), cdr(encoding), cdr(is_bigendian), cdr(step), cdr(data);
  }
};

struct CameraInfo {
  static constexpr const char* kName = "sensor_msgs::msg::dds_::CameraInfo_";
  Header header;
  std::uint32_t height = 0, width = 0;
  std::string distortion_model;
  std::vector<double> d;
  std::array<double, 9> k{}, r{};
  std::array<double, 12> p{};
  std::uint32_t binning_x = 0, binning_y = 0;
  std::uint32_t x_offset = 0, y_offset = 0, roi_height = 0, roi_width = 0;
  bool do_rectify = false;
  template <class Cdr>
  void fields(Cdr& cdr) {
    header.fields(cdr);
    cdr(height), cdr(width), cdr(distortion_model), cdr(d), cdr(k), cdr(r), cdr(p);
    cdr(binning_x), cdr(binning_y);
    cdr(x_offset), cdr(y_offset), cdr(roi_height), cdr(roi_width), cdr(do_rectify);
  }
};

struct PointField {
  std::string name;
  std::uint32_t offset = 0;
  std::uint8_t datatype = 0;
  std::uint32_t count = 0;
  template <class Cdr>
  void fields(Cdr& cdr) {
    cdr(name), cdr(offset), cdr(datatype), cdr(count);
  }
};

struct PointCloud2 {
  static constexpr const char* kName = "sensor_msgs::msg::dds_::PointCloud2_";
  Header header;
  std::uint32_t height = 0, width = 0;
  std::vector<PointField> point_fields;
  bool is_bigendian = false;
  std::uint32_t point_step = 0, row_step = 0;
  std::vector<std::uint8_t> data;
  bool is_dense = false;
  template <class Cdr>
  void fields(Cdr& cdr) {
    header.fields(cdr);
    cdr(height), cdr(width);
    cdr.sequence(point_fields);
    cdr(is_bigendian), cdr(point_step), cdr(row_step), cdr(data), cdr(is_dense);
  }
};

struct TransformStamped {
  Header header;
  std::string child_frame_id;
  std::array<double, 3> translation{};
  std::array<double, 4> rotation{};  // x, y, z, w
  template <class Cdr>
  void fields(Cdr& cdr) {
    header.fields(cdr);
    cdr(child_frame_id), cdr(translation), cdr(rotation);
  }
};

struct TFMessage {
  static constexpr const char* kName = "tf2_msgs::msg::dds_::TFMessage_";
  std::vector<TransformStamped> transforms;
  template <class Cdr>
  void fields(Cdr& cdr) {
    cdr.sequence(transforms);
  }
};

/// Reads each field that it is given.
class Reading {
 public:
  explicit Reading(eprosima::fastcdr::Cdr& cdr) : cdr_(cdr) {}
  template <class Field>
  void operator()(Field& field) {
    cdr_.deserialize(field);
  }
  template <class Element>
  void sequence(std::vector<Element>& elements) {
    std::uint32_t count = 0;
    cdr_.deserialize(count);
    elements.resize(count);
    for (Element& element : elements) element.fields(*this);
  }

 private:
  eprosima::fastcdr::Cdr& cdr_;
};

/// Writes each field that it is given.
class Writing {
 public:
  explicit Writing(eprosima::fastcdr::Cdr& cdr) : cdr_(cdr) {}
  template <class Field>
  void operator()(Field& field) {
    cdr_.serialize(field);
  }
  template <class Element>
  void sequence(std::vector<Element>& elements) {
    cdr_.serialize(static_cast<std::uint32_t>(elements.size()));
    for (Element& element : elements) element.fields(*this);
  }

 private:
  eprosima::fastcdr::Cdr& cdr_;
};

}  // namespace ros2_peer
