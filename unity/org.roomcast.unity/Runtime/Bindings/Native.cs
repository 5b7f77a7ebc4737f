// SPDX-License-Identifier: Apache-2.0
// The functions and structures of roomcast.h, as they are there. Use the classes beside this file.
using System;
using System.Runtime.InteropServices;
using System.Text;

namespace Roomcast
{
    internal static class Native
    {
        private const string Library = "roomcast"; // libroomcast.so, or what a <dllmap> of the program names

        [StructLayout(LayoutKind.Sequential)]
        internal struct Options
        {
            public UIntPtr size;
            public IntPtr hub, room, name, token, author_key;
            public int hears, reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        internal struct Sensor
        {
            public UIntPtr size;
            public IntPtr name;
            public uint id;
            public int width, height;
            public double fx, fy, cx, cy;
            public double k1, k2, k3, p1, p2;
            [MarshalAs(UnmanagedType.ByValArray, SizeConst = 16)]
            public double[] world_from_depth;
            public int placed;
            public uint seq;
            public long capture_ns;
            public IntPtr depth_mm, color_rgb, color_seen;
            public long capture_utc_ns;
        }

        [StructLayout(LayoutKind.Sequential)]
        internal struct Pose
        {
            public UIntPtr size;
            public IntPtr world_from_head, world_from_left_hand, world_from_right_hand;
        }

        [StructLayout(LayoutKind.Sequential)]
        internal struct Camera
        {
            public UIntPtr size;
            public int width, height;
            public double fx, fy, cx, cy;
            public double k1, k2, k3, p1, p2;
        }

        [StructLayout(LayoutKind.Sequential)]
        internal struct SensorOptions
        {
            public UIntPtr size;
            public IntPtr depth, color, color_from_depth, world_from_depth;
            public double fps;
            public int depth_mode, depth_bound_mm, color_kbit_per_s, reserved, send_unwatched;
        }

        [StructLayout(LayoutKind.Sequential)]
        internal struct Capture
        {
            public UIntPtr size;
            public long capture_ns;
            public IntPtr depth_mm;
            public int depth_width, depth_height;
            public IntPtr color_rgb;
            public int color_width, color_height;
        }

        [StructLayout(LayoutKind.Sequential)]
        internal struct SendReport
        {
            public UIntPtr size;
            public int sent, connected;
            public uint frames_waiting, max_frames_waiting, seq;
            public long capture_ns;
            public ulong frames_sent, frames_skipped, bytes_sent;
            public double rate_share;
        }

        [StructLayout(LayoutKind.Sequential)]
        internal struct Person
        {
            public UIntPtr size;
            public uint id;
            public byte r, g, b, a;
            public IntPtr name;
            public int is_self, speaking, muted, has_head, has_left_hand, has_right_hand;
            [MarshalAs(UnmanagedType.ByValArray, SizeConst = 16)]
            public double[] world_from_head;
            [MarshalAs(UnmanagedType.ByValArray, SizeConst = 16)]
            public double[] world_from_left_hand;
            [MarshalAs(UnmanagedType.ByValArray, SizeConst = 16)]
            public double[] world_from_right_hand;
        }

        [StructLayout(LayoutKind.Sequential)]
        internal struct Mark
        {
            public UIntPtr size;
            public uint id;
            public int kind;
            public IntPtr points;
            public UIntPtr point_count;
            public IntPtr text, author;
            public byte r, g, b, a;
            public int own;
        }

        [StructLayout(LayoutKind.Sequential)]
        internal struct Voice
        {
            public UIntPtr size;
            public IntPtr samples, opus;
            public UIntPtr opus_bytes;
            public uint speaker, seq;
            public int ends, has_head;
            public long capture_ns;
            [MarshalAs(UnmanagedType.ByValArray, SizeConst = 16)]
            public double[] world_from_head;
        }

        [StructLayout(LayoutKind.Sequential)]
        internal struct Placement
        {
            public UIntPtr size;
            [MarshalAs(UnmanagedType.ByValArray, SizeConst = 16)]
            public double[] world_from_depth;
            public double expected_error_mm;
        }

        [StructLayout(LayoutKind.Sequential)]
        internal struct Nudge
        {
            public UIntPtr size;
            [MarshalAs(UnmanagedType.ByValArray, SizeConst = 3)]
            public double[] shift_m;
            public double turn_rad, tilt_rad;
        }

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr roomcast_version();

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern ViewerHandle roomcast_connect(ref Options options, byte[] error, UIntPtr error_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void roomcast_disconnect(IntPtr viewer);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int roomcast_is_connected(ViewerHandle viewer, byte[] error, UIntPtr error_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int roomcast_may_record(ViewerHandle viewer, byte[] error, UIntPtr error_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int roomcast_may_export(ViewerHandle viewer, byte[] error, UIntPtr error_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int roomcast_send_pose(ViewerHandle viewer, ref Pose pose, byte[] error, UIntPtr error_size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern FramesHandle roomcast_wait_frames(ViewerHandle viewer, int timeout_ms);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void roomcast_free_frames(IntPtr frames);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern UIntPtr roomcast_sensor_count(FramesHandle frames);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern UIntPtr roomcast_room_sensor_count(FramesHandle frames);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int roomcast_get_sensor(FramesHandle frames, UIntPtr number, ref Sensor sensor);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern UIntPtr roomcast_get_points(FramesHandle frames, [Out] Point[] points, UIntPtr capacity);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern RecorderHandle roomcast_record(ref Options options, byte[] path, byte[] error, UIntPtr error_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int roomcast_is_recording(RecorderHandle recorder, byte[] error, UIntPtr error_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int roomcast_stop_recording(IntPtr recorder, byte[] error, UIntPtr error_size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long roomcast_host_time_ns();
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern PublisherHandle roomcast_publish(ref Options options, ref SensorOptions sensor, byte[] error, UIntPtr error_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int roomcast_send_frame(PublisherHandle publisher, ref Capture capture, ref SendReport report, byte[] error, UIntPtr error_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int roomcast_is_publishing(PublisherHandle publisher, byte[] error, UIntPtr error_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void roomcast_stop_publishing(IntPtr publisher);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern PeopleHandle roomcast_wait_people(ViewerHandle viewer, PeopleHandle known, int timeout_ms);
        [DllImport(Library, EntryPoint = "roomcast_wait_people", CallingConvention = CallingConvention.Cdecl)]
        internal static extern PeopleHandle roomcast_wait_people_now(ViewerHandle viewer, IntPtr none, int timeout_ms);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void roomcast_free_people(IntPtr people);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern UIntPtr roomcast_person_count(PeopleHandle people);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int roomcast_get_person(PeopleHandle people, UIntPtr number, ref Person person);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern UIntPtr roomcast_mark_count(PeopleHandle people);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int roomcast_get_mark(PeopleHandle people, UIntPtr number, ref Mark mark);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int roomcast_leave_mark(ViewerHandle viewer, ref Mark mark, out uint id, byte[] error, UIntPtr error_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int roomcast_remove_mark(ViewerHandle viewer, uint id, byte[] error, UIntPtr error_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int roomcast_next_voice(ViewerHandle viewer, int timeout_ms, ref Voice voice);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int roomcast_may_speak(ViewerHandle viewer, byte[] error, UIntPtr error_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int roomcast_speak(ViewerHandle viewer, float[] samples, UIntPtr count, byte[] error, UIntPtr error_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void roomcast_pause_speaking(ViewerHandle viewer);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int roomcast_place_sensor(ViewerHandle viewer, byte[] sensor, double[] world_from_depth, ref Placement placement, byte[] error, UIntPtr error_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int roomcast_nudge_sensor(ViewerHandle viewer, byte[] sensor, ref Nudge nudge, ref Placement placement, byte[] error, UIntPtr error_size);

        internal static UIntPtr SizeOf<T>()
        {
            return (UIntPtr)(uint)Marshal.SizeOf(typeof(T));
        }

        /// The text up to the zero byte.
        internal static string TextOf(byte[] bytes)
        {
            int length = Array.IndexOf(bytes, (byte)0);
            return Encoding.UTF8.GetString(bytes, 0, length < 0 ? bytes.Length : length);
        }

        internal static string TextAt(IntPtr text)
        {
            if (text == IntPtr.Zero) return null;
            int length = 0;
            while (Marshal.ReadByte(text, length) != 0) ++length;
            var bytes = new byte[length];
            Marshal.Copy(text, bytes, 0, length);
            return Encoding.UTF8.GetString(bytes);
        }

        /// Bytes with a zero byte at the end, null for null.
        internal static byte[] BytesOf(string text)
        {
            return text == null ? null : Encoding.UTF8.GetBytes(text + "\0");
        }
    }

    /// Memory that the library reads during a call: arrays are kept in place until it is disposed of.
    internal sealed class Pinned : IDisposable
    {
        private readonly System.Collections.Generic.List<GCHandle> handles = new System.Collections.Generic.List<GCHandle>();

        /// The address of an array or a structure, zero for null.
        internal IntPtr At(object value)
        {
            if (value == null) return IntPtr.Zero;
            GCHandle handle = GCHandle.Alloc(value, GCHandleType.Pinned);
            handles.Add(handle);
            return handle.AddrOfPinnedObject();
        }

        internal Native.Options Options(RoomOptions options)
        {
            return new Native.Options
            {
                size = Native.SizeOf<Native.Options>(),
                hub = At(Native.BytesOf(options.Hub)),
                room = At(Native.BytesOf(options.Room)),
                name = At(Native.BytesOf(options.Name)),
                token = At(Native.BytesOf(options.Token)),
                author_key = At(Native.BytesOf(options.AuthorKey)),
                hears = options.Hears ? 1 : 0,
            };
        }

        public void Dispose()
        {
            foreach (GCHandle handle in handles) handle.Free();
            handles.Clear();
        }
    }

    internal abstract class NativeHandle : SafeHandle
    {
        protected NativeHandle() : base(IntPtr.Zero, true) { }
        public override bool IsInvalid { get { return handle == IntPtr.Zero; } }
    }

    internal sealed class ViewerHandle : NativeHandle
    {
        protected override bool ReleaseHandle()
        {
            Native.roomcast_disconnect(handle);
            return true;
        }
    }

    internal sealed class FramesHandle : NativeHandle
    {
        protected override bool ReleaseHandle()
        {
            Native.roomcast_free_frames(handle);
            return true;
        }
    }

    internal sealed class PeopleHandle : NativeHandle
    {
        protected override bool ReleaseHandle()
        {
            Native.roomcast_free_people(handle);
            return true;
        }
    }

    internal sealed class RecorderHandle : NativeHandle
    {
        internal string Problem; // of the end

        protected override bool ReleaseHandle()
        {
            var error = new byte[512];
            if (Native.roomcast_stop_recording(handle, error, (UIntPtr)(uint)error.Length) == 0) Problem = Native.TextOf(error);
            return true;
        }
    }

    internal sealed class PublisherHandle : NativeHandle
    {
        protected override bool ReleaseHandle()
        {
            Native.roomcast_stop_publishing(handle);
            return true;
        }
    }
}
