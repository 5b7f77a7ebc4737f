// SPDX-License-Identifier: Apache-2.0
// Pages that import the page's own TypeScript, file by file, without a hub, for tests of code that only a browser can
// run.
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const { transformSync } = createRequire(new URL('../../web/node_modules/vite/package.json', import.meta.url))(
  'esbuild',
);

const sources = new URL('../../web/src', import.meta.url);
const packages = new URL('../../web/node_modules/', import.meta.url);

/** Packages that are imported by bare name. */
const imports = {
  three: '/package/three/build/three.module.js',
  '@bufbuild/protobuf/codegenv2': '/package/@bufbuild/protobuf/dist/esm/codegenv2/index.js',
};
const html = `<!doctype html><title>sources</title><canvas></canvas>
<script type="importmap">${JSON.stringify({ imports })}</script>`;

function answer(path) {
  if (path === '/') return { contentType: 'text/html', body: html };
  const [, ofPackage] = path.split('/package/');
  if (ofPackage) return { contentType: 'text/javascript', body: readFileSync(new URL(ofPackage, packages)) };
  const file = new URL(`${sources.pathname}${path}${path.endsWith('.ts') ? '' : '.ts'}`, sources);
  if (!existsSync(file)) return { status: 404 };
  return { contentType: 'text/javascript', body: transformSync(readFileSync(file, 'utf8'), { loader: 'ts' }).code };
}

/** A page with an origin of its own in which `import('/view/stage')` works. */
export async function openSourcePage(context, origin) {
  const page = await context.newPage();
  page.complaints = [];
  page.on('pageerror', (error) => page.complaints.push(error.message));
  page.on('console', (message) => message.type() === 'error' && page.complaints.push(message.text()));
  await page.route(`${origin}/**`, (route) => route.fulfill(answer(new URL(route.request().url()).pathname)));
  await page.goto(origin);
  return page;
}
