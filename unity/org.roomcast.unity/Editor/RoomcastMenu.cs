// SPDX-License-Identifier: Apache-2.0
// NOT RUN: the tests compile this against stubs of the editor's classes; no editor was at hand.
//
// In the editor: GameObject > roomcast > Room puts a room into the scene, with its shader and the main camera as head. The
// inspector shows what goes wrong while it plays, and looks without playing whether the hub answers.
using UnityEditor;
using UnityEngine;

namespace Roomcast.Unity
{
    internal static class RoomcastMenu
    {
        [MenuItem("GameObject/roomcast/Room", false, 10)]
        private static void AddRoom()
        {
            var thing = new GameObject("roomcast room");
            RoomcastRoom room = thing.AddComponent<RoomcastRoom>();
            room.shader = Shader.Find("roomcast/Depth Mesh");
            if (UnityEngine.Camera.main != null) room.head = UnityEngine.Camera.main.transform;
            Undo.RegisterCreatedObjectUndo(thing, "Add a roomcast room");
            Selection.activeGameObject = thing;
        }
    }

    [CustomEditor(typeof(RoomcastRoom))]
    internal sealed class RoomcastRoomInspector : Editor
    {
        private string answer;

        public override void OnInspectorGUI()
        {
            DrawDefaultInspector();
            var room = (RoomcastRoom)target;
            if (Application.isPlaying)
            {
                if (room.Problem != null) EditorGUILayout.HelpBox(room.Problem, MessageType.Warning);
                return;
            }
            if (GUILayout.Button("Look whether the hub answers")) answer = Ask(room);
            if (answer != null) EditorGUILayout.HelpBox(answer, MessageType.Info);
        }

        private static string Ask(RoomcastRoom room)
        {
            try
            {
                var options = new RoomOptions
                {
                    Hub = room.hub, Name = room.viewerName,
                    Room = string.IsNullOrEmpty(room.room) ? null : room.room,
                    Token = string.IsNullOrEmpty(room.token) ? null : room.token,
                };
                using (Room joined = Room.Connect(options))
                using (Frames frames = joined.WaitFrames(2000))
                {
                    return frames == null
                        ? "The hub answers; no sensor has sent anything within two seconds."
                        : "The hub answers; " + frames.RoomSensorCount + " sensors are sending.";
                }
            }
            catch (RoomcastException failure)
            {
                return failure.Message;
            }
        }
    }
}
