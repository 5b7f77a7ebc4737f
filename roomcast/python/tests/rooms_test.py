# SPDX-License-Identifier: Apache-2.0
"""Live rooms: watching one, and being a sensor of one."""
import signal
import threading
import time
import wave

import numpy as np

import roomcast
from support import HEIGHT, WIDTH, TestCase, color, depth_mm, room_from_sensor, run_program, run_python, start_python

CAMERA = roomcast.Intrinsics(width=WIDTH, height=HEIGHT, fx=60, fy=60, cx=31.5, cy=23.5)
NOBODY = "ws://127.0.0.1:1"
CLOCK_ERROR_NS = 200_000_000  # a busy machine answers late while a sensor asks for the room's time


class Sending:
    """A sensor that sends `pictures` in turn from a thread of its own."""

    def __init__(self, test, url, name="s0", number=0, **options):
        self.sensor = roomcast.Sensor(
            url, name, CAMERA, room_from_sensor=room_from_sensor(number), depth_mode="lossless", **options
        )
        self.number, self.reports, self.ends = number, [], threading.Event()
        self.thread = threading.Thread(target=self.run)
        self.thread.start()
        test.addCleanup(self.end)

    def run(self):
        i = 0
        while not self.ends.wait(0.05):
            self.reports.append(self.sensor.send(depth_mm(self.number, i % 4), color(self.number)))
            i += 1

    def end(self):
        self.ends.set()
        self.thread.join()
        self.sensor.close()


class Rooms(TestCase):
    def setUp(self):
        self.url = self.start_hub()

    def test_what_a_sensor_sends_arrives(self):
        begin = time.time_ns()
        sending = [Sending(self, self.url, f"s{n}", n) for n in range(2)]
        truth = [[depth_mm(n, i).tobytes() for i in range(4)] for n in range(2)]
        with roomcast.watch(self.url) as room:
            for frames in room:
                if frames.complete and len(frames) == 2:
                    break
            self.assertEqual(sorted(sensor.name for sensor in room.sensors), ["s0", "s1"])
            self.assertIsNone(room.problem)
            self.assertTrue(room.may_export and room.may_record)
        for n in range(2):
            frame = frames[f"s{n}"]
            self.assertIn(frame.depth.tobytes(), truth[n])
            self.assertLess(abs(frame.color.astype(int) - color(n)).max(), 12)
            np.testing.assert_allclose(frame.room_from_sensor, room_from_sensor(n), atol=1e-12)
            self.assertEqual(frame.intrinsics, CAMERA)
            self.assertLess(begin - CLOCK_ERROR_NS, frame.time_ns)
            self.assertLess(frame.time_ns, time.time_ns() + CLOCK_ERROR_NS)
        self.assertGreater(len(frames.points()), 1000)
        for one in sending:
            self.assertTrue(any(report.sent for report in one.reports))

    def test_gives_each_set_once_and_newer_ones_later(self):
        Sending(self, self.url)
        with roomcast.watch(self.url) as room:
            sets = [room.newest(timeout_s=10) for _ in range(5)]
        numbers, times = [frames.number for frames in sets], [frames.time_ns for frames in sets]
        self.assertEqual(numbers, sorted(set(numbers)))
        self.assertEqual(times, sorted(set(times)))

    def test_waits_no_longer_than_it_is_told(self):
        with roomcast.watch(self.url) as room:
            begin = time.monotonic()
            self.assertIsNone(room.newest(timeout_s=0.3))
            self.assertLess(time.monotonic() - begin, 5)
            self.assertIsNone(room.newest(timeout_s=0))
            with self.assertRaisesRegex(roomcast.Error, "timeout_s"):
                room.newest(timeout_s=-1)

    def test_arrays_outlive_the_room(self):
        Sending(self, self.url)
        with roomcast.watch(self.url) as room:
            depth = next(room)[0].depth
        with self.assertRaisesRegex(roomcast.Error, "closed"):
            room.newest()
        self.assertIn(depth.tobytes(), [depth_mm(0, i).tobytes() for i in range(4)])

    def test_closing_ends_the_loop_of_another_thread(self):
        room, seen = roomcast.watch(self.url), []
        thread = threading.Thread(target=lambda: seen.append(list(room)))
        thread.start()
        time.sleep(0.2)
        room.close()
        thread.join(10)
        self.assertEqual(seen, [[]])

    def test_others_run_while_one_waits(self):
        with roomcast.watch(self.url) as room:
            thread = threading.Thread(target=lambda: room.newest(timeout_s=1))
            thread.start()
            begin, counted = time.monotonic(), 0
            while thread.is_alive():
                counted += 1
                time.sleep(0.01)
            self.assertGreater(counted, 20)
            self.assertGreater(time.monotonic() - begin, 0.5)

    def test_tells_that_the_connection_is_broken_and_goes_on(self):
        with roomcast.watch(self.url) as room:
            self.assertIsNone(room.problem)
            self.hub.stop()
            while room.problem is None:
                time.sleep(0.05)
            self.assertRegex(room.problem, r"\w+ \w+")

    def test_a_room_that_may_not_be_exported_writes_no_file(self):
        config = self.folder() / "roomcast.toml"
        rights = "send = 'anyone'\nview = 'anyone'\nrecord = 'anyone'\nexport = 'admin'\n"
        config.write_text("[[room]]\nname = 'room'\n" + rights)
        url = self.start_hub("--config", config)
        Sending(self, url)
        with roomcast.watch(url) as room:
            self.assertFalse(room.may_export)
            cloud = next(room).points()
            with self.assertRaisesRegex(roomcast.Error, "does not let viewers export"):
                cloud.write_ply(self.folder() / "a.ply")
        file = self.folder() / "room.mcap"
        run_program("record", file, "--hub", url, "--seconds", 1)
        with roomcast.open(file) as recording:
            self.assertFalse(recording.may_be_exported)
            with self.assertRaisesRegex(roomcast.Error, "did not let viewers export"):
                next(iter(recording)).points().write_ply(self.folder() / "a.ply")


HEAD = np.array([[1, 0, 0, 0.5], [0, 1, 0, 1.5], [0, 0, 1, 2], [0, 0, 0, 1.0]])


class People(TestCase):
    def setUp(self):
        self.url = self.start_hub()
        self.ada = self.enterContext(roomcast.watch(self.url, name="Ada"))
        self.ben = self.enterContext(roomcast.watch(self.url, name="Ben", hears=True))

    def enterContext(self, context):  # unittest has it since 3.11
        self.addCleanup(context.__exit__, None, None, None)
        return context.__enter__()

    def until(self, what):
        end = time.monotonic() + 10
        while not what():
            self.assertLess(time.monotonic(), end)
            time.sleep(0.02)

    def seen(self, name):
        return next((person for person in self.ben.people if person.name == name), None)

    def test_see_each_others_heads(self):
        def arrived():
            self.ada.send_pose(HEAD, room_from_right_hand=HEAD)
            return self.seen("Ada") and self.seen("Ada").room_from_head is not None

        self.until(arrived)
        np.testing.assert_allclose(self.seen("Ada").room_from_head, HEAD, atol=1e-6)
        self.assertIsNone(self.seen("Ada").room_from_left_hand)
        self.assertIsNotNone(self.seen("Ada").room_from_right_hand)
        self.assertEqual([person.is_self for person in sorted(self.ben.people, key=lambda p: p.name)], [False, True])
        self.assertEqual(len(self.seen("Ada").color), 3)
        with self.assertRaisesRegex(roomcast.Error, "room_from_head is not a matrix"):
            self.ada.send_pose(HEAD[:3])

    def test_leave_marks_and_remove_them(self):
        self.assertTrue(self.ada.may_mark)
        id = self.ada.leave_mark("distance", [[0, 1, 0], [0, 1, 2]])
        self.until(lambda: self.ben.marks)
        (mark,) = self.ben.marks
        self.assertEqual((mark.id, mark.kind, mark.text, mark.author, mark.own), (id, "distance", "", "Ada", False))
        np.testing.assert_array_equal(mark.points, np.float32([[0, 1, 0], [0, 1, 2]]))
        self.assertTrue(self.ada.marks[0].own)
        with self.assertRaisesRegex(roomcast.Error, "only its author"):
            self.ben.remove_mark(id)
        self.ada.remove_mark(id)
        self.until(lambda: not self.ben.marks)
        for kind, points, text in [("line", [[0, 0, 0]], ""), ("note", [0, 0, 0], "x"), ("note", [[0, 0, 0]], "")]:
            with self.assertRaises(roomcast.Error):
                self.ada.leave_mark(kind, points, text)

    def test_hear_each_other(self):
        hum = 0.5 * np.sin(2 * np.pi * 440 * np.arange(48_000) / 48_000)
        loudest, packets = 0, 0
        self.assertTrue(self.ada.may_speak)
        self.assertIsNone(self.ben.next_voice(timeout_s=0))
        end = time.monotonic() + 10
        while packets < 20:
            self.assertLess(time.monotonic(), end)
            self.ada.speak(hum[:1920])
            time.sleep(0.04)
            while voice := self.ben.next_voice(timeout_s=0):
                self.assertEqual(voice.speaker, self.seen("Ada").id)
                self.assertTrue(voice.opus and len(voice.samples) == 960 and not voice.ends)
                loudest, packets = max(loudest, voice.samples.max()), packets + 1
        self.assertAlmostEqual(loudest, 0.5, delta=0.15)
        self.ada.pause_speaking()
        self.assertTrue(self.ben.next_voice(timeout_s=10).ends)
        with self.assertRaisesRegex(roomcast.Error, "ahead of time"):
            self.ada.speak(np.zeros(48_001))

    def test_are_recorded_with_what_they_say(self):
        file, voices = self.folder() / "room.mcap", self.folder() / "voices"
        recorder = threading.Thread(target=run_program, args=("record", file, "--hub", self.url, "--seconds", 4))
        recorder.start()
        self.until(lambda: len(self.ben.people) == 3)
        begin, late_s = time.monotonic(), 0
        for i in range(60):  # 2.4 s in real time
            at = np.arange(1920 * i, 1920 * (i + 1)) / 48_000
            self.ada.speak(0.5 * np.sin(2 * np.pi * 440 * at))
            time.sleep(max(0, begin + 0.04 * (i + 1) - time.monotonic()))
            late_s = max(late_s, time.monotonic() - begin - 0.04 * (i + 1))
        self.ada.pause_speaking()
        recorder.join()
        if late_s > 0.15:
            self.skipTest(f"this machine was too busy to speak in real time: {late_s:.2f} s late")
        run_program("export", file, "--format", "wav", "--out", voices)
        with wave.open(str(voices / "voices.wav")) as sound:
            self.assertEqual((sound.getframerate(), sound.getnchannels()), (48_000, 1))
            samples = np.frombuffer(sound.readframes(sound.getnframes()), "<i2") / 32767
        heard = np.flatnonzero(abs(samples) > 0.1)
        middle = samples[heard[0] : heard[-1]][24_000:72_000]
        self.assertAlmostEqual((heard[-1] - heard[0]) / 48_000, 2.4, delta=0.15)
        self.assertAlmostEqual(np.sqrt((middle**2).mean()), 0.5 / np.sqrt(2), delta=0.03)
        self.assertEqual(np.argmax(abs(np.fft.rfft(middle))), 440, "a tone without gaps")

    def test_place_sensors_only_with_an_admins_token(self):
        self.assertFalse(self.ada.may_place)
        with self.assertRaisesRegex(roomcast.Error, "takes an admin's token"):
            self.ada.place("s0", HEAD)
        with self.assertRaisesRegex(roomcast.Error, "takes an admin's token"):
            self.ada.nudge("s0", shift=(0.1, 0, 0), turn_rad=0.1)


class Sensors(TestCase):
    def setUp(self):
        self.url = self.start_hub()

    def sensor(self, **options):
        sensor = roomcast.Sensor(self.url, "s0", CAMERA, **options)
        self.addCleanup(sensor.close)
        return sensor

    def test_tells_what_became_of_frames(self):
        with self.sensor(send_unwatched=True) as sensor:
            self.assertIsNone(sensor.problem)
            reports = []
            until = time.monotonic() + 20
            while sum(report.sent for report in reports) < 10 and time.monotonic() < until:
                reports.append(sensor.send(depth_mm(0, 0)))
                time.sleep(0.05)
        last = reports[-1]
        self.assertTrue(last.connected)
        self.assertEqual(last.frames_sent + last.frames_waiting, sum(report.sent for report in reports))
        self.assertEqual(last.frames_skipped, sum(not report.sent for report in reports))
        self.assertEqual([report.seq is not None for report in reports], [report.sent for report in reports])
        self.assertLessEqual(last.frames_waiting, last.max_frames_waiting)
        self.assertGreater(last.bytes_sent, 0)

    def test_sends_when_somebody_watches(self):
        sensor = self.sensor()
        self.assertTrue(self.send_until(sensor, lambda report: not report.watched))
        self.assertFalse(sensor.send(depth_mm(0, 0)).sent)
        with roomcast.watch(self.url):
            self.assertTrue(self.send_until(sensor, lambda report: report.sent and report.watched))

    def send_until(self, sensor, done):
        until = time.monotonic() + 20
        while time.monotonic() < until:
            if done(sensor.send(depth_mm(0, 0))):
                return True
            time.sleep(0.02)
        return False

    def test_skips_frames_while_the_network_does_not_take_them(self):
        """A hub that is stopped takes nothing: what waits stays bounded, and the sensor goes on."""
        sensor = self.sensor(depth_mode="lossless", send_unwatched=True)
        noise = np.random.default_rng(7).integers(500, 8000, (HEIGHT, WIDTH), np.uint16)
        while not sensor.send(noise).sent:
            time.sleep(0.02)
        self.hub.process.send_signal(signal.SIGSTOP)
        try:
            reports = [sensor.send(noise) for _ in range(3000)]
        finally:
            self.hub.process.send_signal(signal.SIGCONT)
        self.assertFalse(reports[-1].sent)
        self.assertTrue(any(report.frames_waiting == report.max_frames_waiting for report in reports))
        self.assertGreater(reports[-1].frames_skipped, 0)

    def test_refuses_pictures_that_are_wrong(self):
        sensor = self.sensor()
        good = depth_mm(0, 0)
        for sentence, depth, rgb in (
            ("not a NumPy array", good.astype(np.float32), None),
            ("not a NumPy array", good.tolist(), None),
            ("not a NumPy array", None, None),
            ("32 x 24", good[::2, ::2], None),
            ("not a picture", np.zeros((2, 3, 4), np.uint16), None),
            ("color is not a picture", good, np.zeros((HEIGHT, WIDTH, 4), np.uint8)),
            ("color has 48 x 64", good, np.zeros((WIDTH, HEIGHT, 3), np.uint8)),
            ("color is not a NumPy array", good, good),
        ):
            with self.assertRaisesRegex(roomcast.Error, sentence) as caught:
                sensor.send(depth, rgb)
            self.assertEqual(caught.exception.code, "invalid_argument")
        for monotonic_ns in (time.time_ns(), 0, -(2**63), 2**63 - 1):
            with self.assertRaisesRegex(roomcast.Error, "monotonic_ns"):
                sensor.send(good, monotonic_ns=monotonic_ns)
        sensor.send(np.asfortranarray(good), np.zeros((HEIGHT, 2 * WIDTH, 3), np.uint8)[:, ::2])
        sensor.send(good, monotonic_ns=time.monotonic_ns())

    def test_refuses_a_sensor_that_is_none(self):
        for sentence, options in (
            ("4 x 4", {"room_from_sensor": np.eye(3)}),
            ("room_from_sensor", {"room_from_sensor": 2 * np.eye(4)}),
            ("room_from_sensor", {"room_from_sensor": "here"}),
            ("depth_mode", {"depth_mode": "best"}),
            ("color_from_depth", {"color_intrinsics": CAMERA, "color_from_depth": np.zeros((4, 4))}),
            ("color_kbit_per_s", {"color_kbit_per_s": -1}),
            ("bound", {"depth_mode": "near-lossless", "depth_bound_mm": 1000}),
            ("", {"fps": float("nan")}),
        ):
            with self.assertRaisesRegex(roomcast.Error, sentence):
                roomcast.Sensor(self.url, "s0", CAMERA, **options)
        with self.assertRaisesRegex(roomcast.Error, "name"):
            roomcast.Sensor(self.url, "", CAMERA)
        with self.assertRaisesRegex(roomcast.Error, "fx"):
            roomcast.Intrinsics(width=64, height=48, fx=-1, fy=1, cx=0, cy=0)

    def test_registers_colour_of_another_camera(self):
        beside = roomcast.Intrinsics(width=2 * WIDTH, height=2 * HEIGHT, fx=120, fy=120, cx=63.5, cy=47.5)
        sensor = self.sensor(color_intrinsics=beside, color_from_depth=np.eye(4), room_from_sensor=np.eye(4))
        red = np.zeros((2 * HEIGHT, 2 * WIDTH, 3), np.uint8)
        red[..., 0] = 200
        with roomcast.watch(self.url) as room:
            frames = None
            while frames is None or frames[0].color is None:
                sensor.send(depth_mm(0, 0), red)
                frames = room.newest(timeout_s=0.1) or frames
        self.assertEqual(frames[0].color.shape, (HEIGHT, WIDTH, 3))
        self.assertLess(abs(frames[0].color[10:-10, 10:-10].astype(int) - (200, 0, 0)).max(), 12)

    def test_several_threads_may_send(self):
        sensor, reports = self.sensor(), []

        def send():
            reports.extend(sensor.send(depth_mm(0, i)) for i in range(20))

        threads = [threading.Thread(target=send) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(reports), 80)

    def test_a_closed_sensor(self):
        sensor = self.sensor()
        sensor.close()
        with self.assertRaisesRegex(roomcast.Error, "closed"):
            sensor.send(depth_mm(0, 0))


class Absence(TestCase):
    def test_without_a_hub_both_say_so(self):
        for join in (lambda: roomcast.watch(NOBODY), lambda: roomcast.Sensor(NOBODY, "s0", CAMERA)):
            with self.assertRaisesRegex(roomcast.Error, r"127\.0\.0\.1") as caught:
                join()
            self.assertEqual(caught.exception.code, "unavailable")

    def test_an_address_that_is_none(self):
        with self.assertRaises(roomcast.Error) as caught:
            roomcast.watch("http:/nonsense")
        self.assertEqual(caught.exception.code, "invalid_argument")


INTERRUPTED = """
import sys, roomcast
{prepare}
print("waits", flush=True)
try:
    {wait}
except KeyboardInterrupt:
    print("interrupted")
"""


class Interruptions(TestCase):
    def assert_interruptible(self, wait, *args, prepare="pass"):
        program = start_python(INTERRUPTED.format(prepare=prepare, wait=wait), *args)
        self.assertEqual(program.stdout.readline(), "waits\n")
        time.sleep(0.3)
        program.send_signal(signal.SIGINT)
        begin = time.monotonic()
        out, err = program.communicate(timeout=30)
        self.assertEqual((out, err, program.returncode), ("interrupted\n", "", 0))
        return time.monotonic() - begin

    def test_of_waiting_for_frames(self):
        room = f"room = roomcast.watch({self.start_hub()!r})"
        self.assertLess(self.assert_interruptible("room.newest()", prepare=room), 5)
        self.assertLess(self.assert_interruptible("next(room)", prepare=room), 5)

    def test_of_waiting_for_a_hub(self):
        """A hub that is stopped accepts connections, and never answers."""
        url = self.start_hub()
        self.hub.process.send_signal(signal.SIGSTOP)
        self.addCleanup(self.hub.process.send_signal, signal.SIGCONT)
        self.assertLess(self.assert_interruptible(f"roomcast.watch({url!r})"), 5)

    def test_of_the_interpreters_end(self):
        """Rooms and sensors that are still connected, with daemon threads that wait."""
        ended = run_python(
            "import sys, threading, roomcast, numpy\n"
            "room = roomcast.watch(sys.argv[1])\n"
            "camera = roomcast.Intrinsics(width=64, height=48, fx=60, fy=60, cx=31.5, cy=23.5)\n"
            "sensor = roomcast.Sensor(sys.argv[1], 's0', camera)\n"
            "picture = numpy.full((48, 64), 1000, numpy.uint16)\n"
            "def send():\n"
            "    try:\n"
            "        while True: sensor.send(picture)\n"
            "    except roomcast.Error: pass\n"
            "for task in (lambda: list(room), send): threading.Thread(target=task, daemon=True).start()\n"
            "cycle = [room, sensor]; cycle.append(cycle)\n"
            "import time; time.sleep(0.5)\n",
            self.start_hub(),
        )
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))


if __name__ == "__main__":
    import unittest

    unittest.main()
