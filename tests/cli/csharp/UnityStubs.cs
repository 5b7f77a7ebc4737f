// SPDX-License-Identifier: Apache-2.0
// The classes of Unity that the package uses, without their contents: csharp.test.mjs compiles the component against them.
using System;

namespace UnityEngine
{
    public class Object
    {
        public static void Destroy(Object thing) { }
        public static bool operator ==(Object a, Object b) { return ReferenceEquals(a, b); }
        public static bool operator !=(Object a, Object b) { return !ReferenceEquals(a, b); }
        public override bool Equals(object other) { return ReferenceEquals(this, other); }
        public override int GetHashCode() { return 0; }
    }
    public class Component : Object { public Transform transform; }
    public class Camera : Component { public static Camera main; }
    public class MonoBehaviour : Component { }
    public class GameObject : Object
    {
        public GameObject(string name) { }
        public Transform transform;
        public void SetActive(bool active) { }
        public string name;
        public static GameObject CreatePrimitive(PrimitiveType type) { return new GameObject(""); }
        public T AddComponent<T>() where T : Component, new() { return new T(); }
        public T GetComponent<T>() where T : Component, new() { return new T(); }
    }
    public class Transform : Component
    {
        public Vector3 position, localPosition, localScale;
        public Quaternion rotation;
        public void SetParent(Transform parent, bool worldPositionStays) { }
        public Vector3 InverseTransformPoint(Vector3 point) { return point; }
    }
    public class MeshFilter : Component { public Mesh sharedMesh; }
    public class MeshRenderer : Component { public Material sharedMaterial, material; }
    public enum PrimitiveType { Sphere }
    public class TextMesh : Component { public string text; public float characterSize; public TextAnchor anchor; }
    public enum TextAnchor { MiddleCenter }
    public class AudioSource : Component
    {
        public AudioClip clip;
        public bool loop;
        public float minDistance, spatialBlend;
        public void Play() { }
    }
    public class AudioClip : Object
    {
        public delegate void PCMReaderCallback(float[] data);
        public int frequency, samples;
        public static AudioClip Create(string name, int lengthSamples, int channels, int frequency, bool stream, PCMReaderCallback reader) { return null; }
        public bool GetData(float[] data, int offset) { return true; }
    }
    public static class Microphone
    {
        public static AudioClip Start(string device, bool loop, int seconds, int frequency) { return null; }
        public static int GetPosition(string device) { return 0; }
        public static void End(string device) { }
    }
    public struct Color { }
    public struct Color32
    {
        public Color32(byte r, byte g, byte b, byte a) { }
        public static implicit operator Color(Color32 color) { return new Color(); }
    }
    public static class Application { public static bool isPlaying { get { return false; } } }
    public static class GUILayout { public static bool Button(string text) { return false; } }
    public class Mesh : Object
    {
        public Rendering.IndexFormat indexFormat;
        public Vector3[] vertices;
        public Bounds bounds;
        public void SetTriangles(int[] triangles, int submesh) { }
    }
    public class Shader : Object { public static Shader Find(string name) { return new Shader(); } }
    public class Material : Object
    {
        public Material(Shader shader) { }
        public Color color;
        public void SetVector(string name, Vector4 value) { }
        public void SetFloat(string name, float value) { }
        public void SetMatrix(string name, Matrix4x4 value) { }
        public void SetTexture(string name, Texture value) { }
    }
    public class Texture : Object { public FilterMode filterMode; }
    public class Texture2D : Texture
    {
        public Texture2D(int width, int height, TextureFormat format, bool mipChain, bool linear) { }
        public void LoadRawTextureData(IntPtr data, int size) { }
        public void Apply(bool updateMipmaps) { }
    }
    public enum TextureFormat { R16, RGB24 }
    public enum FilterMode { Point }
    public struct Vector3
    {
        public float x, y, z;
        public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
        public static Vector3 zero { get { return new Vector3(); } }
        public static Vector3 one { get { return new Vector3(1, 1, 1); } }
        public static Vector3 operator *(float factor, Vector3 v) { return new Vector3(factor * v.x, factor * v.y, factor * v.z); }
    }
    public struct Vector4
    {
        public float x, y, z, w;
        public Vector4(float x, float y, float z, float w) { this.x = x; this.y = y; this.z = z; this.w = w; }
    }
    public struct Quaternion
    {
        public static Quaternion Inverse(Quaternion q) { return q; }
        public static Quaternion operator *(Quaternion a, Quaternion b) { return a; }
    }
    public struct Matrix4x4
    {
        public float this[int row, int column] { get { return 0; } set { } }
        public static Matrix4x4 TRS(Vector3 position, Quaternion rotation, Vector3 scale) { return new Matrix4x4(); }
    }
    public struct Bounds { public Bounds(Vector3 center, Vector3 size) { } }
    public class TooltipAttribute : Attribute { public TooltipAttribute(string text) { } }
    public class AddComponentMenu : Attribute { public AddComponentMenu(string path) { } }
}

namespace UnityEngine.Rendering
{
    public enum IndexFormat { UInt16, UInt32 }
}

namespace UnityEditor
{
    public class MenuItem : Attribute { public MenuItem(string path, bool validates, int priority) { } }
    public class CustomEditor : Attribute { public CustomEditor(Type type) { } }
    public enum MessageType { Info, Warning }
    public class Editor : UnityEngine.Object
    {
        public UnityEngine.Object target;
        public virtual void OnInspectorGUI() { }
        public bool DrawDefaultInspector() { return true; }
    }
    public static class EditorGUILayout { public static void HelpBox(string message, MessageType type) { } }
    public static class Selection { public static UnityEngine.GameObject activeGameObject; }
    public static class Undo { public static void RegisterCreatedObjectUndo(UnityEngine.Object thing, string name) { } }
}
