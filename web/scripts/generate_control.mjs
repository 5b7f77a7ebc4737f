// SPDX-License-Identifier: Apache-2.0
// Writes src/gen/control_pb.ts from roomcast/wire/control.proto with the system's protoc. Does nothing when the file is
// newer than the proto.
import { spawnSync } from 'node:child_process';
import { mkdirSync, statSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const web = dirname(dirname(fileURLToPath(import.meta.url)));
const protoFolder = join(web, '../roomcast/wire');
const output = join(web, 'src/gen');

function modified(path) {
  return statSync(path, { throwIfNoEntry: false })?.mtimeMs ?? 0;
}

function fail(sentence) {
  console.error(`generate_control: ${sentence}`);
  process.exit(1);
}

if (modified(join(output, 'control_pb.ts')) < modified(join(protoFolder, 'control.proto'))) {
  mkdirSync(output, { recursive: true });
  const plugin = join(web, 'node_modules/.bin/protoc-gen-es');
  const run = spawnSync(
    'protoc',
    [
      `--plugin=protoc-gen-es=${plugin}`,
      `--proto_path=${protoFolder}`,
      `--es_out=${output}`,
      '--es_opt=target=ts',
      'control.proto',
    ],
    { stdio: ['ignore', 'inherit', 'inherit'] },
  );
  if (run.error) fail('protoc is not there; scripts/setup installs it (Debian: protobuf-compiler).');
  if (run.status !== 0) fail('protoc refused roomcast/wire/control.proto; its reason is above. (Is `npm ci` done?)');
}
