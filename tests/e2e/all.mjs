// SPDX-License-Identifier: Apache-2.0
// All browser tests, one suite after the other: side by side they would fight for the processor, and some look at time.
import './blend.test.mjs';
import './codec.test.mjs';
import './late_join.test.mjs';
import './memory.test.mjs';
import './nudge.test.mjs';
import './picture.test.mjs';
import './room.test.mjs';
import './security.test.mjs';
import './console.test.mjs';
import './headset.test.mjs';
import './trouble.test.mjs';
import './reverse_proxy.test.mjs';
import './other_hub.test.mjs';
