// SPDX-License-Identifier: Apache-2.0
// An encrypted hub: the clients that it serves, the clients that trust it, and the messages for those that do not.
import assert from 'node:assert/strict';
import { copyFileSync, readFileSync, renameSync, utimesSync, writeFileSync } from 'node:fs';
import { request as plainRequest } from 'node:http';
import { request as encryptedRequest } from 'node:https';
import { join } from 'node:path';
import { test } from 'node:test';

import { makeCertificate } from '../network/certificate.mjs';
import { Program, assertFailed, assertServes, run, scratchFolder, startHub, startSensor } from './program.mjs';

const certificateOfItsOwn = (folder) => ['--tls-self-signed', '--data', folder];

async function startEncryptedHub(t) {
  const hub = await startHub(t, ...certificateOfItsOwn(scratchFolder(t)));
  const [, url, fingerprint] = await hub.program.prints(/--hub (wss:\S+#sha256=([0-9a-f]{64}))/);
  return { ...hub, url, fingerprint };
}

function get(request, options) {
  return new Promise((resolve, reject) => {
    const sent = request({ host: '127.0.0.1', path: '/healthz', ...options }, (answer) => {
      const fingerprint = answer.socket.getPeerCertificate?.().fingerprint256;
      let body = '';
      answer.on('data', (text) => (body += text));
      answer.on('end', () => resolve({ status: answer.statusCode, body, fingerprint }));
    });
    sent.on('error', reject).end();
  });
}

test('page_is_served_encrypted_with_the_certificate_that_was_printed', async (t) => {
  const hub = await startEncryptedHub(t);
  const { status, fingerprint } = await get(encryptedRequest, { port: hub.port, rejectUnauthorized: false });
  assert.equal(status, 200);
  assert.equal(fingerprint.replaceAll(':', '').toLowerCase(), hub.fingerprint);
});

test('unencrypted_requests_are_answered_with_the_encrypted_scheme', async (t) => {
  const hub = await startEncryptedHub(t);
  const { status, body } = await get(plainRequest, { port: hub.port });
  assert.equal(status, 400);
  assert.match(body, /https:/);
});

test('room_is_seen_through_an_encrypted_hub', async (t) => {
  const hub = await startEncryptedHub(t);
  await startSensor(t, hub);
  await assertServes(t, hub);
});

test('hub_with_an_untrusted_certificate_is_refused', async (t) => {
  const hub = await startEncryptedHub(t);
  const sensor = ['sensor', '--source', 'sim', '--hub'];
  assertFailed(await run(...sensor, `wss://127.0.0.1:${hub.port}`), 1, /untrusted certificate/);
  const wrong = `wss://127.0.0.1:${hub.port}#sha256=${'0'.repeat(64)}`;
  assertFailed(await run(...sensor, wrong), 1, /another fingerprint.*hub's operator/);
  assertFailed(await run(...sensor, `ws://127.0.0.1:${hub.port}`), 1, /https:/);
});

test('hub_for_other_machines_encrypts_by_default', async (t) => {
  const hub = new Program(['hub', '--listen', '0.0.0.0:0', '--data', scratchFolder(t)]);
  t.after(() => hub.stop('SIGKILL'));
  await hub.prints(/https:\/\/0\.0\.0\.0:\d+\/[^]*sha256=/);
});

test('certificate_stays_the_same_from_start_to_start', async (t) => {
  const folder = scratchFolder(t);
  const fingerprints = [];
  for (let start = 0; start < 2; ++start) {
    const hub = await startHub(t, ...certificateOfItsOwn(folder));
    fingerprints.push((await hub.program.prints(/sha256=([0-9a-f]{64})/))[1]);
    await hub.program.stop();
  }
  assert.equal(fingerprints[0], fingerprints[1]);
});

async function fingerprintOf(port) {
  const { fingerprint } = await get(encryptedRequest, { port, rejectUnauthorized: false, agent: false });
  return fingerprint.replaceAll(':', '').toLowerCase();
}

/** Replaces the file without changing its age, so that only an explicit request makes the hub read it again. */
function putUnnoticed(file, content) {
  writeFileSync(`${file}.new`, content);
  utimesSync(`${file}.new`, 1e9, 1e9);
  renameSync(`${file}.new`, file);
}

test('renewed_certificate_is_loaded_on_sighup', async (t) => {
  const before = await makeCertificate(t, scratchFolder(t));
  const after = await makeCertificate(t, scratchFolder(t));
  const file = join(scratchFolder(t), 'hub.pem');
  putUnnoticed(file, readFileSync(before.file));
  const hub = await startHub(t, '--tls-cert', file, '--tls-key', file, '--verbose');
  assert.equal(await fingerprintOf(hub.port), before.fingerprint);

  putUnnoticed(file, readFileSync(after.file));
  hub.program.child.kill('SIGHUP');
  await hub.program.prints(/the certificate was renewed/);
  assert.equal(await fingerprintOf(hub.port), after.fingerprint);

  putUnnoticed(file, 'nothing');
  hub.program.child.kill('SIGHUP');
  await hub.program.prints(/the old certificate is kept: .*no certificate/);
  assert.equal(await fingerprintOf(hub.port), after.fingerprint);
});

test('renewed_certificate_is_noticed_without_a_signal', async (t) => {
  const before = await makeCertificate(t, scratchFolder(t));
  const after = await makeCertificate(t, scratchFolder(t));
  const hub = await startHub(t, '--tls-cert', before.file, '--tls-key', before.file, '--verbose');
  copyFileSync(after.file, before.file);
  await hub.program.prints(/the certificate was renewed/);
  assert.equal(await fingerprintOf(hub.port), after.fingerprint);
});

test('unusable_certificate_files_are_named', async () => {
  const files = (certificate, key) => ['hub', '--listen', '127.0.0.1:0', '--tls-cert', certificate, '--tls-key', key];
  assertFailed(await run(...files('/no/such.pem', '/no/such.key')), 1, /such\.pem/);
  assertFailed(await run(...files('/dev/null', '/dev/null')), 1, /no certificate/);
  assertFailed(await run('hub', '--tls-cert', 'a.pem'), 2, /--tls-key/);
  assertFailed(await run('hub', '--tls-self-signed', '--insecure'), 2, /exclude/);
});
