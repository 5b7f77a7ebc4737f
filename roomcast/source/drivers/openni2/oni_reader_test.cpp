// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/openni2/oni_reader.h"

#include <array>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "roomcast/core/result.h"
#include "roomcast/core/temporary_folder.h"
#include "roomcast/source/drivers/openni2/oni_messages.h"
#include "roomcast/source/drivers/openni2/openni2_session.h"

namespace roomcast::source {
namespace {

TEST(OniReader, says_why_openni_cannot_open_a_file) {
  const TemporaryFolder folder;
  std::ofstream(folder / "no_recording.oni") << "text";
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  on_openni2_thread([&] { read_oni_file(folder / "no_recording.oni", false, ends[1]); });
  ::close(ends[1]);
  OniMessageHeader header;
  ASSERT_EQ(::read(ends[0], &header, sizeof(header)), static_cast<ssize_t>(sizeof(header)));
  EXPECT_EQ(header.kind, OniMessageKind::kFault);
  EXPECT_EQ(header.value, static_cast<int>(ErrorCode::kUnavailable));
  std::string sentence(header.bytes, '\0');
  EXPECT_EQ(::read(ends[0], sentence.data(), sentence.size()), static_cast<ssize_t>(header.bytes));
  EXPECT_NE(sentence.find("no_recording.oni"), std::string::npos) << sentence;
  char more = 0;
  EXPECT_EQ(::read(ends[0], &more, 1), 0) << "a fault is the last message";
  ::close(ends[0]);
}

}  // namespace
}  // namespace roomcast::source
