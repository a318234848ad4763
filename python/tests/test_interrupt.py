"""Ctrl-c ends a rendering with the samples done."""

import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
import vkpt
from conftest import SCENE

PROGRAM = """
import sys, vkpt
picture = vkpt.render(sys.argv[1], time=60, progress=lambda *_: print("goes on", flush=True))
print(picture.ended, picture.spp > 0, picture.rgb.shape)
"""

GROWING = """
import sys, vkpt
for picture in vkpt.progressive(sys.argv[1], time=60, pause=0.1):
    print(picture.ended, flush=True)
"""


def interrupted(program: str, *words: str) -> str:
    """The output of a program that is interrupted after its first line."""
    # A shell that runs this in the background may ignore ctrl-c, and the program would inherit that.
    usual = signal.signal(signal.SIGINT, signal.default_int_handler)
    process = subprocess.Popen([sys.executable, "-c", program, *words], stdout=subprocess.PIPE, text=True)
    signal.signal(signal.SIGINT, usual)
    assert process.stdout is not None
    process.stdout.readline()
    started = time.monotonic()
    process.send_signal(signal.SIGINT)
    out, _ = process.communicate(timeout=30)
    assert process.returncode == 0
    assert time.monotonic() - started < 20
    return out.splitlines()[-1]


def test_a_rendering_returns_what_is_there(scene: Path) -> None:
    assert interrupted(PROGRAM, str(scene)) == "interrupted True (30, 40, 3)"


def test_ctrl_c_may_arrive_in_the_progress_callback() -> None:
    def press(*_: object) -> None:
        signal.raise_signal(signal.SIGINT)

    usual = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        picture = vkpt.render(SCENE, time=60, progress=press)
    finally:
        signal.signal(signal.SIGINT, usual)
    assert (picture.ended, picture.spp > 0) == ("interrupted", True)


def test_pictures_that_grow_end_with_what_is_there(scene: Path) -> None:
    assert interrupted(GROWING, str(scene)) == "interrupted"


def test_pictures_grow_to_the_one_that_is_rendered_at_once() -> None:
    pictures = list(vkpt.progressive(SCENE, spp=2000, pause=0.05, device="cpu-f32"))
    assert len(pictures) >= 2
    samples = [picture.spp for picture in pictures]
    assert samples == sorted(set(samples)) and samples[-1] == 2000
    assert [picture.ended for picture in pictures[:-1]] == [None] * (len(pictures) - 1)
    whole = vkpt.render(SCENE, spp=2000, device="cpu-f32", progress=False)
    assert pictures[-1].rgb.tobytes() == whole.rgb.tobytes()
    # Each is the picture with that many samples.
    first = vkpt.render(SCENE, spp=samples[0], device="cpu-f32", progress=False)
    assert pictures[0].rgb.tobytes() == first.rgb.tobytes()


def test_other_threads_run_meanwhile() -> None:
    ticks = []

    def tick(*_: object) -> None:
        ticks.append(time.monotonic())

    import threading

    stop = threading.Event()

    def count() -> None:
        while not stop.wait(0.01):
            tick()

    thread = threading.Thread(target=count)
    thread.start()
    vkpt.render(SCENE, time=1, progress=False)
    stop.set()
    thread.join()
    assert len(ticks) > 10, "the GIL is released"


def test_a_loop_that_is_left_ends_the_rendering() -> None:
    started = time.monotonic()
    for picture in vkpt.progressive(SCENE, time=60, pause=0):
        assert picture.spp > 0
        break
    assert time.monotonic() - started < 20


def test_errors_arrive_where_the_loop_is() -> None:
    with pytest.raises(vkpt.SceneError):
        list(vkpt.progressive("screen 1\n"))
    with pytest.raises(vkpt.ArgumentError, match="pause"):
        list(vkpt.progressive(SCENE, pause=-1))
