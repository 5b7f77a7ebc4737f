// SPDX-License-Identifier: Apache-2.0
// Runs all browser test suites one after the other. In parallel they would compete for the CPU, and some measure time.
import './blend.test.mjs';
import './blocked.test.mjs';
import './codec.test.mjs';
import './gyroscope.test.mjs';
import './late_join.test.mjs';
import './marks.test.mjs';
import './memory.test.mjs';
import './nudge.test.mjs';
import './parts.test.mjs';
import './picture.test.mjs';
import './places.test.mjs';
import './playback.test.mjs';
import './recorded_voices.test.mjs';
import './recordings.test.mjs';
import './room.test.mjs';
import './security.test.mjs';
import './console.test.mjs';
import './headset.test.mjs';
import './together.test.mjs';
import './trouble.test.mjs';
import './study.test.mjs';
import './voice.test.mjs';
import './reverse_proxy.test.mjs';
import './two_recordings.test.mjs';
import './other_hub.test.mjs';
