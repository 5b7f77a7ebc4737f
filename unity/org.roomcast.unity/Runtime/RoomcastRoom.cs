// SPDX-License-Identifier: Apache-2.0
// NOT RUN: the tests compile this component against stubs of the editor's classes; no editor was at hand.
//
// Shows a live room below this object: one mesh for each sensor, whose vertices the shader moves to the sensor's readings, and the
// heads and voices of the people there.
// Unity is left-handed: z of the room's world changes its sign, so the room is not mirrored.
using System.Collections.Generic;
using System.Threading;
using UnityEngine;
using UnityEngine.Rendering;

namespace Roomcast.Unity
{
    [AddComponentMenu("roomcast/Room")]
    public sealed class RoomcastRoom : MonoBehaviour
    {
        [Tooltip("ws://host:port, or wss://host:port#sha256=...")]
        public string hub = "ws://127.0.0.1:7600";
        [Tooltip("Empty: the hub's only room")]
        public string room = "";
        [Tooltip("If the room requires one")]
        public string token = "";
        [Tooltip("Shown to the others in the room")]
        public string viewerName = "Unity";
        [Tooltip("roomcast/Depth Mesh")]
        public Shader shader;
        [Tooltip("The others see this viewer here; empty: not at all")]
        public Transform head;
        [Tooltip("Show the heads of the others, with their names")]
        public bool showPeople = true;
        [Tooltip("Play the voices of the others from where they stand")]
        public bool hear = true;
        [Tooltip("Say to the others what the microphone hears")]
        public bool speak;

        /// Why nothing is shown; null while all is well.
        public string Problem { get; private set; }

        private sealed class Surface
        {
            public GameObject thing;
            public Material material;
            public Mesh mesh;
            public Texture2D depth, color;
            public int width, height;
            public uint seq;
            public bool shown;
        }

        private readonly Dictionary<string, Surface> surfaces = new Dictionary<string, Surface>();
        private readonly object handover = new object();
        private Thread receiver;
        private volatile bool ended;
        private Frames newest;    // guarded by handover
        private string problem;   // guarded by handover
        private double[] headPose; // guarded by handover
        private Person[] newestPeople; // guarded by handover
        private RoomcastPeople people;
        private RoomcastVoices voices;

        private void OnEnable()
        {
            ended = false;
            people = new RoomcastPeople(transform);
            voices = new RoomcastVoices(transform);
            receiver = new Thread(Receive) { IsBackground = true, Name = "roomcast" };
            receiver.Start();
        }

        private void OnDisable()
        {
            ended = true;
            receiver.Join();
            lock (handover)
            {
                if (newest != null) newest.Dispose();
                newest = null;
            }
            foreach (Surface surface in surfaces.Values) Remove(surface);
            surfaces.Clear();
            people.Clear();
            voices.Clear();
        }

        /// The receiver's thread: the newest frames replace those that were not drawn.
        private void Receive()
        {
            try
            {
                var options = new RoomOptions { Hub = hub, Room = NullIfEmpty(room), Token = NullIfEmpty(token), Name = viewerName, Hears = hear };
                using (Room joined = Room.Connect(options))
                using (voices.Join(joined, hear))
                {
                    while (!ended)
                    {
                        Frames frames = joined.WaitFrames(50);
                        string why = joined.Problem;
                        Person[] persons = null;
                        using (People now = joined.WaitPeople())
                        {
                            if (now != null) persons = Others(now);
                        }
                        double[] pose;
                        lock (handover)
                        {
                            problem = why;
                            pose = headPose;
                            if (persons != null) newestPeople = persons;
                            if (frames != null)
                            {
                                if (newest != null) newest.Dispose();
                                newest = frames;
                            }
                        }
                        if (pose != null) joined.SendPose(pose);
                    }
                }
            }
            catch (RoomcastException failure)
            {
                lock (handover) problem = failure.Message;
            }
        }

        private void Update()
        {
            Frames frames;
            lock (handover)
            {
                Problem = problem;
                frames = newest;
                newest = null;
                headPose = head == null ? null : RoomFromHead();
                if (newestPeople != null && showPeople) people.Show(newestPeople);
                if (newestPeople != null) voices.Place(newestPeople);
                newestPeople = null;
            }
            voices.Update(speak);
            if (frames == null) return;
            using (frames)
            {
                foreach (Surface surface in surfaces.Values) surface.shown = false;
                for (int i = 0; i < frames.Count; ++i) Show(frames[i]);
            }
            foreach (Surface surface in surfaces.Values) surface.thing.SetActive(surface.shown);
        }

        private void Show(SensorFrame sensor)
        {
            Surface surface;
            if (surfaces.TryGetValue(sensor.Name, out surface) && (surface.width != sensor.Width || surface.height != sensor.Height))
            {
                Remove(surface);
                surfaces.Remove(sensor.Name);
                surface = null;
            }
            if (surface == null) surfaces[sensor.Name] = surface = Make(sensor);
            surface.shown = sensor.Placed;
            if (surface.seq == sensor.Seq) return;
            surface.seq = sensor.Seq;
            surface.depth.LoadRawTextureData(sensor.DepthMm, 2 * sensor.Width * sensor.Height);
            surface.depth.Apply(false);
            if (sensor.HasColor)
            {
                surface.color.LoadRawTextureData(sensor.ColorRgb, 3 * sensor.Width * sensor.Height);
                surface.color.Apply(false);
            }
            Material material = surface.material;
            material.SetVector("_Intrinsics", new Vector4((float)sensor.Fx, (float)sensor.Fy, (float)sensor.Cx, (float)sensor.Cy));
            double[] d = sensor.Distortion;
            material.SetVector("_Distortion", new Vector4((float)d[0], (float)d[1], (float)d[3], (float)d[4]));
            material.SetFloat("_K3", (float)d[2]);
            material.SetMatrix("_RoomFromDepth", LeftHanded(sensor.WorldFromDepth));
        }

        private Surface Make(SensorFrame sensor)
        {
            var surface = new Surface
            {
                thing = new GameObject("roomcast " + sensor.Name),
                material = new Material(shader != null ? shader : Shader.Find("roomcast/Depth Mesh")),
                mesh = Grid(sensor.Width, sensor.Height),
                depth = new Texture2D(sensor.Width, sensor.Height, TextureFormat.R16, false, true),
                color = new Texture2D(sensor.Width, sensor.Height, TextureFormat.RGB24, false, false),
                width = sensor.Width,
                height = sensor.Height,
                seq = sensor.Seq - 1,
            };
            surface.depth.filterMode = FilterMode.Point;
            surface.material.SetTexture("_Depth", surface.depth);
            surface.material.SetTexture("_Color", surface.color);
            surface.material.SetVector("_Size", new Vector4(sensor.Width, sensor.Height, 0, 0));
            surface.thing.transform.SetParent(transform, false);
            surface.thing.AddComponent<MeshFilter>().sharedMesh = surface.mesh;
            surface.thing.AddComponent<MeshRenderer>().sharedMaterial = surface.material;
            return surface;
        }

        /// A vertex for each pixel, whose place is its pixel; two triangles between four of them.
        private static Mesh Grid(int width, int height)
        {
            var vertices = new Vector3[width * height];
            for (int i = 0; i < vertices.Length; ++i) vertices[i] = new Vector3(i % width, i / width, 0);
            var triangles = new int[6 * (width - 1) * (height - 1)];
            int at = 0;
            for (int y = 0; y + 1 < height; ++y)
            {
                for (int x = 0; x + 1 < width; ++x)
                {
                    int a = y * width + x, b = a + 1, c = a + width, d = c + 1;
                    foreach (int corner in new[] { a, b, c, b, d, c }) triangles[at++] = corner;
                }
            }
            var mesh = new Mesh { indexFormat = IndexFormat.UInt32 };
            mesh.vertices = vertices;
            mesh.SetTriangles(triangles, 0);
            mesh.bounds = new Bounds(Vector3.zero, 100 * Vector3.one); // the shader moves the vertices
            return mesh;
        }

        private static void Remove(Surface surface)
        {
            Destroy(surface.thing);
            Destroy(surface.material);
            Destroy(surface.mesh);
            Destroy(surface.depth);
            Destroy(surface.color);
        }

        /// Points of a sensor into Unity's world: the room's, with z of the other sign.
        internal static Matrix4x4 LeftHanded(double[] worldFromDepth)
        {
            var matrix = new Matrix4x4();
            for (int i = 0; i < 16; ++i) matrix[i / 4, i % 4] = (float)(i / 4 == 2 ? -worldFromDepth[i] : worldFromDepth[i]);
            return matrix;
        }

        /// The head's pose in the room: x right, y up, z backwards. Changing the sign of z on both sides makes it right-handed.
        private double[] RoomFromHead()
        {
            Matrix4x4 pose = Matrix4x4.TRS(
                transform.InverseTransformPoint(head.position), Quaternion.Inverse(transform.rotation) * head.rotation, Vector3.one);
            var numbers = new double[16];
            for (int i = 0; i < 16; ++i) numbers[i] = ((i / 4 == 2) != (i % 4 == 2) ? -1 : 1) * pose[i / 4, i % 4];
            return numbers;
        }

        private static Person[] Others(People people)
        {
            var others = new List<Person>();
            for (int i = 0; i < people.PersonCount; ++i)
            {
                Person person = people.GetPerson(i);
                if (!person.IsSelf) others.Add(person);
            }
            return others.ToArray();
        }

        private static string NullIfEmpty(string text)
        {
            return string.IsNullOrEmpty(text) ? null : text;
        }
    }
}
