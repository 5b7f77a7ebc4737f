// SPDX-License-Identifier: Apache-2.0
// Reads a whole recording and prints the number of its frame sets, of its frames, and the processor
// time of reading in seconds: what the Python module is compared with.
#include <cstdio>
#include <ctime>

#include "roomcast/recording/frame_sets/frame_set_reader.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  auto reader = roomcast::recording::open_frame_sets(argv[1]);
  if (!reader) return 1;
  roomcast::recording::FrameSet set;
  std::size_t sets = 0, frames = 0;
  const std::clock_t begin = std::clock();
  for (;;) {
    const auto more = (*reader)->next(set);
    if (!more) return 1;
    if (!*more) break;
    ++sets;
    frames += set.frames.size();
  }
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  std::printf("%zu %zu %.6f\n", sets, frames, seconds);
  return 0;
}
