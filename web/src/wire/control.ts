// SPDX-License-Identifier: Apache-2.0
// Control messages <-> bytes: docs/spec/wire.md §1 and §3. `decodeControl` checks its result: names, sizes, numbers and
// matrices can be used as they are. Throws WireError.
import { create, fromBinary, toBinary, type MessageInitShape } from '@bufbuild/protobuf';
import { ControlSchema, type Control } from '../gen/control_pb';
import { checkControl } from './control_check';
import { magic, MessageType, messageType, preambleBytes, version } from './frame_header';
import { maxControlFromClientBytes, maxControlFromHubBytes } from './limits';
import { malformed, tooLarge } from './wire_error';

export type ControlMessage = NonNullable<MessageInitShape<typeof ControlSchema>['message']>;

export function encodeControl(message: ControlMessage): Uint8Array<ArrayBuffer> {
  const body = toBinary(ControlSchema, create(ControlSchema, { message }));
  const bytes = new Uint8Array(preambleBytes + body.length);
  if (bytes.length > maxControlFromClientBytes) throw tooLarge('a control message to the hub is at most 16 KiB');
  const view = new DataView(bytes.buffer);
  view.setUint16(0, magic, true);
  view.setUint8(2, version);
  view.setUint8(3, MessageType.Control);
  bytes.set(body, preambleBytes);
  return bytes;
}

function parseBody(body: Uint8Array): Control {
  try {
    return fromBinary(ControlSchema, body);
  } catch (error) {
    throw malformed(`a control message is not valid Protobuf (${(error as Error).message})`);
  }
}

/** `message` comes from the hub. A message kind of a later version decodes to a Control without content. */
export function decodeControl(message: Uint8Array): Control {
  const view = new DataView(message.buffer, message.byteOffset, message.byteLength);
  if (messageType(view) !== MessageType.Control) throw malformed('this message is not a control message');
  if (message.length > maxControlFromHubBytes) throw tooLarge('a control message from the hub is at most 256 KiB');
  const control = parseBody(message.subarray(preambleBytes));
  checkControl(control);
  return control;
}
