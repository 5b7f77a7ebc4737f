// SPDX-License-Identifier: Apache-2.0
// A viewer in a process of its own: `node lone_viewer.mjs ws://HOST:PORT ROOM`. It prints a line once it sees the room,
// and then, for each input line, the share of the sets since the previous line that it received.
import { createInterface } from 'node:readline';

import { RoomClient } from './room_client.mjs';

const viewer = await RoomClient.join({ after: () => {} }, process.argv[2], { room: process.argv[3] });
await viewer.moreSets(45);
console.log('watches');
for await (const _ of createInterface({ input: process.stdin })) {
  const { sets } = viewer;
  console.log(String(sets.length / (sets.at(-1).id - sets[0].id + 1)));
  sets.splice(0, sets.length - 1);
}
viewer.socket.terminate();
