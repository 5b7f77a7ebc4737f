// SPDX-License-Identifier: Apache-2.0
// The classes of Unity that RoomcastRoom uses, without their contents: csharp.test.mjs compiles the component against them.
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
    public class MonoBehaviour : Component { }
    public class GameObject : Object
    {
        public GameObject(string name) { }
        public Transform transform;
        public void SetActive(bool active) { }
        public T AddComponent<T>() where T : Component, new() { return new T(); }
    }
    public class Transform : Component
    {
        public Vector3 position;
        public Quaternion rotation;
        public void SetParent(Transform parent, bool worldPositionStays) { }
        public Vector3 InverseTransformPoint(Vector3 point) { return point; }
    }
    public class MeshFilter : Component { public Mesh sharedMesh; }
    public class MeshRenderer : Component { public Material sharedMaterial; }
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
