// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.InteropServices;

namespace Roomcast
{
    /// The people in the room and what they have left there, at one moment: immutable.
    public sealed class People : IDisposable
    {
        internal readonly PeopleHandle Handle;

        internal People(PeopleHandle handle)
        {
            Handle = handle;
            PersonCount = (int)Native.roomcast_person_count(handle);
            MarkCount = (int)Native.roomcast_mark_count(handle);
        }

        public int PersonCount { get; private set; }
        public int MarkCount { get; private set; }

        public Person GetPerson(int number)
        {
            var person = new Native.Person
            {
                size = Native.SizeOf<Native.Person>(),
                world_from_head = new double[16], world_from_left_hand = new double[16], world_from_right_hand = new double[16],
            };
            if (number < 0 || Native.roomcast_get_person(Handle, (UIntPtr)(uint)number, ref person) == 0)
                throw new ArgumentOutOfRangeException("number");
            return new Person(person);
        }

        public Mark GetMark(int number)
        {
            var mark = new Native.Mark { size = Native.SizeOf<Native.Mark>() };
            bool kept = false;
            try
            {
                Handle.DangerousAddRef(ref kept);
                if (number < 0 || Native.roomcast_get_mark(Handle, (UIntPtr)(uint)number, ref mark) == 0)
                    throw new ArgumentOutOfRangeException("number");
                return new Mark(mark);
            }
            finally
            {
                if (kept) Handle.DangerousRelease();
            }
        }

        public void Dispose()
        {
            Handle.Dispose();
        }
    }

    /// A person in the room. Frames of head and hands: x right, y up, z backwards.
    public sealed class Person
    {
        internal Person(Native.Person native)
        {
            Id = native.id;
            Name = Native.TextAt(native.name);
            R = native.r;
            G = native.g;
            B = native.b;
            IsSelf = native.is_self != 0;
            Speaking = native.speaking != 0;
            Muted = native.muted != 0;
            WorldFromHead = native.has_head != 0 ? native.world_from_head : null;
            WorldFromLeftHand = native.has_left_hand != 0 ? native.world_from_left_hand : null;
            WorldFromRightHand = native.has_right_hand != 0 ? native.world_from_right_hand : null;
        }

        public uint Id { get; private set; }
        public string Name { get; private set; }
        /// The person's colour for everybody.
        public byte R { get; private set; }
        public byte G { get; private set; }
        public byte B { get; private set; }
        public bool IsSelf { get; private set; }
        /// Known in rooms joined with Hears, as is Muted.
        public bool Speaking { get; private set; }
        public bool Muted { get; private set; }
        /// Null: not known.
        public double[] WorldFromHead { get; private set; }
        public double[] WorldFromLeftHand { get; private set; }
        public double[] WorldFromRightHand { get; private set; }
    }

    public enum MarkKind
    {
        Note = 1, // words at a point
        Sketch,   // a line of 2 to 512 points
        Distance, // between two points
        Place,    // a name, where somebody stands, and what they look at
    }

    /// What somebody has left in the room for everybody.
    public sealed class Mark
    {
        /// To be left.
        public Mark(MarkKind kind, float[] points, string text = "")
        {
            Kind = kind;
            Points = points;
            Text = text;
        }

        internal Mark(Native.Mark native)
        {
            Id = native.id;
            Kind = (MarkKind)native.kind;
            Points = new float[3 * (int)native.point_count];
            if (Points.Length > 0) Marshal.Copy(native.points, Points, 0, Points.Length);
            Text = Native.TextAt(native.text);
            Author = Native.TextAt(native.author);
            Own = native.own != 0;
        }

        public uint Id { get; private set; }
        public MarkKind Kind { get; private set; }
        /// x, y, z of each in the world frame.
        public float[] Points { get; private set; }
        public string Text { get; private set; }
        public string Author { get; private set; }
        /// This program may remove it.
        public bool Own { get; private set; }
    }

    /// 20 ms of somebody's voice.
    public sealed class Voice
    {
        public const int RateHz = 48000, SampleCount = 960, MaxOpusBytes = 1275;

        /// Samples of one channel, -1 to 1.
        public readonly float[] Samples = new float[SampleCount];
        internal readonly byte[] Buffer = new byte[MaxOpusBytes];
        internal Native.Voice Native;

        /// As it came (RFC 6716). Empty: lost on its way, and Samples conceals that.
        public byte[] GetOpus()
        {
            var opus = new byte[(int)Native.opus_bytes];
            Array.Copy(Buffer, opus, opus.Length);
            return opus;
        }
        public uint Speaker { get { return Native.speaker; } } // a person's Id
        public uint Seq { get { return Native.seq; } }
        public bool Ends { get { return Native.ends != 0; } }  // the speaker pauses after it
        public long CaptureNs { get { return Native.capture_ns; } }
        /// Where the speaker is now; null: not known.
        public double[] WorldFromHead { get { return Native.has_head != 0 ? Native.world_from_head : null; } }
    }

    /// A pose that an admin's proposal has led to.
    public struct Placement
    {
        public double[] WorldFromDepth;
        public double ExpectedErrorMm; // 2.5 m ahead of the sensor
    }
}
