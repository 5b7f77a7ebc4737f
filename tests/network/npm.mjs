// SPDX-License-Identifier: Apache-2.0
// The npm packages of these tests; they are installed with those of the page, in web/node_modules.
import { createRequire } from 'node:module';

const require = createRequire(new URL('../../web/package.json', import.meta.url));

export const { WebSocket, WebSocketServer } = require('ws');
export const { BinaryReader, BinaryWriter, WireType } = require('@bufbuild/protobuf/wire');
