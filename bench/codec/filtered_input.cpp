// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/filtered_input.h"

#include <utility>

#include "roomcast/sensor/interference_filter.h"

namespace roomcast::bench {
namespace {

class FilteredInput final : public BenchInput {
 public:
  explicit FilteredInput(std::unique_ptr<BenchInput> input)
      : input_(std::move(input)), filter_(input_->fps()) {}

  std::string name() const override { return input_->name() + ", without interference"; }
  double fps() const override { return input_->fps(); }
  ColorReference color_reference() const override { return input_->color_reference(); }

  Result<bool> next(BenchFrame& frame, BenchTruth& truth) override {
    auto more = input_->next(frame, truth);
    if (more && *more) filter_.filter(frame.depth_mm);
    return more;
  }

 private:
  std::unique_ptr<BenchInput> input_;
  sensor::InterferenceFilter filter_;
};

}  // namespace

std::unique_ptr<BenchInput> without_interference(std::unique_ptr<BenchInput> input) {
  return std::make_unique<FilteredInput>(std::move(input));
}

}  // namespace roomcast::bench
