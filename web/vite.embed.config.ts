// SPDX-License-Identifier: Apache-2.0
// The npm package roomcast-view (embed/) in ../build/roomcast-view, ready for `npm pack`. The hub serves the custom
// element's script, too, so that a site needs no package; vite.config.ts has made the folder of its page before.
import { copyFileSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { defineConfig, type Plugin } from 'vite';
import { wasmModules } from './vite.config';

const from = (path: string) => fileURLToPath(new URL(path, import.meta.url));
const packaged = ['package.json', 'README.md', 'roomcast-view.d.ts', 'room-layer.d.ts'];

function completePackage(): Plugin {
  return {
    name: 'roomcast-complete-package',
    closeBundle() {
      for (const name of packaged) copyFileSync(from(`embed/${name}`), from(`../build/roomcast-view/${name}`));
      copyFileSync(from('../LICENSE'), from('../build/roomcast-view/LICENSE'));
      const script = readFileSync(from('../build/roomcast-view/roomcast-view.js'));
      writeFileSync(from('../build/web/roomcast-view.js'), script);
      writeFileSync(from('../build/web/roomcast-view.js.gz'), gzipSync(script, { level: 9 }));
    },
  };
}

export default defineConfig({
  base: './',
  plugins: [completePackage()],
  resolve: { alias: wasmModules },
  worker: { format: 'es' },
  build: {
    outDir: '../build/roomcast-view',
    emptyOutDir: true,
    target: 'es2022',
    modulePreload: { polyfill: false },
    rollupOptions: {
      input: { 'roomcast-view': from('embed/view_element.ts'), 'room-layer': from('embed/room_layer.ts') },
      external: ['three'],
      preserveEntrySignatures: 'strict',
      output: { entryFileNames: '[name].js' },
    },
  },
});
