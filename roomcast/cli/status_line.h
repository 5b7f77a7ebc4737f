// SPDX-License-Identifier: Apache-2.0
// StatusLine: one line on a terminal that is written over; nothing at all where stderr is not a
// terminal.
#pragma once

#include <string_view>

namespace roomcast::cli {

class StatusLine {
 public:
  StatusLine();
  ~StatusLine();
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  void show(std::string_view text);

 private:
  const bool on_terminal_;
  bool shown_ = false;
};

}  // namespace roomcast::cli
