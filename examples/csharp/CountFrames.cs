// SPDX-License-Identifier: Apache-2.0
// Counts the frames of each sensor of a room: mono CountFrames.exe ws://127.0.0.1:7600 SECONDS [TOKEN]
using System;
using System.Collections.Generic;
using System.Diagnostics;
using Roomcast;

static class CountFrames
{
    static int Main(string[] args)
    {
        var counts = new SortedDictionary<string, int>();
        var last = new Dictionary<string, uint>();
        try
        {
            var watch = Stopwatch.StartNew();
            using (Room room = Room.Connect(args[0], args.Length > 2 ? args[2] : null))
                while (watch.Elapsed.TotalSeconds < double.Parse(args[1]))
                    using (Frames frames = room.WaitFrames(100))
                        for (int i = 0; frames != null && i < frames.Count; ++i)
                        {
                            SensorFrame sensor = frames[i];
                            uint before;
                            if (last.TryGetValue(sensor.Name, out before) && before == sensor.Seq) continue;
                            last[sensor.Name] = sensor.Seq;
                            counts[sensor.Name] = counts.ContainsKey(sensor.Name) ? counts[sensor.Name] + 1 : 1;
                        }
        }
        catch (RoomcastException problem)
        {
            Console.Error.WriteLine("CountFrames: " + problem.Message);
            return 1;
        }
        foreach (var sensor in counts) Console.WriteLine(sensor.Key + ": " + sensor.Value + " frames");
        return 0;
    }
}
