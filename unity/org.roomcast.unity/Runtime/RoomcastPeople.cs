// SPDX-License-Identifier: Apache-2.0
// NOT RUN: the tests compile this against stubs of the editor's classes; no editor was at hand.
//
// Shows the heads of the people in a room: a ball in the person's colour, with the name above it. Main thread only.
using System.Collections.Generic;
using UnityEngine;

namespace Roomcast.Unity
{
    internal sealed class RoomcastPeople
    {
        private const float HeadDiameter = 0.22f, NameHeight = 0.25f;

        private sealed class Head
        {
            public GameObject ball, name;
            public Material material;
            public bool shown;
        }

        private readonly Transform room;
        private readonly Dictionary<uint, Head> heads = new Dictionary<uint, Head>();

        internal RoomcastPeople(Transform room)
        {
            this.room = room;
        }

        internal void Show(Person[] people)
        {
            foreach (Head head in heads.Values) head.shown = false;
            foreach (Person person in people)
            {
                if (person.WorldFromHead == null) continue;
                Head head;
                if (!heads.TryGetValue(person.Id, out head)) heads[person.Id] = head = Make(person);
                head.shown = true;
                head.ball.transform.localPosition = PlaceOf(person.WorldFromHead);
            }
            var gone = new List<uint>();
            foreach (KeyValuePair<uint, Head> head in heads)
            {
                if (!head.Value.shown) gone.Add(head.Key);
            }
            foreach (uint id in gone) Remove(id);
        }

        internal void Clear()
        {
            foreach (uint id in new List<uint>(heads.Keys)) Remove(id);
        }

        /// Unity is left-handed: z changes its sign.
        internal static Vector3 PlaceOf(double[] worldFromHead)
        {
            return new Vector3((float)worldFromHead[3], (float)worldFromHead[7], -(float)worldFromHead[11]);
        }

        private Head Make(Person person)
        {
            var head = new Head { ball = GameObject.CreatePrimitive(PrimitiveType.Sphere), name = new GameObject("name") };
            head.ball.name = "roomcast person " + person.Name;
            head.ball.transform.SetParent(room, false);
            head.ball.transform.localScale = HeadDiameter * Vector3.one;
            head.material = head.ball.GetComponent<MeshRenderer>().material;
            head.material.color = new Color32(person.R, person.G, person.B, 255);
            head.name.transform.SetParent(head.ball.transform, false);
            head.name.transform.localPosition = new Vector3(0, NameHeight / HeadDiameter, 0);
            TextMesh text = head.name.AddComponent<TextMesh>();
            text.text = person.Name;
            text.characterSize = 0.1f;
            text.anchor = TextAnchor.MiddleCenter;
            return head;
        }

        private void Remove(uint id)
        {
            UnityEngine.Object.Destroy(heads[id].material);
            UnityEngine.Object.Destroy(heads[id].ball);
            heads.Remove(id);
        }
    }
}
