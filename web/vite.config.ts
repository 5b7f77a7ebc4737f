// SPDX-License-Identifier: Apache-2.0
// The page: one index.html, scripts with hashed names, and the modules that CMake's preset `wasm` has built.
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { type Plugin } from 'vite';
import { defineConfig } from 'vitest/config';

const built = (name: string) => fileURLToPath(new URL(`../build/wasm/${name}.wasm`, import.meta.url));
const moduleNames = ['roomcast_codec', 'roomcast_codec_plain', 'roomcast_flow', 'roomcast_flow_plain'];
export const wasmModules = moduleNames.map((name) => ({ find: new RegExp(`^${name}\\.wasm`), replacement: built(name) }));

/** Fails with a sentence, where the bundler would only say that an import could not be resolved. */
function requireModules(): Plugin {
  return {
    name: 'roomcast-require-modules',
    apply: 'build',
    buildStart() {
      const absent = moduleNames.find((name) => !existsSync(built(name)));
      if (!absent) return;
      this.error(
        `build/wasm/${absent}.wasm is not built; run \`cmake --preset wasm && cmake --build --preset wasm\` first.`,
      );
    },
  };
}

/** FILE.gz beside every FILE: the hub gives it to browsers, which all take it. */
function compress(): Plugin {
  let folder = '';
  return {
    name: 'roomcast-compress',
    apply: 'build',
    configResolved: ({ root, build }) => void (folder = resolve(root, build.outDir)),
    closeBundle() {
      for (const entry of readdirSync(folder, { recursive: true, withFileTypes: true })) {
        const file = join(entry.parentPath ?? entry.path, entry.name);
        if (entry.isFile()) writeFileSync(`${file}.gz`, gzipSync(readFileSync(file), { level: 9 }));
      }
    },
  };
}

export default defineConfig({
  base: './',
  plugins: [requireModules(), compress()],
  resolve: { alias: wasmModules },
  worker: { format: 'es' },
  build: {
    outDir: '../build/web',
    emptyOutDir: true,
    target: 'es2022',
    chunkSizeWarningLimit: 1500,
  },
  test: {
    include: ['src/**/*.test.ts', 'embed/**/*.test.ts'],
    environment: 'node',
    reporters: process.stdout.isTTY ? ['default'] : ['./test/tap_with_totals.ts'],
  },
});
