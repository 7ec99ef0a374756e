# SPDX-License-Identifier: BSD-3-Clause
"""Facts by name agree with the properties and the JSON."""

import json

import numpy as np

import stltsa
from stltsa import _facts, _rows
from stltsa._native import ffi, lib


def test_facts_of_a_clip(clip, walker):
    facts = clip.facts
    assert facts["path"] == (str(walker),)
    assert facts["format"] == ("bvh",)
    assert facts["clip_frames"] == (len(clip),)
    assert len(facts["channel"]) == clip.channels
    assert "neighbors" not in facts


def test_facts_of_a_model(model):
    facts = model.facts
    assert (facts["neighbors"], facts["window"]) == (model.neighbors, model.window)
    assert (facts["mode"], facts["features"]) == (model.mode, "positions")
    assert [component.residual for component in facts["component"]] == [model.residual]
    assert tuple(warning.text for warning in facts["warning"]) == model.warnings
    parameters = json.loads(model.to_json())["parameters"]
    assert facts["include_self"] == int(parameters["include_self"])


def test_lists_are_those_of_the_header(circle):
    keys = {key.name for key in _facts._KEYS.values() if key.type == lib.STLTSA_TYPE_ROWS}
    assert set(_rows.LISTS) == keys
    for struct, kind in _rows.LISTS.values():
        members = {name for name, _ in ffi.typeof(struct).fields}
        assert all(name in members or _rows.IN_C[name] in members for name in kind._fields)
    warnings = stltsa.fit(circle, neighbors=5).facts["warning"]
    assert "follows-time" in [warning.code for warning in warnings]
    assert np.isnan(warnings[0].begin_s)


def test_facts_of_results(clip, model, result, circle):
    assert result.facts["cyclicity"] == result.cyclicity
    assert result.facts["reason"] == result.reason == ""
    denoised = stltsa.denoise(model)
    assert [column.gamma for column in denoised.facts["column"]] == list(denoised.columns["gamma"])
    dimension = stltsa.dimension(circle, neighbors=110)
    assert dimension.model.facts["eigenvalue"] == tuple(dimension.eigenvalues)
    made = stltsa.synthesize([(clip, 0, 40), (clip, 40, 80)])
    assert [piece.end for piece in made.facts["piece"]] == [40, 80]
