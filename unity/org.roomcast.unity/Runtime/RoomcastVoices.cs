// SPDX-License-Identifier: Apache-2.0
// NOT RUN: the tests compile this against stubs of the editor's classes; no editor was at hand. HeardSound, which keeps a voice
// even, is run by them.
//
// Plays the voices of the people in a room from where they stand, and says what the microphone hears. Main thread only, but for
// Join() and what it returns, which belong to the thread that receives.
using System;
using System.Collections.Generic;
using System.Threading;
using UnityEngine;

namespace Roomcast.Unity
{
    internal sealed class RoomcastVoices
    {
        private readonly Transform parent;
        private readonly Dictionary<uint, HeardSound> sounds = new Dictionary<uint, HeardSound>(); // guarded by itself
        private readonly Dictionary<uint, GameObject> speakers = new Dictionary<uint, GameObject>();
        private volatile Room joined; // null: there is none
        private AudioClip microphone;
        private int said; // samples of the microphone's ring that were said
        private string whyNotSpeak;

        internal RoomcastVoices(Transform parent)
        {
            this.parent = parent;
        }

        /// Why nothing is said although it was asked for; null: all is well.
        internal string WhyNotSpeak { get { return whyNotSpeak; } }

        private sealed class Membership : IDisposable
        {
            internal RoomcastVoices voices;
            internal Thread listener;
            internal volatile bool ended;

            public void Dispose()
            {
                voices.joined = null;
                ended = true;
                if (listener != null) listener.Join();
            }
        }

        /// From here on until the result is disposed of.
        internal IDisposable Join(Room room, bool hears)
        {
            var membership = new Membership { voices = this };
            joined = room;
            if (!hears) return membership;
            membership.listener = new Thread(() => Listen(room, membership)) { IsBackground = true, Name = "roomcast voices" };
            membership.listener.Start();
            return membership;
        }

        private void Listen(Room room, Membership membership)
        {
            var voice = new Voice();
            while (!membership.ended)
            {
                if (!room.NextVoice(voice, 50))
                {
                    if (room.Problem != null) Thread.Sleep(50); // one that has ended for good returns at once
                    continue;
                }
                HeardSound sound;
                lock (sounds)
                {
                    if (!sounds.TryGetValue(voice.Speaker, out sound)) sounds[voice.Speaker] = sound = new HeardSound();
                }
                sound.Put(voice.Samples, voice.Ends);
            }
        }

        /// Makes a loudspeaker for everybody who has spoken, at the head; removes those of people who left.
        internal void Place(Person[] people)
        {
            var here = new HashSet<uint>();
            foreach (Person person in people)
            {
                here.Add(person.Id);
                HeardSound sound;
                lock (sounds)
                {
                    if (!sounds.TryGetValue(person.Id, out sound)) continue;
                }
                GameObject speaker;
                if (!speakers.TryGetValue(person.Id, out speaker)) speakers[person.Id] = speaker = Make(person, sound);
                if (person.WorldFromHead != null) speaker.transform.localPosition = RoomcastPeople.PlaceOf(person.WorldFromHead);
                speaker.GetComponent<AudioSource>().spatialBlend = person.WorldFromHead != null ? 1 : 0;
            }
            foreach (uint id in new List<uint>(speakers.Keys))
            {
                if (here.Contains(id)) continue;
                UnityEngine.Object.Destroy(speakers[id]);
                speakers.Remove(id);
                lock (sounds) sounds.Remove(id);
            }
        }

        private GameObject Make(Person person, HeardSound sound)
        {
            var speaker = new GameObject("roomcast voice " + person.Name);
            speaker.transform.SetParent(parent, false);
            AudioSource source = speaker.AddComponent<AudioSource>();
            source.clip = AudioClip.Create("roomcast voice", Voice.RateHz, 1, Voice.RateHz, true, sound.Take);
            source.loop = true;
            source.minDistance = 1; // as in the page
            source.Play();
            return speaker;
        }

        /// Once per picture.
        internal void Update(bool speaks)
        {
            Room room = joined;
            if (!speaks || room == null)
            {
                StopMicrophone(room);
                return;
            }
            if (microphone == null)
            {
                whyNotSpeak = room.WhyNotSpeak;
                if (whyNotSpeak != null) return;
                microphone = Microphone.Start(null, true, 1, Voice.RateHz);
                said = 0;
                if (microphone == null || microphone.frequency != Voice.RateHz) whyNotSpeak = "there is no microphone of 48 kHz";
            }
            if (whyNotSpeak == null) Say(room);
        }

        private void Say(Room room)
        {
            int recorded = Microphone.GetPosition(null);
            int count = (recorded - said + microphone.samples) % microphone.samples;
            if (count == 0) return;
            var samples = new float[count];
            microphone.GetData(samples, said);
            said = recorded;
            try
            {
                room.Speak(samples);
            }
            catch (RoomcastException failure)
            {
                whyNotSpeak = failure.Message;
            }
            catch (ObjectDisposedException)
            {
                // The room was left just now.
            }
        }

        private void StopMicrophone(Room room)
        {
            if (microphone == null) return;
            Microphone.End(null);
            UnityEngine.Object.Destroy(microphone);
            microphone = null;
            try
            {
                if (room != null) room.PauseSpeaking();
            }
            catch (ObjectDisposedException)
            {
                // The room was left just now.
            }
        }

        internal void Clear()
        {
            StopMicrophone(joined);
            foreach (GameObject speaker in speakers.Values) UnityEngine.Object.Destroy(speaker);
            speakers.Clear();
            lock (sounds) sounds.Clear();
        }
    }
}
