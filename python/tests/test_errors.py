"""Errors have the command line's text."""

import pytest
import vkpt
from conftest import SCENE, Command


def failure(scene: str, **settings: object) -> vkpt.Error:
    with pytest.raises(vkpt.Error) as raised:
        vkpt.render(scene, progress=False, **settings)  # type: ignore[arg-type]
    return raised.value


def test_a_scene_error_has_message_line_and_culprit(command: Command, scene: object) -> None:
    error = failure(SCENE.replace("sphere 0 0 3", "sphere 0 zero 3"))
    assert isinstance(error, vkpt.SceneError) and isinstance(error, ValueError)
    (diagnostic,) = error.diagnostics
    found = (diagnostic.severity, diagnostic.line, diagnostic.column, diagnostic.culprit)
    assert found == ("error", 7, 10, "zero")
    assert diagnostic.message == "`zero` is not a number"
    assert "sphere 0 zero 3" in str(error) and "\x1b" not in str(error)
    assert error.code == 3


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"spp": 0}, ["--spp", "0"]),
        ({"fresnel": "x"}, ["--fresnel", "x"]),
        ({"crop": (0, 0, 50, 10)}, ["--crop", "0,0,50,10"]),
        ({"target_error": -1}, ["--target-error=-1"]),
        ({"denoise": "nlm", "spp": 2}, ["--denoise=nlm", "--spp", "2"]),
        ({"device": "nobody's"}, ["--device", "nobody's"]),
    ],
)
def test_messages_and_codes_are_the_command_lines(
    command: Command, scene: object, settings: dict[str, object], words: list[str]
) -> None:
    run = command("scene.txt", *words)
    error = failure(SCENE, **settings)
    assert error.code == run.returncode
    assert run.stderr.startswith(f"error: {error.messages[0]}"), run.stderr


def test_a_keyword_that_is_not_known_is_a_type_error() -> None:
    with pytest.raises(TypeError, match="unexpected keyword argument 'sp'; did you mean 'spp'"):
        vkpt.render(SCENE, sp=3)  # type: ignore[call-arg]
    for name in ["output", "json", "resume", "samples"]:
        with pytest.raises(TypeError, match=name):
            vkpt.render(SCENE, **{name: "x"})  # type: ignore[arg-type]


def test_warnings_are_pythons() -> None:
    scene = SCENE + "teapot 1 2 3\n"
    with pytest.warns(UserWarning, match=r"<text>:8: unknown command `teapot`") as caught:
        picture = vkpt.render(scene, spp=1, progress=False)
    assert caught[0].filename == vkpt.__file__ or caught[0].filename == __file__
    assert picture.warnings == ["unknown command `teapot`"]
    assert isinstance(failure(scene, strict=True), vkpt.SceneError)


def test_a_file_that_cannot_be_written(tmp_path: object) -> None:
    picture = vkpt.render(SCENE, spp=1, progress=False)
    with pytest.raises(vkpt.FileError, match="cannot write .*nowhere") as raised:
        picture.save(f"{tmp_path}/nowhere/a.exr")
    assert isinstance(raised.value, OSError) and raised.value.code == 5
    with pytest.raises(vkpt.ArgumentError, match="ending must be"):
        picture.save(f"{tmp_path}/a.jpg")
