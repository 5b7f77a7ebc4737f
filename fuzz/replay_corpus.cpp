// SPDX-License-Identifier: Apache-2.0
// main() of a fuzz target without libFuzzer: runs the target on every file of the given folders,
// and on truncated or damaged copies, the same ones each time. Earlier findings of a fuzzer stay
// tested with any compiler.
//   depth_decoder_replay CORPUS...
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr int kDamagedCopies = 24, kMaxDamage = 8;  // per file; damaged bytes per copy

Bytes read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

Bytes damaged(Bytes bytes, std::mt19937& random) {
  if (bytes.empty()) return bytes;
  for (std::uint32_t n = random() % kMaxDamage; n > 0; --n) {
    bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
  }
  if (random() % 3 == 0) bytes.resize(random() % bytes.size());
  return bytes;
}

void run(const Bytes& bytes) {
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

std::vector<std::filesystem::path> files_in(const char* folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry);
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

int main(int argc, char** argv) {
  int runs = 0;
  std::mt19937 random(1);
  run({});
  for (int i = 1; i < argc; ++i) {
    for (const auto& path : files_in(argv[i])) {
      const Bytes bytes = read(path);
      run(bytes);
      for (int copy = 0; copy < kDamagedCopies; ++copy) run(damaged(bytes, random));
      runs += 1 + kDamagedCopies;
    }
  }
  std::printf("%d runs\n", runs);
  return runs > 0 ? 0 : 1;
}
