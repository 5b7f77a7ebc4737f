// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.InteropServices;

namespace Roomcast
{
    /// The newest pictures of all sensors at one moment: immutable. They stay valid after the room was left, until Dispose().
    public sealed class Frames : IDisposable
    {
        internal readonly FramesHandle Handle;

        internal Frames(FramesHandle handle)
        {
            Handle = handle;
            Count = (int)Native.roomcast_sensor_count(handle);
            RoomSensorCount = (int)Native.roomcast_room_sensor_count(handle);
        }

        /// Sensors whose pictures are here, and sensors that are sending in the room: more, just after connecting.
        public int Count { get; private set; }
        public int RoomSensorCount { get; private set; }

        public SensorFrame this[int number]
        {
            get
            {
                var sensor = new Native.Sensor { size = Native.SizeOf<Native.Sensor>(), world_from_depth = new double[16] };
                if (number < 0 || Native.roomcast_get_sensor(Handle, (UIntPtr)(uint)number, ref sensor) == 0)
                    throw new ArgumentOutOfRangeException("number");
                return new SensorFrame(this, sensor);
            }
        }

        /// The points of all placed sensors.
        public Point[] GetPoints()
        {
            var points = new Point[(int)Native.roomcast_get_points(Handle, null, UIntPtr.Zero)];
            Native.roomcast_get_points(Handle, points, (UIntPtr)(uint)points.Length);
            return points;
        }

        public void Dispose()
        {
            Handle.Dispose();
        }
    }

    /// One sensor's part of Frames.
    public sealed class SensorFrame
    {
        private readonly Frames frames; // keeps the pictures
        private readonly Native.Sensor native;

        internal SensorFrame(Frames frames, Native.Sensor native)
        {
            this.frames = frames;
            this.native = native;
            Name = Native.TextAt(native.name);
        }

        public string Name { get; private set; }
        public uint Id { get { return native.id; } }
        /// Of all pictures, which share the depth camera's pixel grid.
        public int Width { get { return native.width; } }
        public int Height { get { return native.height; } }
        /// Pixels; pixel centres are at whole numbers.
        public double Fx { get { return native.fx; } }
        public double Fy { get { return native.fy; } }
        public double Cx { get { return native.cx; } }
        public double Cy { get { return native.cy; } }
        /// k1, k2, k3, p1, p2 of Brown and Conrady, as in OpenCV.
        public double[] Distortion { get { return new[] { native.k1, native.k2, native.k3, native.p1, native.p2 }; } }
        public double[] WorldFromDepth { get { return native.world_from_depth; } }
        /// False: the pose is unknown and WorldFromDepth provisional.
        public bool Placed { get { return native.placed != 0; } }
        /// Frame number of this sensor.
        public uint Seq { get { return native.seq; } }
        /// On the room's clock.
        public long CaptureNs { get { return native.capture_ns; } }
        /// Since 1970-01-01 UTC, by this computer's clock. 0: the library is older than 1.4.
        public long CaptureUtcNs { get { return native.capture_utc_ns; } }
        public bool HasColor { get { return native.color_rgb != IntPtr.Zero; } }

        /// The pictures without a copy: Width * Height numbers of 2, 3 and 1 bytes; zero: there is none. Valid until Frames is
        /// disposed of.
        public IntPtr DepthMm { get { return native.depth_mm; } }
        public IntPtr ColorRgb { get { return native.color_rgb; } }
        public IntPtr ColorSeen { get { return native.color_seen; } }

        /// A copy, row by row, in millimetres; 0: no reading.
        public ushort[] CopyDepth()
        {
            var copy = new short[Width * Height];
            Copy(() => Marshal.Copy(native.depth_mm, copy, 0, copy.Length));
            var depth = new ushort[copy.Length];
            Buffer.BlockCopy(copy, 0, depth, 0, 2 * copy.Length);
            return depth;
        }

        /// A copy, row by row: red, green, blue. Null: the frame has no colour.
        public byte[] CopyColor()
        {
            if (!HasColor) return null;
            var color = new byte[3 * Width * Height];
            Copy(() => Marshal.Copy(native.color_rgb, color, 0, color.Length));
            return color;
        }

        /// Another thread may dispose of the frames meanwhile: they are kept until it is done.
        private void Copy(Action copy)
        {
            bool kept = false;
            try
            {
                frames.Handle.DangerousAddRef(ref kept);
                copy();
            }
            finally
            {
                if (kept) frames.Handle.DangerousRelease();
            }
        }
    }
}
