// SPDX-License-Identifier: Apache-2.0
// One person's voice as an even stream: packets go in as they come, samples come out when the loudspeaker asks. 60 ms are kept in
// stock, more where packets come so unevenly that they did not suffice; what is too much is left out. Samples: 48 kHz, one
// channel. May be used by two threads: one that puts, one that takes.
using System;

namespace Roomcast
{
    public sealed class HeardSound
    {
        private const int Packet = Voice.SampleCount;
        private const int FirstStock = 3 * Packet, LargestStock = 15 * Packet;

        private readonly float[] ring = new float[2 * LargestStock];
        private readonly object guard = new object();
        private int begin, count;
        private int stock = FirstStock;
        private bool playing, ended;

        /// How often the stock did not suffice while somebody spoke.
        public int Gaps { get; private set; }

        public void Put(float[] samples, bool ends)
        {
            lock (guard)
            {
                ended = ends;
                for (int i = 0; i < samples.Length; ++i) ring[(begin + count + i) % ring.Length] = samples[i];
                count += samples.Length;
                int tooMuch = count - stock - 2 * Packet;
                if (playing && tooMuch > 0) Drop(tooMuch);
                else if (count > LargestStock) Drop(count - LargestStock);
                if (count >= stock || (ended && count > 0)) playing = true;
            }
        }

        /// Fills `samples`; silence where there is nothing to say.
        public void Take(float[] samples)
        {
            lock (guard)
            {
                int given = playing ? Math.Min(count, samples.Length) : 0;
                for (int i = 0; i < given; ++i) samples[i] = ring[(begin + i) % ring.Length];
                Array.Clear(samples, given, samples.Length - given);
                Drop(given);
                if (!playing || given == samples.Length) return;
                playing = false;
                if (ended) return;
                ++Gaps;
                stock = Math.Min(stock + Packet, LargestStock - 2 * Packet);
            }
        }

        private void Drop(int samples)
        {
            begin = (begin + samples) % ring.Length;
            count -= samples;
        }
    }
}
