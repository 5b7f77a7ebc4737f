// SPDX-License-Identifier: Apache-2.0
// The page in a headset: entering and leaving, and whose pose counts meanwhile.
import type { Marking } from './marking';
import type { Panel } from './panel/panel';
import type { PosePublisher } from './pose_publisher';
import type { RoomState } from './room_state';
import { keptIn } from './storage';
import { startDistance_m, type Standpoint } from './standpoint';
import { headsetPace, screenPace } from './view/quality_ladder';
import type { Stage } from './view/stage';
import { viewFromBody } from './view/view_state';
import type { Sound } from './sound';
import type { SheetHolder } from './xr/board_sheet';
import { keepComfort, keptComfort } from './xr/comfort';
import { Headset } from './xr/headset';
import type { HeadsetMode } from './xr/offer';

export interface HeadsetPage {
  readonly stage: Stage;
  readonly panel: Panel;
  readonly state: RoomState;
  readonly posePublisher: PosePublisher;
  readonly standpoint: Standpoint;
  readonly headset: Headset;
  readonly sheets: SheetHolder;
  readonly marking: Marking;
  readonly sound: Sound;
  readonly hubAddress: string;
}

const { store } = keptIn(() => localStorage);
const comfort = keptComfort(store);

export function headsetOf(stage: Stage, page: () => HeadsetPage): Headset {
  const headset = new Headset(stage.renderer.xr, {
    began: (mode) => {
      stage.ladder.setPace(headsetPace);
      stage.room.setPassthrough(mode === 'immersive-ar');
      page().panel.headset.setOn(true);
      void showPanel(page());
    },
    moved: (body) => {
      page().state.body = body;
      page().posePublisher.moved(body);
    },
    ended: () => headsetEnded(page()),
  }, comfort);
  stage.room.scene.add(headset.root);
  return headset;
}

export function enterHeadset({ standpoint, stage, headset }: HeadsetPage, mode: HeadsetMode): Promise<void> {
  standpoint.follow.end();
  stage.renderer.xr.enabled = true;
  const { position, yaw } = standpoint.current;
  return headset.enter(mode, position, yaw);
}

/** Loaded when a headset is put on; without it one is still in the room, and leaves it as other pages. */
async function showPanel(page: HeadsetPage): Promise<void> {
  await loadPanel(page);
  const { headset, state } = page;
  const own = headset.ownRoom;
  if (own) headset.placer?.entered({ ...own, room: state.welcome?.room ?? '' });
}

async function loadPanel({ headset, stage, state, sound, sheets, marking, standpoint, hubAddress }: HeadsetPage): Promise<void> {
  if (headset.panel) return;
  const { HandLaser, HeadsetPanel, RoomPlacer } = await import('./xr/headset_panel');
  const placer = new RoomPlacer(store);
  const laser = new HandLaser({
    stage,
    color: () => state.ownColor,
    mayLeave: () => marking.mayMark,
    leave: (mark) => void marking.leave(mark),
  });
  const panel = new HeadsetPanel({
    ...{ state, sound, sheets, hubAddress, comfort, placer, laser },
    seesOwnRoom: () => headset.ownRoom !== undefined,
    comfortChanged: () => keepComfort(store, comfort),
    goToStart: () => headset.goTo(standpoint.startView.position),
    leave: () => void headset.leave(),
  });
  headset.panel = panel;
  headset.placer = placer;
  headset.laser = laser;
  headset.root.add(panel.root, placer.root, laser.root);
}

/** Sets the screen's view to the wearer's last position. */
function headsetEnded({ stage, state, panel, standpoint, headset }: HeadsetPage): void {
  stage.renderer.xr.enabled = false;
  stage.ladder.setPace(screenPace);
  stage.room.setPassthrough(false);
  panel.headset.setOn(false);
  headset.panel?.close();
  const { body } = state;
  state.body = undefined; // before the screen's own is sent
  if (body) standpoint.set(viewFromBody(body.head, startDistance_m));
}
