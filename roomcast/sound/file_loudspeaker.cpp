// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sound/file_loudspeaker.h"

#include "roomcast/core/interruptible_wait.h"

namespace roomcast::sound {

Result<std::unique_ptr<Loudspeaker>> FileLoudspeaker::create(const std::filesystem::path& path) {
  auto file = WavFile::create(path, 2);
  if (!file) return file.error();
  return std::unique_ptr<Loudspeaker>(new FileLoudspeaker(*std::move(file), SteadyClock().now()));
}

FileLoudspeaker::~FileLoudspeaker() {
  static_cast<void>(file_.finish());  // nobody is left who could be told
}

Result<bool> FileLoudspeaker::play(const StereoBlock& block, const std::stop_token& stop) {
  file_.append(block);
  constexpr std::chrono::milliseconds kLength{20};
  next_ += kLength;
  return wait_until(next_, stop);
}

}  // namespace roomcast::sound
