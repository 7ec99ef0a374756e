# SPDX-License-Identifier: BSD-3-Clause
"""Decompositions in other programs' formats."""

import csv
import json
import subprocess

import numpy as np
import pytest
from test_readers import dataset, walk, write_c3d

import stltsa


def test_the_frame_is_the_commands_table(result, walker, command, tmp_path):
    pandas = pytest.importorskip("pandas")
    out = tmp_path / "units.csv"
    subprocess.run([command, "decompose", walker, "-o", out], check=True, capture_output=True)
    expected = pandas.read_csv(out).fillna({"label": ""})
    # Before version 3, pandas rounds some numbers wrongly as it reads them.
    pandas.testing.assert_frame_equal(result.to_frame(), expected, rtol=1e-12, atol=0)


def test_coordinates_on_time_survive_netcdf(result, clip, tmp_path):
    xarray = pytest.importorskip("xarray")
    data = result.to_xarray()
    assert data.sizes["time"] == len(clip)
    cyclic = data.sel(time=data.unit == "cyclic")
    unit = next(u for u in result.unit_list if u.kind == "cyclic")
    assert list(cyclic.frame.values) == list(range(unit.begin, unit.end))
    first = result.cycle_list[0]
    assert list(np.flatnonzero(data.cycle.values == 0)) == list(range(first.begin, first.end))
    assert np.array_equal(data.curve.values[result.frames], result.curve)
    assert data.attrs["stltsa_period"] == result.period
    data.to_netcdf(tmp_path / "walk.nc", engine="scipy")
    with xarray.open_dataset(tmp_path / "walk.nc", engine="scipy") as again:
        assert again.load().equals(data)
        assert {k: v for k, v in again.attrs.items() if v != data.attrs[k]} == {}


def test_a_dataset_keeps_its_data():
    data = dataset()
    result = stltsa.decompose(data, individual="mouse2")
    answer = result.to_xarray(data)
    assert answer.position.identical(data.position.assign_coords(answer.position.coords))
    assert set(answer.coords) - set(data.coords) == {"segment", "label", "unit", "cycle"}
    assert answer.attrs["fps"] == 30
    with pytest.raises(ValueError, match="300 frames"):
        result.to_xarray(data.isel(time=slice(10)))


def test_bids(result, tmp_path):
    path = tmp_path / "sub-01_task-walk_events.tsv"
    result.save_events(path)
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file, delimiter="\t"))
    columns = json.loads(path.with_suffix(".json").read_text())
    assert list(rows[0]) == list(columns)
    assert [float(r["onset"]) for r in rows] == sorted(float(r["onset"]) for r in rows)
    cycles = [r for r in rows if r["level"] == "cycle"]
    assert [float(r["onset"]) for r in cycles] == [c.begin_s for c in result.cycle_list]
    assert [float(r["duration"]) for r in cycles] == [c.duration_s for c in result.cycle_list]
    assert all(r["likeness"] == "n/a" for r in rows if r["level"] == "unit")


def test_boris(result, tmp_path):
    path = tmp_path / "walk.csv"
    result.save_events(path)
    with path.open(newline="") as file:
        rows = [r for r in csv.DictReader(file) if r["Behavioral category"] == "cycle"]
    times = {w: [float(r["Time"]) for r in rows if r["Behavior type"] == w] for w in
             ("START", "STOP")}  # fmt: skip
    assert times["START"] == [c.begin_s for c in result.cycle_list]
    assert times["STOP"] == [c.end_s for c in result.cycle_list]
    # A state event stops before it starts again.
    kinds = [r["Behavior type"] for r in rows]
    assert kinds == ["START", "STOP"] * len(result.cycle_list)


def test_names_that_a_spreadsheet_would_evaluate(walker, tmp_path):
    clip = tmp_path / "=1+1.bvh"
    clip.symlink_to(walker)
    stltsa.decompose(clip).save_events(tmp_path / "walk.csv")
    assert "\n'=1+1,'=1+1.bvh,120.0," in (tmp_path / "walk.csv").read_text()


def test_events_in_c3d(tmp_path):
    source = write_c3d(tmp_path / "walk.c3d", walk(), first=200, events=[(0, 2.5, "Left", "Own")])
    result = stltsa.decompose(stltsa.read_clip(source))
    made = tmp_path / "marked.c3d"
    result.save_events(made)
    again = stltsa.read_clip(made)
    assert again.events[0].label in ("Own", "segment A")
    assert "Own" in [event.label for event in again.events]
    cycles = [event.seconds for event in again.events if event.label == "cycle"]
    assert cycles == pytest.approx([c.begin_s for c in result.cycle_list], abs=1e-4)
    last = [event.seconds for event in again.events if event.label == "cycle end"]
    assert last == pytest.approx([result.cycle_list[-1].end_s], abs=1e-4)
    assert again.features("raw") == pytest.approx(
        stltsa.read_clip(source).features("raw"), nan_ok=True
    )


def test_found_events_keep_their_sides(result, tmp_path):
    found = {"Left Foot Strike": result.phase().events(250, name="Left Foot Strike")}
    result.save_events(tmp_path / "x_events.tsv", events=found)
    with (tmp_path / "x_events.tsv").open(newline="") as file:
        rows = [r for r in csv.DictReader(file, delimiter="\t") if r["level"] == "event"]
    assert [float(r["onset"]) for r in rows] == [e.seconds for e in found["Left Foot Strike"]]
    assert {(r["trial_type"], r["side"]) for r in rows} == {("Left Foot Strike", "left")}
    result.save_events(tmp_path / "x.csv", events=found)
    with (tmp_path / "x.csv").open(newline="") as file:
        rows = [r for r in csv.DictReader(file) if r["Behavior type"] == "POINT"]
    assert {(r["Behavior"], r["Comment"]) for r in rows} == {("Left Foot Strike", "left")}
    assert len(rows) == len(found["Left Foot Strike"])


def test_found_events_in_c3d_have_contexts(tmp_path):
    strike = (0, 2.5, "Left", "Foot Strike")
    source = write_c3d(tmp_path / "walk.c3d", walk(), first=200, events=[strike])
    clip = stltsa.read_clip(source)
    result = stltsa.decompose(clip)
    found = result.phase().events_like(clip.events)
    result.save_events(tmp_path / "found.c3d", events=found)
    again = stltsa.read_clip(tmp_path / "found.c3d").events
    strikes = [e.seconds for e in again if (e.context, e.label) == ("Left", "Foot Strike")]
    expected = [e.seconds for e in found["Left Foot Strike"]]
    assert len(expected) > 2
    assert strikes == pytest.approx(expected, abs=1e-4)


def test_a_stretch_as_c3d_keeps_its_events_unit_and_axis(tmp_path):
    ezc3d = pytest.importorskip("ezc3d")
    values = np.concatenate([walk(), walk()[:, :4] + 1000], axis=1)
    values[150:160, 2] = np.nan
    events = [(0, 2.5, "Left", "Foot Strike"), (0, 3.5, "", "Start"), (0, 5.5, "", "Later")]
    names = [f"m{i}" for i in range(9)]
    source = write_c3d(tmp_path / "walk.c3d", values, first=200, events=events, names=names)
    file = ezc3d.c3d(str(source))
    file.add_parameter("POINT", "Y_SCREEN", ["+Z"])
    file["parameters"]["POINT"]["UNITS"]["value"] = ["mm"]
    file.write(str(source))
    part = stltsa.read_clip(f"{source}:0.2s-2s")
    part.save(tmp_path / "part.c3d")
    again = stltsa.read_clip(tmp_path / "part.c3d")
    assert (len(again), again.fps) == (180, 100)
    for name in ("channel", "length_unit", "file_up_axis"):
        assert again.facts[name] == part.facts[name]
    assert (again.facts["length_unit"], again.facts["up_axis"]) == ("mm", "z")
    assert [e[:2] for e in again.events] == [("Foot Strike", "Left"), ("Start", "")]
    assert [e.seconds for e in again.events] == pytest.approx([0.3, 1.3], abs=1e-4)
    for clip in (part, again):
        clip.save(tmp_path / f"{len(list(tmp_path.iterdir()))}.npy")
    one, two = (np.load(path) for path in sorted(tmp_path.glob("*.npy")))
    np.testing.assert_array_equal(one, two)


def test_clips_that_c3d_cannot_hold(clip, tmp_path):
    plane = stltsa.Clip.from_points(walk()[:, :, :2], 100)
    for wrong in (clip, stltsa.Clip.from_array(walk()[:, 0], 100), plane):
        with pytest.raises(stltsa.UnsupportedError, match="holds points in space"):
            wrong.save(tmp_path / "walk.c3d")
    assert list(tmp_path.iterdir()) == []


def test_events_in_c3d_without_contexts(tmp_path):
    ezc3d = pytest.importorskip("ezc3d")
    source = write_c3d(tmp_path / "walk.c3d", walk())
    for used in (0, 1):
        file = ezc3d.c3d(str(source))
        file["parameters"]["EVENT"] = {"__METADATA__": {"DESCRIPTION": "", "IS_LOCKED": False}}
        file.add_parameter("EVENT", "USED", [used])
        if used:
            file.add_parameter("EVENT", "LABELS", ["Own"])
            file.add_parameter("EVENT", "TIMES", np.array([[0.0], [1.5]]))
        bare = tmp_path / "bare.c3d"
        file.write(str(bare))
        result = stltsa.decompose(bare)
        result.save_events(tmp_path / "marked.c3d")
        labels = [event.label for event in stltsa.read_clip(tmp_path / "marked.c3d").events]
        assert labels.count("cycle") == len(result.cycle_list)
        assert labels.count("Own") == used


def test_events_that_cannot_be_written(result, tmp_path):
    with pytest.raises(ValueError, match=r"must be \.tsv"):
        result.save_events(tmp_path / "walk.txt")
    with pytest.raises(ValueError, match="give source="):
        result.save_events(tmp_path / "walk.c3d")
    unknown = stltsa.decompose(walk()[:, 0])
    with pytest.raises(ValueError, match="give fps="):
        unknown.save_events(tmp_path / "walk.tsv")
    with pytest.raises(FileNotFoundError, match=f"no such folder: .*{tmp_path.name}/nodir'"):
        result.save_events(tmp_path / "nodir" / "x_events.tsv")
    assert list(tmp_path.iterdir()) == []


def test_a_name_with_a_tab_stays_one_cell_of_a_bids_table(result, tmp_path):
    path = tmp_path / "walk_events.tsv"
    result.save_events(path, events={"heel\tstrike  of\nA": result.phase().events(250)})
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file, delimiter="\t"))
    assert "heel strike  of A" in {row["trial_type"] for row in rows}
    assert all(None not in row.values() for row in rows)
