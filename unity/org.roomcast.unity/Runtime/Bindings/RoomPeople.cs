// SPDX-License-Identifier: Apache-2.0
// The part of Room about people, marks, voices and sensors' places.
using System;

namespace Roomcast
{
    public sealed partial class Room
    {
        /// The people and marks, once something differs from `known`; at once if that is null. Null: nothing has changed in time.
        public People WaitPeople(People known = null, int timeoutMs = 0)
        {
            PeopleHandle people = known == null
                ? Native.roomcast_wait_people_now(viewer, IntPtr.Zero, timeoutMs)
                : Native.roomcast_wait_people(viewer, known.Handle, timeoutMs);
            return people.IsInvalid ? null : new People(people);
        }

        /// Leaves a mark, waits for the hub's answer, and gives its ID.
        public uint LeaveMark(Mark mark)
        {
            var error = new byte[512];
            using (var pinned = new Pinned())
            {
                if (mark.Points != null && mark.Points.Length % 3 != 0) throw new RoomcastException("each point has 3 numbers");
                var native = new Native.Mark
                {
                    size = Native.SizeOf<Native.Mark>(),
                    kind = (int)mark.Kind,
                    points = pinned.At(mark.Points),
                    point_count = (UIntPtr)(uint)(mark.Points == null ? 0 : mark.Points.Length / 3),
                    text = pinned.At(Native.BytesOf(mark.Text)),
                };
                uint id;
                if (Native.roomcast_leave_mark(viewer, ref native, out id, error, Size(error)) == 0) throw Failure(error);
                return id;
            }
        }

        public void RemoveMark(uint id)
        {
            var error = new byte[512];
            if (Native.roomcast_remove_mark(viewer, id, error, Size(error)) == 0) throw Failure(error);
        }

        /// Why this viewer may not speak; null if it may.
        public string WhyNotSpeak { get { return Ask(Native.roomcast_may_speak); } }

        /// Fills `voice` with the next packet of somebody's voice, of a room joined with Hears. False: none came in time, or
        /// the connection has ended for good.
        public bool NextVoice(Voice voice, int timeoutMs)
        {
            using (var pinned = new Pinned())
            {
                voice.Native.size = Native.SizeOf<Native.Voice>();
                voice.Native.samples = pinned.At(voice.Samples);
                voice.Native.opus = pinned.At(voice.Buffer);
                if (voice.Native.world_from_head == null) voice.Native.world_from_head = new double[16];
                return Native.roomcast_next_voice(viewer, timeoutMs, ref voice.Native) != 0;
            }
        }

        /// Says what was recorded since the last call, at 48 kHz: up to a second, and not faster than real time.
        public void Speak(float[] samples)
        {
            var error = new byte[512];
            if (Native.roomcast_speak(viewer, samples, (UIntPtr)(uint)samples.Length, error, Size(error)) == 0) throw Failure(error);
        }

        /// Tells the others that a pause follows.
        public void PauseSpeaking()
        {
            Native.roomcast_pause_speaking(viewer);
        }

        /// Proposes a pose for a sensor, with an admin's token; waits up to 20 s for what the room's aligner makes of it.
        public Placement PlaceSensor(string sensor, double[] worldFromDepth)
        {
            var error = new byte[512];
            Native.Placement placed = NewPlacement();
            if (Native.roomcast_place_sensor(viewer, Native.BytesOf(sensor), Matrix(worldFromDepth), ref placed, error, Size(error)) == 0)
                throw Failure(error);
            return Placed(placed);
        }

        /// Likewise, from where it stands: tilts and turns it about its own position (radians), then shifts it (metres).
        public Placement NudgeSensor(string sensor, double x, double y, double z, double turn = 0, double tilt = 0)
        {
            var error = new byte[512];
            Native.Placement placed = NewPlacement();
            var nudge = new Native.Nudge { size = Native.SizeOf<Native.Nudge>(), shift_m = new[] { x, y, z }, turn_rad = turn, tilt_rad = tilt };
            if (Native.roomcast_nudge_sensor(viewer, Native.BytesOf(sensor), ref nudge, ref placed, error, Size(error)) == 0)
                throw Failure(error);
            return Placed(placed);
        }

        private static Native.Placement NewPlacement()
        {
            return new Native.Placement { size = Native.SizeOf<Native.Placement>(), world_from_depth = new double[16] };
        }

        private static Placement Placed(Native.Placement native)
        {
            return new Placement { WorldFromDepth = native.world_from_depth, ExpectedErrorMm = native.expected_error_mm };
        }

        private static RoomcastException Failure(byte[] error)
        {
            return new RoomcastException(Native.TextOf(error));
        }
    }
}
