// SPDX-License-Identifier: Apache-2.0
// Starts nginx in front of a hub, with the server block recommended in docs/reverse-proxy.md.
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { readFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { join } from 'node:path';
import { setTimeout as delay } from 'node:timers/promises';

const env = { ...process.env, PATH: `${process.env.PATH}:/usr/sbin` }; // Debian's folder for it
const startWithin_ms = 10_000;

/** False, or the reason for skipping a test that needs it. */
export const nginxIsMissing = spawnSync('nginx', ['-v'], { env }).error
  ? 'nginx is not installed (scripts/setup test)'
  : false;

export async function freePort() {
  const server = createServer().listen(0, '127.0.0.1');
  await once(server, 'listening');
  const { port } = server.address();
  await new Promise((resolve) => server.close(resolve));
  return port;
}

function documentedServer({ port, hubPort, certificate }) {
  const page = readFileSync(new URL('../../docs/reverse-proxy.md', import.meta.url), 'utf8');
  const [, server] = /```nginx\n([^`]*)```/.exec(page);
  const changes = [
    ['listen 443', `listen 127.0.0.1:${port}`],
    ['/etc/letsencrypt/live/room.example.org/fullchain.pem', certificate],
    ['/etc/letsencrypt/live/room.example.org/privkey.pem', certificate],
    ['127.0.0.1:7600', `127.0.0.1:${hubPort}`],
  ];
  return changes.reduce((text, [from, to]) => {
    if (!text.includes(from)) throw new Error(`docs/reverse-proxy.md does not say ${from}`);
    return text.replace(from, to);
  }, server);
}

/** One process, nothing outside of `folder`; it ends with the test `t`. `certificate` is a PEM file with its key. */
export async function startNginx(t, folder, hubPort, certificate) {
  const port = await freePort();
  const temporary = ['client_body', 'proxy', 'fastcgi', 'uwsgi', 'scgi'].map((kind) => `${kind}_temp_path ${folder}/${kind};`);
  const config = `daemon off; master_process off; pid ${folder}/nginx.pid; error_log stderr;
    events {}
    http { access_log ${folder}/access.log; ${temporary.join(' ')} ${documentedServer({ port, hubPort, certificate })} }`;
  writeFileSync(join(folder, 'nginx.conf'), config);
  const args = ['-p', folder, '-c', join(folder, 'nginx.conf'), '-e', 'stderr'];
  const child = spawn('nginx', args, { env, stdio: ['ignore', 'ignore', 'pipe'] });
  let complaints = '';
  child.stderr.setEncoding('utf8').on('data', (text) => (complaints += text));
  const ended = once(child, 'exit');
  t.after(() => (child.kill('SIGKILL'), ended));
  await listens(port, child, () => complaints);
  return { port, log: () => readFileSync(join(folder, 'access.log'), 'utf8') };
}

async function listens(port, child, complaints) {
  const deadline = Date.now() + startWithin_ms;
  while (Date.now() < deadline && child.exitCode === null) {
    const answered = await fetch(`http://127.0.0.1:${port}/`).then(() => true, () => false);
    if (answered) return;
    await delay(20);
  }
  throw new Error(`nginx does not listen: ${complaints()}`);
}
