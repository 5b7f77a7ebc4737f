// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/option_fields.h"

#include <limits>

#include <gtest/gtest.h>

namespace roomcast {
namespace {

struct LensOptions {
  float focal_px = 500;
  int rings = 3;
  std::array<double, 2> centre_px = {320, 240};

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("focal_px", focal_px, Range{1, 1e4});
    visit("rings", rings, Range{1, 9});
    visit("centre_px", centre_px, Range{0, 1e4});
  }
  [[nodiscard]] Status check() const { return check_fields("LensOptions", *this); }
};

struct ShutterOptions {
  std::chrono::milliseconds open{20};
  LensOptions lens = {};

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("open_ms", open, Range{1, 1000});
    visit("lens", lens);
  }
  [[nodiscard]] Status check() const { return check_fields("ShutterOptions", *this); }
};

std::string refusal_of(const Status& status) {
  return status ? std::string("none") : status.error().message;
}

TEST(OptionFields, defaults_within_their_ranges_pass) {
  EXPECT_EQ(refusal_of(ShutterOptions{}.check()), "none");
}

TEST(OptionFields, both_ends_of_a_range_are_legal) {
  for (const int rings : {1, 9}) EXPECT_TRUE(LensOptions{.rings = rings}.check());
  for (const int rings : {0, 10}) EXPECT_FALSE(LensOptions{.rings = rings}.check());
}

TEST(OptionFields, a_refusal_names_the_struct_the_field_and_its_range) {
  EXPECT_EQ(refusal_of(LensOptions{.rings = 0}.check()), "LensOptions.rings must be 1..9");
  EXPECT_EQ(refusal_of(LensOptions{.centre_px = {0, -1}}.check()),
            "LensOptions.centre_px must be 0..10000");
  EXPECT_EQ(refusal_of(ShutterOptions{.open = std::chrono::milliseconds(0)}.check()),
            "ShutterOptions.open_ms must be 1..1000");
}

TEST(OptionFields, a_nested_struct_is_checked_and_named_by_its_path) {
  ShutterOptions options;
  options.lens.rings = 10;
  EXPECT_EQ(refusal_of(options.check()), "ShutterOptions.lens: LensOptions.rings must be 1..9");
}

TEST(OptionFields, what_is_no_number_is_refused) {
  EXPECT_FALSE(LensOptions{.focal_px = std::numeric_limits<float>::quiet_NaN()}.check());
  EXPECT_FALSE(LensOptions{.focal_px = std::numeric_limits<float>::infinity()}.check());
}

TEST(OptionFields, the_order_of_two_fields_is_checked) {
  EXPECT_TRUE(check_at_most("LensOptions", "near", 1, "far", 1));
  EXPECT_EQ(refusal_of(check_at_most("LensOptions", "near", 2, "far", 1)),
            "LensOptions.near must be at most far");
}

}  // namespace
}  // namespace roomcast
