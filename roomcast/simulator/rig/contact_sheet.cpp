// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/rig/contact_sheet.h"

#include <algorithm>
#include <array>
#include <system_error>

#include "roomcast/io/image_file.h"
#include "roomcast/simulator/people/moving_picture.h"
#include "roomcast/simulator/simulated_room.h"
#include "roomcast/simulator/tracing/static_plate.h"

namespace roomcast::simulator {
namespace {

constexpr int kSensors = 4;
constexpr double kSensorLens = 0.56;  // focal length / width, about a Kinect's colour camera
constexpr double kFreeLens = 0.52;
constexpr int kScoutWidth = 128;  // of the small pictures used to choose views

int height_of(int width) {
  return width * 9 / 16;
}

CameraIntrinsics lens_of(int width, double focal_share) {
  CameraIntrinsics lens;
  lens.width = width;
  lens.height = height_of(width);
  lens.fx = lens.fy = focal_share * width;
  lens.cx = 0.5 * (width - 1);
  lens.cy = 0.5 * (lens.height - 1);
  return lens;
}

RigidTransform pose_of(const simulator::SensorMount& mount) {
  return world_from_optical_looking_at(mount.eye_m.cast<double>(), mount.target_m.cast<double>());
}

/// Renders pictures of a room with its people.
class RoomPhotographer {
 public:
  RoomPhotographer(const SimulatedRoom& room, int threads)
      : room_(room), threads_(threads), things_(room.room()) {}

  void move_to(nanoseconds scene_time) { things_.move_to(scene_time); }

  /// Share of the picture that shows people not hidden by furniture, limited to kEnough.
  [[nodiscard]] float people_in_view(const simulator::SensorMount& mount, double lens) {
    constexpr float kEnough = 0.05F;
    const simulator::PlacedCamera camera(lens_of(kScoutWidth, lens), pose_of(mount));
    simulator::MovingLayer layer(camera.width(), camera.height());
    layer.draw(things_, camera);
    int seen = 0, all = 0;
    for (int y = 0; y < camera.height(); y += 2) {
      for (int x = 0; x < camera.width(); x += 2) {
        ++all;
        const float z = layer.z_m().at(x, y);
        if (z > 1e3F) continue;
        seen += room_.rays().blocked(camera.eye_m(), camera.point(x, y, 0.99F * z)) ? 0 : 1;
      }
    }
    return std::min(kEnough, static_cast<float>(seen) / static_cast<float>(all));
  }

  [[nodiscard]] ColorImage photograph(const simulator::SensorMount& mount, int width, double lens) {
    const simulator::PlacedCamera camera(lens_of(width, lens), pose_of(mount));
    const auto plate = simulator::trace_color_plate(room_.room(), room_.rays(), camera, threads_);
    ColorImage picture = plate.color;
    simulator::MovingLayer layer(camera.width(), camera.height());
    layer.draw(things_, camera);
    simulator::MovingColors colors;
    colors.light(things_, room_.room());
    colors.put_shade(room_.room(), camera, plate, picture.view());
    colors.put(things_, layer, plate, room_.texels(), picture.view());
    return picture;
  }

  /// The corner, at a height of 1.95 m, from which people cover the largest share of the picture.
  [[nodiscard]] simulator::SensorMount free_view() {
    const Eigen::Vector3f middle(0, 0.75F, 0);
    simulator::SensorMount best;
    float largest = -1.0F;
    for (int corner = 0; corner < 4; ++corner) {
      const float x = (corner & 1) != 0 ? 1.0F : -1.0F;
      const float z = (corner & 2) != 0 ? 1.0F : -1.0F;
      const simulator::SensorMount mount{{x * (0.5F * room_.room().size_m.x() - 0.3F), 1.95F,
                                          z * (0.5F * room_.room().size_m.z() - 0.3F)},
                                         middle};
      const float seen = people_in_view(mount, kFreeLens);
      if (seen <= largest) continue;
      largest = seen;
      best = mount;
    }
    return best;
  }

  /// The instant within 30 s at which the sensors see the largest of the people.
  [[nodiscard]] nanoseconds lively_instant() {
    nanoseconds best{};
    float largest = -1.0F;
    for (int second = 1; second < 30; second += 2) {
      move_to(std::chrono::seconds(second));
      float seen = 0.0F;
      for (int i = 0; i < kSensors; ++i)
        seen +=
            people_in_view(room_.room().sensor_mounts[static_cast<std::size_t>(i)], kSensorLens);
      if (seen <= largest) continue;
      largest = seen;
      best = std::chrono::seconds(second);
    }
    return best;
  }

 private:
  const SimulatedRoom& room_;
  int threads_;
  simulator::MovingThings things_;
};

void paste(ColorView picture, int left, int top, ImageView<Rgb8> sheet) {
  for (int y = 0; y < picture.height; ++y)
    std::copy_n(picture.row(y), picture.width, sheet.row(top + y) + left);
}

}  // namespace

Result<ColorImage> contact_sheet(std::string_view scene, const ContactSheetOptions& options) {
  if (options.cell_width < 64 || options.cell_width > 1920) {
    return Error{ErrorCode::kInvalidArgument,
                 "The views of a contact sheet are 64 to 1920 pixels wide."};
  }
  const auto room = SimulatedRoom::build(scene, options.seed);
  if (!room) return room.error();
  RoomPhotographer photographer(**room, options.threads);
  photographer.move_to(photographer.lively_instant());

  const int width = options.cell_width;
  const int height = height_of(width);
  ColorImage sheet(4 * width, 2 * height);
  paste(photographer.photograph(photographer.free_view(), 2 * width, kFreeLens), 0, 0,
        sheet.view());
  for (int i = 0; i < kSensors; ++i) {
    const auto& mount = (*room)->room().sensor_mounts[static_cast<std::size_t>(i)];
    paste(photographer.photograph(mount, width, kSensorLens), (2 + i % 2) * width, (i / 2) * height,
          sheet.view());
  }
  return sheet;
}

Status write_contact_sheets(const std::filesystem::path& folder, const ContactSheetOptions& options,
                            const std::function<void(int done, int total)>& done) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    return Error{ErrorCode::kUnavailable, "Cannot make the folder " + folder.string() + "."};
  int count = 0;
  for (const std::string_view scene : simulator::kSceneNames) {
    auto sheet = contact_sheet(scene, options);
    if (!sheet) return std::move(sheet).error();
    const auto path = folder / (std::string(scene) + ".jpg");
    Status written = io::write_color_jpeg(path, sheet->view(), kContactSheetQuality);
    if (!written) return written;
    if (done) done(++count, static_cast<int>(simulator::kSceneNames.size()));
  }
  return {};
}

}  // namespace roomcast::simulator
