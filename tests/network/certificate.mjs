// SPDX-License-Identifier: Apache-2.0
// A certificate for a server of these tests: one that a hub has made for itself.
import { join } from 'node:path';

import { startHub } from '../cli/program.mjs';

/** A PEM file in `folder` with certificate and key, and the fingerprint that clients pin. */
export async function makeCertificate(t, folder) {
  const hub = await startHub(t, '--tls-self-signed', '--data', folder);
  const [, fingerprint] = await hub.program.prints(/#sha256=([0-9a-f]{64})/);
  await hub.program.stop();
  return { file: join(folder, 'self-signed.pem'), fingerprint };
}
