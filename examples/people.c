/* SPDX-License-Identifier: Apache-2.0 */
/* Leaves a note in a room, and prints who is there, what they have left, and who speaks.
 *   cc people.c $(pkg-config --cflags --libs roomcast) -o people && ./people ws://HOST:PORT 10 */
#include <roomcast.h>
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char** argv) {
  char error[256];
  roomcast_options options = {.size = sizeof(options), .name = "people.c", .hears = 1};
  options.hub = argc > 1 ? argv[1] : "ws://127.0.0.1:7600";
  roomcast_viewer* viewer = roomcast_connect(&options, error, sizeof(error));
  const float at[] = {0, 1, 0};
  roomcast_mark note = {.size = sizeof(note), .kind = ROOMCAST_MARK_NOTE, .points = at};
  note.point_count = 1;
  note.text = "people.c was here";
  if (!viewer || !roomcast_leave_mark(viewer, &note, NULL, error, sizeof(error))) {
    fprintf(stderr, "%s\n", error);
    return 1;
  }
  roomcast_people* people = roomcast_wait_people(viewer, NULL, 0);
  roomcast_person person = {.size = sizeof(person)};
  for (size_t i = 0; roomcast_get_person(people, i, &person); ++i)
    printf("%s is %s\n", person.name, person.has_head ? "in the room" : "somewhere");
  for (size_t i = 0; roomcast_get_mark(people, i, &note); ++i)
    printf("%s left \"%s\" at %.1f, %.1f, %.1f m\n", note.author, note.text, note.points[0],
           note.points[1], note.points[2]);
  roomcast_free_people(people);
  roomcast_voice voice = {.size = sizeof(voice)};
  for (int packets = 50 * (argc > 2 ? atoi(argv[2]) : 10); packets > 0; --packets)
    if (roomcast_next_voice(viewer, 20, &voice) && voice.ends)
      printf("person %u has spoken\n", voice.speaker);
  roomcast_disconnect(viewer);
  return 0;
}
