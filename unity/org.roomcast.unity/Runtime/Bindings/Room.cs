// SPDX-License-Identifier: Apache-2.0
// A room as a viewer sees it. Units: metres and nanoseconds; depth in millimetres, 0 where there is no reading. World frame:
// right-handed, y up, floor at y = 0; sensor frames: x right, y down, z forward. Matrices are 16 numbers, row by row;
// a_from_b maps points of frame b to frame a. All classes may be used by several threads, except that Dispose() is the last
// call. Failures are RoomcastExceptions with a sentence.
using System;
using System.Runtime.InteropServices;

namespace Roomcast
{
    /// A sentence for people.
    public sealed class RoomcastException : Exception
    {
        public RoomcastException(string message) : base(message) { }
    }

    /// The room to join. All but Hub may be null.
    public sealed class RoomOptions
    {
        public string Hub;   // "ws://host:port" or "wss://host:port#sha256=..."
        public string Room;  // null: the hub's room, if it has only one
        public string Name;  // shown to the others; of a sensor its identity
        public string Token; // if the room requires one; or a one-time code
        public bool Hears;   // gets people's voices
        public string AuthorKey; // a secret of the program, by which marks that it left are its own later, too
    }

    /// A coloured point in the world frame.
    [StructLayout(LayoutKind.Sequential)]
    public struct Point
    {
        public float X, Y, Z;
        public byte R, G, B, A; // A: 255
    }

    /// A connection to a room. It reconnects by itself.
    public sealed partial class Room : IDisposable
    {
        private readonly ViewerHandle viewer;

        private Room(ViewerHandle viewer)
        {
            this.viewer = viewer;
        }

        /// The version of the library, such as "1.6.0".
        public static string LibraryVersion { get { return Native.TextAt(Native.roomcast_version()); } }

        /// Joins a room and waits for the hub's answer.
        public static Room Connect(RoomOptions options)
        {
            var error = new byte[512];
            using (var pinned = new Pinned())
            {
                Native.Options native = pinned.Options(options);
                ViewerHandle viewer = Native.roomcast_connect(ref native, error, Size(error));
                if (viewer.IsInvalid) throw new RoomcastException(Native.TextOf(error));
                return new Room(viewer);
            }
        }

        public static Room Connect(string hub, string token = null)
        {
            return Connect(new RoomOptions { Hub = hub, Token = token });
        }

        /// Why there is no connection; null while there is one.
        public string Problem { get { return Ask(Native.roomcast_is_connected); } }
        /// Why pictures of the room may not be kept, or written to files for other programs; null if they may.
        public string WhyNotRecord { get { return Ask(Native.roomcast_may_record); } }
        public string WhyNotExport { get { return Ask(Native.roomcast_may_export); } }

        /// The newest pictures, once there are newer ones than those of the last call; null if none arrive in time.
        public Frames WaitFrames(int timeoutMs)
        {
            FramesHandle frames = Native.roomcast_wait_frames(viewer, timeoutMs);
            return frames.IsInvalid ? null : new Frames(frames);
        }

        /// Shows this viewer to the others. Frames of head and hands: x right, y up, z backwards. Hands may be null.
        public void SendPose(double[] worldFromHead, double[] worldFromLeftHand = null, double[] worldFromRightHand = null)
        {
            var error = new byte[512];
            using (var pinned = new Pinned())
            {
                var pose = new Native.Pose
                {
                    size = Native.SizeOf<Native.Pose>(),
                    world_from_head = pinned.At(Matrix(worldFromHead)),
                    world_from_left_hand = pinned.At(Matrix(worldFromLeftHand)),
                    world_from_right_hand = pinned.At(Matrix(worldFromRightHand)),
                };
                if (Native.roomcast_send_pose(viewer, ref pose, error, Size(error)) == 0) throw new RoomcastException(Native.TextOf(error));
            }
        }

        /// Leaves the room.
        public void Dispose()
        {
            viewer.Dispose();
        }

        internal static UIntPtr Size(byte[] bytes)
        {
            return (UIntPtr)(uint)bytes.Length;
        }

        internal static double[] Matrix(double[] numbers)
        {
            if (numbers != null && numbers.Length != 16) throw new RoomcastException("a matrix has 16 numbers, not " + numbers.Length);
            return numbers;
        }

        private delegate int Question(ViewerHandle viewer, byte[] error, UIntPtr size);

        private string Ask(Question question)
        {
            var error = new byte[512];
            return question(viewer, error, Size(error)) != 0 ? null : Native.TextOf(error);
        }
    }

    /// Records a room to an MCAP file, from its construction to Stop().
    public sealed class Recorder : IDisposable
    {
        private readonly RecorderHandle recorder;

        public Recorder(RoomOptions options, string path)
        {
            var error = new byte[512];
            using (var pinned = new Pinned())
            {
                Native.Options native = pinned.Options(options);
                recorder = Native.roomcast_record(ref native, Native.BytesOf(path), error, Room.Size(error));
            }
            if (recorder.IsInvalid) throw new RoomcastException(Native.TextOf(error));
        }

        /// Why the recording has stopped; null while it goes on.
        public string Problem
        {
            get
            {
                var error = new byte[512];
                return Native.roomcast_is_recording(recorder, error, Room.Size(error)) != 0 ? null : Native.TextOf(error);
            }
        }

        /// Completes the file.
        public void Stop()
        {
            recorder.Dispose();
            if (recorder.Problem != null) throw new RoomcastException(recorder.Problem);
        }

        public void Dispose()
        {
            recorder.Dispose();
        }
    }
}
