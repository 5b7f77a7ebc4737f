// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/alignment_options.h"

#include <limits>
#include <string>
#include <type_traits>
#include <utility>

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

template <class Value>
concept HasFields = requires(const Value& value) {
  value.for_each_field([](auto&&...) {});
};

/// Converts to whatever a field is.
struct AnyField {
  template <class Field>
  operator Field() const;  // NOLINT: implicit, never defined
};

template <class Options, std::size_t... kField>
constexpr bool has_fields(std::index_sequence<kField...>) {
  return requires {
    Options{(static_cast<void>(kField), AnyField{})...};
  };
}

/// The number of a struct's members: the most values that can initialise it.
template <class Options, std::size_t kCount = 40>
constexpr std::size_t count_members() {
  if constexpr (kCount == 0 || has_fields<Options>(std::make_index_sequence<kCount>{})) {
    return kCount;
  } else {
    return count_members<Options, kCount - 1>();
  }
}

/// Calls `visit(struct)` for `options` and for every struct in it.
template <class Options, class Visit>
void for_each_struct(const Options& options, Visit visit) {
  visit(options);
  options.for_each_field([&](std::string_view, const auto& value, auto...) {
    if constexpr (HasFields<std::remove_cvref_t<decltype(value)>>) for_each_struct(value, visit);
  });
}

TEST(AlignmentOptions, usual_values_are_legal) {
  const Status status = AlignmentOptions{}.check();
  EXPECT_TRUE(status) << status.error().message;
}

TEST(AlignmentOptions, every_member_of_every_struct_is_listed) {
  int structs = 0, numbers = 0;
  for_each_struct(AlignmentOptions{}, [&](const auto& options) {
    std::size_t listed = 0;
    std::string names;
    options.for_each_field([&](std::string_view name, const auto&, auto... range) {
      ++listed;
      names += std::string(name) + " ";
      numbers += sizeof...(range);
    });
    EXPECT_EQ(listed, (count_members<std::remove_cvref_t<decltype(options)>>())) << names;
    ++structs;
  });
  EXPECT_GT(structs, 40);
  EXPECT_GT(numbers, 230);
}

/// Writes a value that is out of range into one number after the other of a whole tree, which is
/// not const, and expects check() of the whole to name it.
template <class Options>
void expect_refusals(const AlignmentOptions& whole, const Options& part) {
  part.for_each_field([&](std::string_view name, const auto& value, auto... range) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if constexpr (HasFields<Value>) {
      expect_refusals(whole, value);
    } else if constexpr (std::is_arithmetic_v<Value>) {
      const Value usual = value;
      auto& number = const_cast<Value&>(value);
      number = static_cast<Value>(2 * (range.most + ...) + 1);
      const Status status = whole.check();
      EXPECT_FALSE(status) << name;
      if (!status) {
        EXPECT_NE(status.error().message.find("." + std::string(name) + " must be "),
                  std::string::npos)
            << name << ": " << status.error().message;
      }
      number = usual;
    }
  });
}

TEST(AlignmentOptions, a_number_out_of_its_range_is_refused_by_name) {
  AlignmentOptions options;
  expect_refusals(options, options);
  EXPECT_TRUE(options.check());
}

TEST(AlignmentOptions, the_path_of_a_refused_number_is_given) {
  AlignmentOptions options;
  options.rig.pair.coarse_voting.max_seeds = 0;
  EXPECT_EQ(options.check().error().message,
            "AlignmentOptions.rig: RigOptions.pair: PairOptions.coarse_voting: "
            "VoteOptions.max_seeds must be 1..20000");
}

TEST(AlignmentOptions, what_is_no_number_is_refused) {
  AlignmentOptions options;
  options.view.surface.noise.constant_m = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(options.check());
}

TEST(AlignmentOptions, limits_in_the_wrong_order_are_refused) {
  FeatureResidualOptions features;
  features.min_sigma_px = 4;
  EXPECT_EQ(features.check().error().message,
            "FeatureResidualOptions.min_sigma_px must be at most max_sigma_px");
  SurfaceResidualOptions surfaces;
  surfaces.min_noise = 2;
  EXPECT_FALSE(surfaces.check());
  PoseRefinementOptions pair;
  pair.min_reach_m = 0.2F;
  EXPECT_FALSE(pair.check());
  RigRefinementOptions rig;
  rig.min_reach_m = 0.2F;
  EXPECT_FALSE(rig.check());
  DepthSurfaceOptions surface;
  surface.nearest_m = 8;
  EXPECT_FALSE(surface.check());
}

}  // namespace
}  // namespace roomcast::alignment
