// SPDX-License-Identifier: Apache-2.0
// Makes a certificate for a server of these tests: a hub's self-signed one.
import { join } from 'node:path';

import { startHub } from '../cli/program.mjs';

/** Writes a PEM file with certificate and key to `folder`, and returns it with the fingerprint that clients pin. */
export async function makeCertificate(t, folder) {
  const hub = await startHub(t, '--tls-self-signed', '--data', folder);
  const [, fingerprint] = await hub.program.prints(/#sha256=([0-9a-f]{64})/);
  await hub.program.stop();
  return { file: join(folder, 'self-signed.pem'), fingerprint };
}
