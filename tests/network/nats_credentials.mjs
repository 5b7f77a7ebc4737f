// SPDX-License-Identifier: Apache-2.0
// Stands in for a NATS operator: makes an account, and a user's credentials (.creds) for it. Source: NATS'
// decentralised JWT authentication; keys are Ed25519, written in base32 with a prefix for their kind and a CRC-16.
import { createHash, generateKeyPairSync, sign } from 'node:crypto';

const kinds = { operator: 14 << 3, account: 0, user: 20 << 3, seed: 18 << 3 };
const alphabet = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ234567';

function base32(bytes) {
  let bits = '';
  for (const byte of bytes) bits += byte.toString(2).padStart(8, '0');
  return (bits.match(/.{1,5}/g) ?? []).map((five) => alphabet[parseInt(five.padEnd(5, '0'), 2)]).join('');
}

/** CRC-16/XMODEM. */
function crc16(bytes) {
  let crc = 0;
  for (const byte of bytes) {
    crc ^= byte << 8;
    for (let i = 0; i < 8; ++i) crc = crc & 0x8000 ? ((crc << 1) ^ 0x1021) & 0xffff : (crc << 1) & 0xffff;
  }
  return crc;
}

function encoded(prefix, key) {
  const bytes = Buffer.concat([Buffer.from(prefix), key]);
  const check = Buffer.alloc(2);
  check.writeUInt16LE(crc16(bytes));
  return base32(Buffer.concat([bytes, check]));
}

function newKey(kind) {
  const { publicKey, privateKey } = generateKeyPairSync('ed25519');
  const raw = (key, type) => key.export({ type, format: 'der' }).subarray(-32);
  const prefix = kinds[kind];
  return {
    id: encoded([prefix], raw(publicKey, 'spki')),
    seed: encoded([kinds.seed | (prefix >> 5), (prefix & 31) << 3], raw(privateKey, 'pkcs8')),
    sign: (text) => sign(null, Buffer.from(text), privateKey),
  };
}

function jwt(issuer, subject, name, nats) {
  const base64 = (bytes) => Buffer.from(bytes).toString('base64url');
  const claims = { iat: Math.floor(Date.now() / 1000), iss: issuer.id, sub: subject.id, name, nats: { version: 2, ...nats } };
  claims.jti = base32(createHash('sha512-256').update(JSON.stringify(claims)).digest());
  const text = `${base64(JSON.stringify({ typ: 'JWT', alg: 'ed25519-nkey' }))}.${base64(JSON.stringify(claims))}`;
  return `${text}.${base64(issuer.sign(text))}`;
}

/** The account's part of a server's configuration, and the text of a .creds file for it. */
export function newAccount() {
  const [operator, account, user] = ['operator', 'account', 'user'].map(newKey);
  const limits = { subs: -1, data: -1, payload: -1, imports: -1, exports: -1, wildcards: true, conn: -1, leaf: -1 };
  const accountJwt = jwt(operator, account, 'rooms', { type: 'account', limits });
  const userJwt = jwt(account, user, 'hub', { type: 'user', subs: -1, data: -1, payload: -1, pub: { allow: ['roomcast.>'] }, sub: { allow: ['roomcast.>'] } });
  return {
    config: `operator: "${jwt(operator, operator, 'test', { type: 'operator' })}"\nresolver: MEMORY\nresolver_preload: { ${account.id}: "${accountJwt}" }\n`,
    credentials:
      `-----BEGIN NATS USER JWT-----\n${userJwt}\n------END NATS USER JWT------\n\n` +
      `-----BEGIN USER NKEY SEED-----\n${user.seed}\n------END USER NKEY SEED------\n`,
  };
}
