// SPDX-License-Identifier: Apache-2.0
// A web site that is not the hub's: serves the pages that it is given, and files of folders, on a port of its own.
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';

const types = { '.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm' };

/** `pages`: path -> text. `folders`: beginning of a path -> folder. */
export async function startSite(pages, folders = {}) {
  const find = (path) => {
    if (pages[path] !== undefined) return pages[path];
    const [from, folder] = Object.entries(folders).find(([beginning]) => path.startsWith(beginning)) ?? [];
    return folder && !path.includes('..') ? readFileSync(join(folder, path.slice(from.length))) : undefined;
  };
  const server = createServer(({ url }, answer) => {
    const { pathname } = new URL(url, 'http://localhost');
    let body;
    try {
      body = find(pathname);
    } catch {
      body = undefined;
    }
    answer.writeHead(body === undefined ? 404 : 200, { 'content-type': types[extname(pathname)] ?? 'text/html' });
    answer.end(body);
  });
  await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
  const address = `http://127.0.0.1:${server.address().port}`;
  const end = () => new Promise((ended) => server.close(ended).closeAllConnections?.());
  return { address, pages, end };
}
