from __future__ import annotations

import os
from pathlib import Path

import pytest

from rqt_mrta_py.config.files import read_file, read_if_there, write_together, write_whole
from rqt_mrta_py.errors import ConfigError


def test_what_lies_in_the_place_of_the_file_aside_is_not_followed(tmp_path: Path) -> None:
    """Who may write into the folder could else have any file overwritten."""
    treasure = tmp_path / "treasure"
    treasure.write_bytes(b"gold")
    (tmp_path / f".a.json.{os.getpid()}.part").symlink_to(treasure)
    write_whole(tmp_path / "a.json", b"new")
    assert (treasure.read_bytes(), (tmp_path / "a.json").read_bytes()) == (b"gold", b"new")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.json", "treasure"]


def test_a_file_is_replaced_and_nothing_else_is_left(tmp_path: Path) -> None:
    (tmp_path / "a.json").write_bytes(b"old")
    write_whole(tmp_path / "a.json", b"new")
    assert (tmp_path / "a.json").read_bytes() == b"new"
    assert [path.name for path in tmp_path.iterdir()] == ["a.json"]


def test_nothing_half_written_is_left_when_renaming_fails(tmp_path: Path) -> None:
    (tmp_path / "a.json").mkdir()
    with pytest.raises(IsADirectoryError):
        write_whole(tmp_path / "a.json", b"new")
    assert [path.name for path in tmp_path.iterdir()] == ["a.json"]


def test_a_folder_that_is_not_there_is_told(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        write_whole(tmp_path / "nowhere" / "a.json", b"new")


def test_read_file_says_why_it_cannot(tmp_path: Path) -> None:
    with pytest.raises(ConfigError) as caught:
        read_file(tmp_path)

    assert str(caught.value) == f"{tmp_path}: cannot be read: Is a directory"


def test_files_are_written_and_removed_together(tmp_path: Path) -> None:
    (tmp_path / "old.yaml").write_text("a: 1\n")
    (tmp_path / "gone.yaml").write_text("b: 1\n")
    write_together(
        {
            tmp_path / "old.yaml": "a: 2\n",
            tmp_path / "config" / "deep" / "new.yaml": "c: ä\n",
            tmp_path / "gone.yaml": None,
            tmp_path / "never.yaml": None,
        }
    )
    assert {str(path.relative_to(tmp_path)): path.read_text("utf-8") for path in tmp_path.rglob("*.yaml")} == {
        "old.yaml": "a: 2\n",
        "config/deep/new.yaml": "c: ä\n",
    }
    assert sorted(path.name for path in tmp_path.iterdir()) == ["config", "old.yaml"]


def test_nothing_changes_when_one_of_the_files_cannot_be_written(tmp_path: Path) -> None:
    (tmp_path / "a.yaml").write_text("a: 1\n")
    (tmp_path / "taken").mkdir()
    with pytest.raises(ConfigError) as caught:
        write_together(
            {
                tmp_path / "a.yaml": "a: 2\n",
                tmp_path / "new" / "b.yaml": "b: 2\n",
                tmp_path / "taken": "c: 2\n",
            }
        )
    assert str(caught.value) == f"{tmp_path / 'taken'}: cannot be written: Is a directory; nothing was changed"
    assert (tmp_path / "a.yaml").read_text() == "a: 1\n"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.yaml", "taken"]


@pytest.mark.parametrize("failing", [1, 2, 3, 4, 5])
def test_files_are_put_back_when_a_renaming_fails(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, failing: int
) -> None:
    """Five renamings replace two files and make one; each of them fails once."""
    before = {"a": "1", "b": "1"}
    for name, text in before.items():
        (tmp_path / name).write_text(text)
    renamed = Path.replace
    calls = []

    def replace(self: Path, target: Path) -> Path:
        calls.append(target)
        if len(calls) == failing:
            raise OSError(28, "No space left on device")
        return renamed(self, target)

    monkeypatch.setattr(Path, "replace", replace)
    with pytest.raises(ConfigError, match="No space left on device; nothing was changed"):
        write_together({tmp_path / "a": "2", tmp_path / "b": "2", tmp_path / "sub" / "c": "2"})
    assert {path.name: path.read_text() for path in tmp_path.rglob("*") if path.is_file()} == before
    assert not (tmp_path / "sub").exists()


@pytest.mark.parametrize("interrupted", [1, 2, 3, 4, 5])
def test_files_are_put_back_when_somebody_interrupts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, interrupted: int
) -> None:
    """Ctrl-C right behind a renaming, which has been done by then."""
    before = {"a": "1", "b": "1"}
    for name, text in before.items():
        (tmp_path / name).write_text(text)
    renamed = Path.replace
    calls = []

    def replace(self: Path, target: Path) -> Path:
        calls.append(target)
        there = renamed(self, target)
        if len(calls) == interrupted:
            raise KeyboardInterrupt
        return there

    monkeypatch.setattr(Path, "replace", replace)
    with pytest.raises(KeyboardInterrupt):
        write_together({tmp_path / "a": "2", tmp_path / "b": "2", tmp_path / "sub" / "c": "2"})
    assert {path.name: path.read_text() for path in tmp_path.rglob("*") if path.is_file()} == before
    assert not (tmp_path / "sub").exists()


def test_two_links_to_one_file_are_told_and_the_file_stays(tmp_path: Path) -> None:
    """The file was lost, for what had been written first counted as what had been there before."""
    (tmp_path / "one.yaml").write_text("old")
    (tmp_path / "other.yaml").symlink_to("one.yaml")
    with pytest.raises(ConfigError) as caught:
        write_together({tmp_path / "one.yaml": "a", tmp_path / "other.yaml": "b"})
    said = f"cannot be written: it and another of these files are {tmp_path.resolve() / 'one.yaml'}"
    assert str(caught.value) == f"{tmp_path / 'other.yaml'}: {said}; nothing was changed"
    assert sorted((path.name, path.read_text()) for path in tmp_path.iterdir()) == [
        ("one.yaml", "old"),
        ("other.yaml", "old"),
    ]


def test_a_link_to_itself_is_told(tmp_path: Path) -> None:
    (tmp_path / "a.yaml").symlink_to("a.yaml")
    with pytest.raises(
        ConfigError, match=r"a\.yaml: cannot be written: Too many levels of symbolic links; nothing was"
    ):
        write_together({tmp_path / "a.yaml": "a"})


def test_a_link_where_files_are_written_aside_is_not_followed(tmp_path: Path) -> None:
    (tmp_path / "elsewhere").write_text("somebody's own")
    for aside in (".a.yaml.part", f".a.yaml.{os.getpid()}.part"):
        (tmp_path / aside).symlink_to("elsewhere")
    write_together({tmp_path / "a.yaml": "new"})
    assert (tmp_path / "elsewhere").read_text() == "somebody's own"
    assert (tmp_path / "a.yaml").read_text() == "new"
    assert not (tmp_path / "a.yaml").is_symlink()


def test_read_if_there_tells_what_is_missing_from_what_cannot_be_read(tmp_path: Path) -> None:
    (tmp_path / "there").write_bytes(b"x")
    assert read_if_there(tmp_path / "there") == b"x"
    assert read_if_there(tmp_path / "missing" / "file") is None
    assert read_if_there(tmp_path) is None
    with pytest.raises(ConfigError, match="a: cannot be read: File name too long"):
        read_if_there(tmp_path / ("a" * 300))


def test_writing_goes_through_a_link_and_keeps_the_rights_of_the_file(tmp_path: Path) -> None:
    (tmp_path / "source.xml").write_text("old")
    (tmp_path / "source.xml").chmod(0o664)
    (tmp_path / "link.xml").symlink_to(tmp_path / "source.xml")
    write_together({tmp_path / "link.xml": "new"})
    assert (tmp_path / "link.xml").is_symlink()
    assert (tmp_path / "source.xml").read_text() == "new"
    assert (tmp_path / "source.xml").stat().st_mode & 0o777 == 0o664
