// SPDX-License-Identifier: Apache-2.0
// The name of the file of a picture of the view: the room and the local time.

const longestRoom = 40;

function twoDigits(value: number): string {
  return String(value).padStart(2, '0');
}

/** Characters that a file system or a shell may take otherwise become dashes. */
export function pictureName(room: string, date: Date): string {
  const plain = room.replace(/[^\p{L}\p{N}_]+/gu, '-').replace(/^-|-$/g, '');
  const place = [...plain].slice(0, longestRoom).join('') || 'room';
  const day = [date.getFullYear(), twoDigits(date.getMonth() + 1), twoDigits(date.getDate())].join('-');
  const time = [date.getHours(), date.getMinutes(), date.getSeconds()].map(twoDigits).join('-');
  return `roomcast-${place}-${day}-${time}.png`;
}

/** A picture with its name, or null where there is none. */
export async function namedPicture(taken: Promise<Blob | null>, room: string): Promise<{ png: Blob; name: string } | null> {
  const png = await taken;
  return png && { png, name: pictureName(room, new Date()) };
}
