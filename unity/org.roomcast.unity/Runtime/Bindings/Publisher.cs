// SPDX-License-Identifier: Apache-2.0
using System;

namespace Roomcast
{
    /// A pinhole camera; distortion as in OpenCV.
    public sealed class Camera
    {
        public int Width, Height;
        public double Fx, Fy, Cx, Cy; // pixels
        public double K1, K2, K3, P1, P2;

        internal Native.Camera ToNative()
        {
            return new Native.Camera
            {
                size = Native.SizeOf<Native.Camera>(),
                width = Width, height = Height, fx = Fx, fy = Fy, cx = Cx, cy = Cy, k1 = K1, k2 = K2, k3 = K3, p1 = P1, p2 = P2,
            };
        }
    }

    public enum DepthMode
    {
        Live = 0,         // few bytes: the sensor's noise is not sent
        NearLossless = 1, // every reading within DepthBoundMm
        Lossless = 2,     // every reading exact
    }

    /// A sensor. All but Depth may be left as it is.
    public sealed class SensorOptions
    {
        public Camera Depth;
        public Camera Color;            // null: colour, if any, comes in the depth camera's pixel grid
        public double[] ColorFromDepth; // null: both cameras are at the same place
        public double[] WorldFromDepth; // null: the pose is unknown
        public double Fps = 30;
        public DepthMode DepthMode;
        public int DepthBoundMm;        // 1 to 63; 0: 2
        public int ColorKbitPerS;       // 0: 790
        public bool SendUnwatched;      // send while nobody watches, too
    }

    /// What became of a frame.
    public struct SendReport
    {
        public bool Sent;      // false: skipped, because nobody watches or the network does not keep up
        public bool Connected; // false: the library is reconnecting
        public ulong FramesSent, FramesSkipped, BytesSent;
    }

    /// A program as a sensor of a room. It reconnects by itself.
    public sealed class Publisher : IDisposable
    {
        private readonly PublisherHandle publisher;
        private readonly SensorOptions sensor;

        /// Joins the room as the sensor options.Name and waits for the hub's answer.
        public Publisher(RoomOptions options, SensorOptions sensor)
        {
            this.sensor = sensor;
            var error = new byte[512];
            using (var pinned = new Pinned())
            {
                Native.Options native = pinned.Options(options);
                var described = new Native.SensorOptions
                {
                    size = Native.SizeOf<Native.SensorOptions>(),
                    depth = sensor.Depth == null ? IntPtr.Zero : pinned.At(sensor.Depth.ToNative()),
                    color = sensor.Color == null ? IntPtr.Zero : pinned.At(sensor.Color.ToNative()),
                    color_from_depth = pinned.At(Room.Matrix(sensor.ColorFromDepth)),
                    world_from_depth = pinned.At(Room.Matrix(sensor.WorldFromDepth)),
                    fps = sensor.Fps,
                    depth_mode = (int)sensor.DepthMode,
                    depth_bound_mm = sensor.DepthBoundMm,
                    color_kbit_per_s = sensor.ColorKbitPerS,
                    send_unwatched = sensor.SendUnwatched ? 1 : 0,
                };
                publisher = Native.roomcast_publish(ref native, ref described, error, Room.Size(error));
            }
            if (publisher.IsInvalid) throw new RoomcastException(Native.TextOf(error));
        }

        /// The clock of Send(), nanoseconds.
        public static long HostTimeNs { get { return Native.roomcast_host_time_ns(); } }

        /// Sends one frame, or skips it. `depthMm`: of the depth camera's size, row by row; `colorRgb`: of the colour camera's
        /// size or null; `captureNs`: by HostTimeNs, 0: now.
        public SendReport Send(ushort[] depthMm, byte[] colorRgb = null, long captureNs = 0)
        {
            Camera colorCamera = sensor.Color ?? sensor.Depth;
            Check(depthMm == null ? -1 : depthMm.Length, sensor.Depth.Width * sensor.Depth.Height, "depth");
            if (colorRgb != null) Check(colorRgb.Length, 3 * colorCamera.Width * colorCamera.Height, "colour");
            var error = new byte[512];
            var report = new Native.SendReport { size = Native.SizeOf<Native.SendReport>() };
            using (var pinned = new Pinned())
            {
                var capture = new Native.Capture
                {
                    size = Native.SizeOf<Native.Capture>(),
                    capture_ns = captureNs,
                    depth_mm = pinned.At(depthMm),
                    depth_width = sensor.Depth.Width,
                    depth_height = sensor.Depth.Height,
                    color_rgb = pinned.At(colorRgb),
                    color_width = colorRgb == null ? 0 : colorCamera.Width,
                    color_height = colorRgb == null ? 0 : colorCamera.Height,
                };
                if (Native.roomcast_send_frame(publisher, ref capture, ref report, error, Room.Size(error)) == 0)
                    throw new RoomcastException(Native.TextOf(error));
            }
            return new SendReport
            {
                Sent = report.sent != 0,
                Connected = report.connected != 0,
                FramesSent = report.frames_sent,
                FramesSkipped = report.frames_skipped,
                BytesSent = report.bytes_sent,
            };
        }

        /// Why there is no connection; null while there is one.
        public string Problem
        {
            get
            {
                var error = new byte[512];
                return Native.roomcast_is_publishing(publisher, error, Room.Size(error)) != 0 ? null : Native.TextOf(error);
            }
        }

        /// Leaves the room.
        public void Dispose()
        {
            publisher.Dispose();
        }

        private static void Check(int length, int expected, string what)
        {
            if (length != expected) throw new RoomcastException("the " + what + " picture needs " + expected + " numbers, not " + Math.Max(0, length));
        }
    }
}
