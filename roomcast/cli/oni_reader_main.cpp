// SPDX-License-Identifier: Apache-2.0
// roomcast-oni-reader FILE loop|once: started by programs that play a .oni file; writes its frames
// to standard output for them. A damaged file ends this program only.
#include <string_view>

#include <sys/resource.h>
#include <unistd.h>

#include "roomcast/source/drivers/openni2/oni_reader.h"

int main(int argc, char** argv) {
  constexpr int kWrongUsage = 2;
  if (argc != 3) return kWrongUsage;
  const rlimit no_core_file{};
  (void)::setrlimit(RLIMIT_CORE, &no_core_file);
  roomcast::source::read_oni_file(argv[1], std::string_view(argv[2]) == "loop", STDOUT_FILENO);
}
