// SPDX-License-Identifier: Apache-2.0
// What happened in the room, as the hub tells its admins: kept in order, said in words, and written as CSV. Pure.
import { eventTexts as texts } from '../event_texts';

export interface HubEvent {
  id: number; // stays the same while equal refusals are counted
  number: number; // grows with each addition
  at: number; // seconds since 1970
  kind: string;
  role: string;
  name: string;
  peer: string;
  token_id: string;
  by: string;
  sentence: string;
  times: number;
}

export const eventFilters = ['all', 'people', 'sensors', 'refused', 'admins'] as const;
export type EventFilter = (typeof eventFilters)[number];

const mostKept = 1000;

/** The events known so far. */
export class EventLog {
  private readonly byId = new Map<number, HubEvent>();
  newest = 0;

  /** `newest` is the hub's: a lower one than before means that the hub was started anew. */
  take(events: readonly HubEvent[], newest: number): void {
    if (newest < this.newest) this.clear();
    for (const event of events) {
      this.byId.delete(event.id);
      this.byId.set(event.id, event);
      this.newest = Math.max(this.newest, event.number);
    }
    for (const id of this.byId.keys()) {
      if (this.byId.size <= mostKept) break;
      this.byId.delete(id);
    }
  }

  clear(): void {
    this.byId.clear();
    this.newest = 0;
  }

  /** Newest first. */
  list(filter: EventFilter): HubEvent[] {
    return [...this.byId.values()].filter((event) => passes(event, filter)).reverse();
  }
}

function passes({ kind, role, by }: HubEvent, filter: EventFilter): boolean {
  if (filter === 'people') return role === 'viewer' || role === 'hub';
  if (filter === 'sensors') return role === 'sensor' || /sensor/.test(kind);
  if (filter === 'refused') return /refused$/.test(kind);
  return filter === 'all' || by !== '';
}

/** "Ada was refused: this token has expired (3 times)" */
export function eventText({ kind, role, name, by, sentence, times }: HubEvent): string {
  const who = name || texts.roles[role as keyof typeof texts.roles] || texts.somebody;
  const said = texts.kinds[kind as keyof typeof texts.kinds]?.(who, by) ?? `${kind} ${who}`;
  const reason = sentence === kind ? '' : sentence; // a client that says only that it has left
  return [said, reason && `: ${reason}`, times > 1 && ` (${texts.times(times)})`].filter(Boolean).join('');
}

const columns = ['at', 'kind', 'role', 'name', 'by', 'sentence', 'times', 'peer', 'token_id'] as const;

/** RFC 4180. A field that a spreadsheet would take for a formula gets an apostrophe in front. */
export function eventsCsv(events: readonly HubEvent[]): string {
  const rows = events.map((event) =>
    columns.map((column) => (column === 'at' ? new Date(1000 * event.at).toISOString() : csvField(String(event[column])))),
  );
  return [columns, ...rows].map((row) => `${row.join(',')}\r\n`).join('');
}

function csvField(text: string): string {
  const safe = /^[=+\-@\t\r]/.test(text) ? `'${text}` : text;
  return /[",\r\n]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}
