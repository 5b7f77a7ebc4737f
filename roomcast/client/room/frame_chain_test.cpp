// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/room/frame_chain.h"

#include <gtest/gtest.h>

namespace roomcast::client {
namespace {

wire::FrameHeader frame(std::uint32_t seq, std::uint32_t base_seq, std::uint8_t layer = 0) {
  wire::FrameHeader header;
  header.key = seq == base_seq;
  header.seq = seq;
  header.base_seq = base_seq;
  header.layer = layer;
  return header;
}

TEST(FrameChain, begins_with_a_key_frame) {
  FrameChain chain;
  EXPECT_FALSE(chain.may_decode(frame(1, 0)));
  EXPECT_TRUE(chain.may_decode(frame(2, 2)));
}

TEST(FrameChain, builds_on_the_newest_base_frame_only) {
  FrameChain chain;
  chain.decoded(frame(0, 0));
  chain.decoded(frame(1, 0, 1));
  EXPECT_TRUE(chain.may_decode(frame(2, 0)));
  chain.decoded(frame(2, 0));
  EXPECT_FALSE(chain.may_decode(frame(3, 0, 1)));
  EXPECT_TRUE(chain.may_decode(frame(3, 2, 1)));
}

TEST(FrameChain, once_broken_only_a_key_frame_helps) {
  FrameChain chain;
  chain.decoded(frame(0, 0));
  chain.broke();
  EXPECT_FALSE(chain.may_decode(frame(1, 0)));
  EXPECT_TRUE(chain.may_decode(frame(2, 2)));
}

}  // namespace
}  // namespace roomcast::client
