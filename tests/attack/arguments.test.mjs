// SPDX-License-Identifier: Apache-2.0
// Attacks the command line: every command and option that --help names, with values that nobody means. Each program ends
// with a documented code and a sentence, and a hub that they were let loose on still serves.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { run, scratchFolder } from '../cli/program.mjs';
import { writeSmallRig } from '../network/small_rig.mjs';
import { confinedTo, faultsOf, runAttacked } from './attacked_program.mjs';
import { attackInTurn, timeout } from './attacker.mjs';
import { BystandingHub } from './bystander.mjs';

const patience_ms = 1_500;
const atATime = 3;
const mostHostileOptions = 4;

/** They measure for minutes what is no input; latency also changes the machine's network. */
const leftOut = ['bench latency', 'bench fanout', 'bench abuse'];

const hostileNumbers = [
  ...['nan', '-nan', 'inf', '-inf', 'infinity', '1e400', '-1e400', '1e-400', '5e-324', '0', '-0', '-1', '1e9', '0x10', '1_000', '١'],
  ...['2147483647', '2147483648', '4294967296', '-2147483649', '9223372036854775808', '18446744073709551616', '1'.repeat(400)],
  ...['1.', '.5', '+1', ' 1', '1 ', '1,2,3', '1;2', '1e'],
];
const hostileTexts = [
  ...['', ' ', '-', '--', '.', '..', '/', '~', '*', '%s%n%x', '$(id)', '`id`', "'", '"', '\\', '#', '?', '&', '=', ',', ';', ':', '::', '[', '{}'],
  ...['\u001b[31mred', '\u001b]0;title\u0007', '\u009b2J', 'a\nb', 'a\rb', 'a\tb', '\u202egnp.exe', '\u2066x', '\u200b', '\u0085', '\u007f'],
  ...['ä', '部屋', '🙂', '\ud800', 'e\u0301', 'İ', 'ﬀ', 'a'.repeat(5_000), '💥'.repeat(2_000), '../'.repeat(500), 'a/'.repeat(3_000)],
];
const hostilePaths = [
  ...['/dev/zero', '/dev/null', '/dev/full', '/dev/random', '/dev/stdin', '/dev/stdout', '/dev/tty', '/', '/etc', '/etc/passwd', '/proc/self/mem'],
  ...['/proc/self/exe', '/proc/nope/out', '/nowhere/at/all', 'folder', 'folder/', 'file', 'file/below', 'link_to_itself', 'pipe', 'unreadable', 'empty'],
];
const hostileAddresses = [
  ...['ws://', 'wss://', 'ws://:1', 'ws://127.0.0.1:0', 'ws://127.0.0.1:65536', 'ws://127.0.0.1:-1', 'ws://[::1', 'ws://[::1]:1', 'http://127.0.0.1:1'],
  ...['ws://127.0.0.1:1,', ',,,', 'ws://nobody.invalid:1', 'ws://a b:1', 'ws://127.0.0.1:1/../..', 'ws://u:p@127.0.0.1:1', `ws://${'a'.repeat(300)}:1`],
  ...['127.0.0.1:99999', '0.0.0.0:0', '[::]:0', '256.1.1.1:1', 'localhost', 'nats://', 'nats://x:1,nats://', 'wss://127.0.0.1:1#sha256=00', 'ws://ä.example:1'],
  ...['sim', 'sim:#', 'sim:#-1', 'sim:office,fov=nan', 'sim:office,speed=1e400', 'sim#99999999999', 'rig:', 'rig:#', 'tum:/', 'mcap:/dev/zero#s0', 'openni2:/dev/null', 'freenect:x'],
];
const hostile = [hostileNumbers, hostileTexts, hostilePaths, hostileAddresses];

/** The option lines of a command's --help. */
function parseHelp(help) {
  const options = [...help.matchAll(/^ {2}(?:-\w,)?(--[a-z-]+)(?:\{\w+\})?(?:,--[a-z-]+)?( [A-Z]{3,}\S*)?( \S+)*?(?: {2,}.*)?$/gm)].map(([line, name, type]) => ({
    name,
    takesValue: type !== undefined || /^ {2}--[a-z-]+ [a-z-]+\|/.test(line),
    isNumber: / (INT|UINT|FLOAT)/.test(line),
    isRequired: / REQUIRED/.test(line),
    arity: Number(/ x (\d)/.exec(line)?.[1] ?? 1),
  }));
  const [, listed = ''] = /^Positionals:\n([^]*?)\n\n/m.exec(help) ?? [];
  const positionals = [...listed.matchAll(/^ {2}([a-z]+) /gm)].map(([, name]) => name);
  return { options: options.filter(({ name }) => name !== '--help' && name !== '--version'), positionals };
}

/** Every command with its options, [{words, options, positionals}], as its own --help tells. */
async function commandsOf(words = []) {
  const { code, stdout } = await run(...words, '--help');
  assert.equal(code, 0);
  const [, listed] = /^Subcommands:\n([^]*?)\n\n/m.exec(stdout) ?? [];
  if (!listed) return [{ words, ...parseHelp(stdout) }];
  const names = [...listed.matchAll(/^ {2}([a-z-]+) /gm)].map(([, name]) => name);
  return (await Promise.all(names.map((name) => commandsOf([...words, name])))).flat();
}

/** A folder with things that hostile paths name, and a rig. */
function makeTraps(folder) {
  mkdirSync(join(folder, 'folder/below'), { recursive: true });
  writeFileSync(join(folder, 'file'), 'text');
  writeFileSync(join(folder, 'empty'), '');
  writeFileSync(join(folder, 'unreadable'), 'text', { mode: 0 });
  spawnSync('mkfifo', [join(folder, 'pipe')]);
  spawnSync('ln', ['-s', 'link_to_itself', join(folder, 'link_to_itself')]);
  return writeSmallRig(folder);
}

/** A value that the option could have meant, so that others are read, too. */
function harmless(name, { rig, url, out }) {
  const values = {
    ...{ '--hub': url, '--source': `rig:${rig}#s0`, recording: rig, input: `rig:${rig}#s0`, file: `${out}.mcap`, out },
    ...{ '--out': out, '--png': `${out}.png`, '--listen': '127.0.0.1:0', '--port': '0', '--data': out, '--room': 'room', '--role': 'viewer' },
    ...{ '--seconds': '0.2', '--from': '0', '--to': '1', '--print': `${out}.pdf`, sensor: 's0', '--floor-plan': `${out}.svg`, '--size': '64,48' },
  };
  return values[name] ?? '1';
}

/** Most numbers are harmless, because a wrong one ends a program before it has read the rest. */
function valueFor(random, { name, isNumber }, context) {
  if (random.isTrue(isNumber ? 0.7 : 0.2)) return harmless(name, context);
  if (isNumber && random.isTrue(0.8)) return random.pick(hostileNumbers);
  return random.pick(random.pick(hostile));
}

function hostileArguments(random, commands, context) {
  const { words, options, positionals } = random.pick(commands);
  const args = [...words];
  const required = options.filter(({ isRequired }) => isRequired);
  for (const option of required) {
    if (random.isTrue(0.05)) continue;
    args.push(option.name, random.isTrue(0.75) ? harmless(option.name, context) : valueFor(random, option, context));
  }
  for (let n = random.below(mostHostileOptions + 1); n > 0 && options.length > 0; --n) {
    const option = random.pick(options);
    args.push(option.name);
    if (option.takesValue) args.push(Array.from({ length: option.arity }, () => valueFor(random, option, context)).join(','));
    if (random.isTrue(0.02)) args.push(random.pick(random.pick(hostile)));
  }
  for (const name of positionals) {
    if (!random.isTrue(0.05)) args.push(random.isTrue(0.7) ? harmless(name, context) : valueFor(random, { name }, context));
  }
  return args;
}

test('no_arguments_make_a_program_fall_over', timeout, async (t) => {
  const folder = scratchFolder(t);
  const through = confinedTo(folder);
  if (!through) return t.skip('root without a mount namespace: hostile paths would change this machine');
  const rig = makeTraps(folder);
  const commands = (await commandsOf()).filter(({ words }) => !leftOut.includes(words.join(' ')));
  const optionCount = commands.reduce((sum, { options }) => sum + options.length, 0);
  t.diagnostic(`${commands.length} commands, ${optionCount} options`);
  assert.ok(commands.length >= 20 && optionCount >= 180, '--help was understood');
  const hub = await BystandingHub.start(t);
  const env = { PATH: process.env.PATH, HOME: folder, XDG_STATE_HOME: folder, TMPDIR: folder, LANG: 'C.UTF-8' };
  await attackInTurn(
    t,
    async (random) => {
      const cwd = mkdtempSync(join(folder, 'case_'));
      const args = hostileArguments(random, commands, { rig, url: hub.url, out: join(cwd, 'out') });
      return faultsOf(await runAttacked(args, { through, cwd: folder, env, patience_ms }));
    },
    { atATime },
  );
  await hub.assertServes(t, rig);
});
