// SPDX-License-Identifier: Apache-2.0
// For csharp.test.mjs: uses the bindings as programs do, and prints what came.
using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Threading;
using Roomcast;

static class Checks
{
    static readonly Camera Small = new Camera { Width = 64, Height = 48, Fx = 60, Fy = 60, Cx = 31.5, Cy = 23.5 };

    static int Main(string[] args)
    {
        try
        {
            switch (args[0])
            {
                case "layouts": return Layouts();
                case "depth": return Depth(args[1], args[2]);
                case "publish": return Publish(args[1], args[2]);
                case "record": return Record(args[1], args[2]);
                case "misuse": return Misuse(args[1]);
            }
        }
        catch (RoomcastException problem)
        {
            Console.Error.WriteLine("Checks: " + problem.Message);
        }
        return 1;
    }

    /// Each structure's size, and where its fields are.
    static int Layouts()
    {
        Type native = typeof(Room).Assembly.GetType("Roomcast.Native");
        foreach (Type type in native.GetNestedTypes(BindingFlags.NonPublic).Where(type => type.IsValueType))
        {
            Console.WriteLine(type.Name + " sizeof " + Marshal.SizeOf(type));
            foreach (FieldInfo field in type.GetFields(BindingFlags.Instance | BindingFlags.Public))
                Console.WriteLine(type.Name + " " + field.Name + " " + Marshal.OffsetOf(type, field.Name));
        }
        return 0;
    }

    static Frames WaitForAll(Room room)
    {
        for (var watch = Stopwatch.StartNew(); watch.Elapsed.TotalSeconds < 15;)
        {
            Frames frames = room.WaitFrames(100);
            if (frames != null && frames.Count > 0 && frames.Count == frames.RoomSensorCount) return frames;
            if (frames != null) frames.Dispose();
        }
        throw new RoomcastException("no frames came");
    }

    static int Depth(string hub, string file)
    {
        Frames frames;
        using (Room room = Room.Connect(new RoomOptions { Hub = hub, Name = "C\u266f" }))
        {
            frames = WaitForAll(room);
            room.SendPose(new double[] { 1, 0, 0, 0.5, 0, 1, 0, 1.5, 0, 0, 1, 2, 0, 0, 0, 1 });
            Thread.Sleep(500);
        }
        using (frames) // valid although the room was left
        {
            SensorFrame sensor = frames[0];
            var bytes = new byte[2 * sensor.Width * sensor.Height];
            Buffer.BlockCopy(sensor.CopyDepth(), 0, bytes, 0, bytes.Length);
            File.WriteAllBytes(file, bytes);
            Point[] points = frames.GetPoints();
            Console.WriteLine(string.Join(" ", sensor.Name, sensor.Width, sensor.Height, sensor.Fx, sensor.Cy, sensor.Placed, sensor.HasColor, points.Length, points[0].A));
            Console.WriteLine(string.Join(" ", sensor.WorldFromDepth));
            Console.WriteLine(sensor.CaptureUtcNs / 1000000);
        }
        return 0;
    }

    static int Publish(string hub, string name)
    {
        var depth = new ushort[64 * 48];
        for (int i = 0; i < depth.Length; ++i) depth[i] = (ushort)(1500 + i % 64 + i / 64);
        var options = new SensorOptions
        {
            Depth = Small, DepthMode = DepthMode.Lossless, Fps = 10, SendUnwatched = true,
            WorldFromDepth = new double[] { 1, 0, 0, 0, 0, -1, 0, 1.5, 0, 0, -1, 2, 0, 0, 0, 1 },
        };
        using (var publisher = new Publisher(new RoomOptions { Hub = hub, Name = name }, options))
        {
            var report = new SendReport();
            for (int i = 0; i < 60; ++i, Thread.Sleep(100)) report = publisher.Send(depth, new byte[3 * 64 * 48], Publisher.HostTimeNs);
            Console.WriteLine(report.FramesSent + " " + report.Connected + " " + (publisher.Problem ?? "no problem"));
        }
        return 0;
    }

    static int Record(string hub, string file)
    {
        using (var recorder = new Recorder(new RoomOptions { Hub = hub }, file))
        {
            Thread.Sleep(1500);
            Console.WriteLine(recorder.Problem ?? "no problem");
            recorder.Stop();
        }
        return 0;
    }

    static void Expect<T>(string what, Action action) where T : Exception
    {
        try
        {
            action();
            Console.WriteLine(what + ": nothing was thrown");
        }
        catch (T problem)
        {
            Console.WriteLine(what + ": " + problem.GetType().Name + ": " + problem.Message.Split('\n')[0]);
        }
    }

    static int Misuse(string hub)
    {
        Room room = Room.Connect(hub);
        Expect<RoomcastException>("short matrix", () => room.SendPose(new double[3]));
        Expect<RoomcastException>("no rotation", () => room.SendPose(new double[16]));
        Frames frames = WaitForAll(room);
        Expect<ArgumentOutOfRangeException>("no such sensor", () => frames[7].ToString());
        SensorFrame sensor = frames[0];
        frames.Dispose();
        frames.Dispose();
        Expect<ObjectDisposedException>("picture of freed frames", () => sensor.CopyDepth());
        room.Dispose();
        room.Dispose();
        Expect<ObjectDisposedException>("room that was left", () => room.WaitFrames(1));
        var options = new SensorOptions { Depth = Small };
        using (var publisher = new Publisher(new RoomOptions { Hub = hub, Name = "c" }, options))
            Expect<RoomcastException>("short picture", () => publisher.Send(new ushort[5]));
        Expect<RoomcastException>("sensor without a camera", () => new Publisher(new RoomOptions { Hub = hub, Name = "d" }, new SensorOptions()));
        Expect<RoomcastException>("nowhere", () => new Recorder(new RoomOptions { Hub = hub }, "/nowhere/a.mcap"));
        return 0;
    }
}
