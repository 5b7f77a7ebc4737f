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
                case "people": return PeopleOf(args[1]);
                case "voices": return Voices(args[1]);
                case "sound": return Sound();
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

    /// Leaves a mark, shows a head, and prints what another viewer sees of both.
    static int PeopleOf(string hub)
    {
        using (Room ada = Room.Connect(new RoomOptions { Hub = hub, Name = "Ada" }), ben = Room.Connect(new RoomOptions { Hub = hub, Name = "Ben" }))
        {
            uint id = ada.LeaveMark(new Mark(MarkKind.Note, new float[] { 1, 2, 3 }, "C\u266f"));
            People people = null;
            for (var watch = Stopwatch.StartNew(); watch.Elapsed.TotalSeconds < 15;)
            {
                ada.SendPose(new double[] { 1, 0, 0, 0.5, 0, 1, 0, 1.5, 0, 0, 1, 2, 0, 0, 0, 1 });
                people = ben.WaitPeople(people, 200) ?? people;
                Person other = Enumerable.Range(0, people.PersonCount).Select(people.GetPerson).FirstOrDefault(person => !person.IsSelf);
                if (people.MarkCount != 1 || other == null || other.WorldFromHead == null) continue;
                Mark mark = people.GetMark(0);
                Console.WriteLine(string.Join(" ", mark.Id == id, mark.Kind, string.Join(",", mark.Points), mark.Text, mark.Author, mark.Own));
                Console.WriteLine(other.Name + " " + string.Join(" ", other.WorldFromHead) + " " + (other.WorldFromLeftHand == null));
                break;
            }
            Expect<RoomcastException>("mark of another", () => ben.RemoveMark(id));
            Expect<RoomcastException>("note without words", () => ada.LeaveMark(new Mark(MarkKind.Note, new float[3])));
            Expect<RoomcastException>("half a point", () => ada.LeaveMark(new Mark(MarkKind.Note, new float[2], "x")));
            Expect<RoomcastException>("place without a token", () => ada.PlaceSensor("s0", new double[] { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 }));
            Expect<RoomcastException>("nudge without a token", () => ada.NudgeSensor("s0", 0.1, 0, 0));
            ada.RemoveMark(id);
            people.Dispose();
            Expect<ObjectDisposedException>("people that are gone", () => people.GetPerson(0));
        }
        return 0;
    }

    /// Says a tone, and prints how loud another viewer hears it.
    static int Voices(string hub)
    {
        using (Room ada = Room.Connect(new RoomOptions { Hub = hub, Name = "Ada" }), ben = Room.Connect(new RoomOptions { Hub = hub, Name = "Ben", Hears = true }))
        {
            var tone = new float[1920];
            for (int i = 0; i < tone.Length; ++i) tone[i] = 0.5f * (float)Math.Sin(2 * Math.PI * 500 * i / Voice.RateHz);
            Console.WriteLine(ada.WhyNotSpeak ?? "may speak");
            var voice = new Voice();
            float loudest = 0;
            int packets = 0;
            for (var watch = Stopwatch.StartNew(); watch.Elapsed.TotalSeconds < 15 && packets < 20; Thread.Sleep(38))
            {
                ada.Speak(tone);
                for (; ben.NextVoice(voice, 0); ++packets) loudest = Math.Max(loudest, voice.Samples.Max());
            }
            ada.PauseSpeaking();
            while (ben.NextVoice(voice, 5000) && !voice.Ends) { }
            Console.WriteLine((packets >= 20) + " " + (loudest > 0.4 && loudest < 0.6) + " " + voice.Ends + " " + (voice.GetOpus().Length > 0));
            Expect<RoomcastException>("too much at once", () => ada.Speak(new float[48001]));
        }
        return 0;
    }

    /// The stock of HeardSound, without a hub.
    static int Sound()
    {
        var sound = new HeardSound();
        var packet = Enumerable.Repeat(1f, Voice.SampleCount).ToArray();
        var taken = new float[Voice.SampleCount];
        Func<float> take = () =>
        {
            sound.Take(taken);
            return taken.Average();
        };
        sound.Put(packet, false);
        Console.WriteLine("one packet is kept: " + take());
        sound.Put(packet, false);
        sound.Put(packet, false);
        Console.WriteLine("three are played: " + take() + " " + take() + " " + take());
        Console.WriteLine("then silence: " + take() + ", gaps " + sound.Gaps);
        for (int i = 0; i < 40; ++i) sound.Put(packet, i == 39);
        int left = 0;
        while (take() == 1) ++left;
        Console.WriteLine("of too many the newest are left: " + (left > 3 && left < 16) + ", gaps " + sound.Gaps);
        sound.Put(packet, true);
        Console.WriteLine("a short word is played: " + take());
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
