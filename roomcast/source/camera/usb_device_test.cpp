// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/camera/usb_device.h"

#include <cstdlib>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::source {
namespace {

namespace fs = std::filesystem;

/// A fixture of /sys/bus/usb/devices and /dev/bus/usb.
class Usb : public testing::Test {
 protected:
  Usb() { fs::create_directories(root_ / "dev/001"); }

  void plug_in(const std::string& port, const std::string& vendor, const std::string& product,
               const std::string& speed, int number) {
    const fs::path device = root_ / "sys" / port;
    fs::create_directories(device);
    put(device / "idVendor", vendor);
    put(device / "idProduct", product);
    put(device / "speed", speed);
    put(device / "serial", "A0" + std::to_string(number));
    put(device / "busnum", "1");
    put(device / "devnum", std::to_string(number));
    put(root_ / "dev/001" / ("00" + std::to_string(number)), "");
  }
  static void put(const fs::path& file, const std::string& text) {
    std::ofstream(file) << text << '\n';
  }
  [[nodiscard]] std::vector<UsbCamera> cameras() const {
    return usb_cameras(root_ / "sys", root_ / "dev");
  }

  const TemporaryFolder root_;
};

TEST_F(Usb, recognises_depth_cameras_among_usb_devices) {
  plug_in("1-1", "045e", "02ae", "480", 3);
  plug_in("1-2", "046d", "c31c", "1.5", 4);  // a keyboard
  ASSERT_EQ(cameras().size(), 1U);
  EXPECT_EQ(cameras()[0].kind, "freenect");
  EXPECT_EQ(cameras()[0].serial, "A03");
  EXPECT_EQ(cameras()[0].node, root_ / "dev/001/003");
  EXPECT_FALSE(obstacle(cameras()[0]));
}

TEST_F(Usb, missing_permissions_name_the_file_to_install) {
  plug_in("1-1", "045e", "02ae", "480", 3);
  fs::remove(root_ / "dev/001/003");  // deleted, because root may open any existing file
  const auto found = obstacle_of_kind(cameras(), "freenect");
  ASSERT_TRUE(found);
  EXPECT_THAT(found->message, testing::HasSubstr("udev"));
  EXPECT_FALSE(obstacle_of_kind(cameras(), "openni2"));
}

TEST_F(Usb, a_usb_3_camera_in_a_usb_2_port_says_so_and_a_usb_2_camera_does_not) {
  plug_in("1-1", "045e", "02c4", "480", 3);
  EXPECT_THAT(obstacle_of_kind(cameras(), "freenect2")->message, testing::HasSubstr("USB 3"));
  plug_in("1-1", "045e", "02c4", "5000", 3);
  EXPECT_FALSE(obstacle_of_kind(cameras(), "freenect2"));
}

TEST_F(Usb, attributes_that_are_missing_or_absurd_do_no_harm) {
  fs::create_directories(root_ / "sys/1-1");
  plug_in("1-2", "zzzz", "", "fast", 5);
  plug_in("1-3", "045e", "02ae", std::string(100'000, '9'), 6);
  EXPECT_EQ(cameras().size(), 1U);
  EXPECT_TRUE(usb_cameras(root_ / "nowhere", root_.path()).empty());
}

}  // namespace
}  // namespace roomcast::source
